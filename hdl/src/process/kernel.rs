//! Neighbors and their sums: the block `kernel` once a neighbor, and what it adds (thesis 6.5.4); golden twin:
//! `pointcore_golden::process::kernel`.
//!
//! Partial sums lie in look-up tables, two banks of eight words. A word is read as its neighbor enters the adders, and
//! written as it leaves them; eight neighbors later it is read again.

use pointcore_contract::process::config::{BLOCK_WORDS_MAX, WORDS_MAX};
use pointcore_contract::process::records::{KernelInput, Settings, Sums, Thread};
use pointcore_contract::process::units::kernel::PORTS;
use pointcore_contract::process::{Config, PARTIAL_SUMS, Scalar, Section, Source};
use pointcore_contract::{record, width};

use super::program;
use crate::compiler::{CompileError, Datapath, Manifest, Options, Program, compile};
use crate::stream::fifo_distributed;
use crate::units::passage::Passage;
use crate::units::ports::{Flow, InputPorts, StreamInPorts, StreamOutPorts};
use crate::units::queue::Pushed;
use crate::units::values::{Terms, Values};
use crate::units::wires::{Bundle, Wires, layout};
use rtl::{Expr, Memory, Module, Reg, Wire, bit, cat, lit};

/// Bits of the number of a partial sum.
const PARTIAL_BITS: u32 = PARTIAL_SUMS.ilog2();

/// The unit's module and what the compiler decided about its datapaths.
pub struct Kernel {
    /// The module, `process_kernel`.
    pub module: Module,
    /// Of the block.
    pub kernel: Manifest,
    /// Of the sums' adders.
    pub sums: Manifest,
}

/// What the block reads besides settings.
#[record(config: Config)]
struct Operands {
    /// In the order of its ports.
    #[count(config.read_by(Section::Kernel).len())]
    #[name(config.word_read_by(Section::Kernel, i).name)]
    #[bits(config.word_bits(config.word_read_by(Section::Kernel, i).ty))]
    words: [u32; BLOCK_WORDS_MAX],
}

/// What the block gives.
#[record(config: Config)]
struct Addends {
    /// For each word of the sums.
    #[count(config.program.sums.len())]
    #[name(format!("sum_{}", config.program.sums.words()[i].name))]
    #[bits(config.word_bits(config.program.sums.words()[i].ty))]
    words: [u32; WORDS_MAX],
}

/// What of a neighbor goes round the block.
#[record(config: Config)]
struct Tag {
    /// Its query.
    thread: Thread,
    /// There is no neighbor.
    none: bool,
    /// The query's last one.
    last: bool,
}

/// A partial sum's place, and what comes of it.
#[record(config: Config)]
struct Place {
    /// The bank.
    bank: bool,
    /// The partial sum.
    #[bits(PARTIAL_BITS)]
    partial: u8,
    /// It is to stay as it is.
    none: bool,
    /// The query's last one.
    last: bool,
}

/// What is added.
#[record(config: Config)]
struct Addition {
    /// Where the sum goes.
    place: Place,
    /// The partial sums so far.
    #[count(config.program.sums.len())]
    #[name(format!("before_{}", config.program.sums.words()[i].name))]
    #[bits(config.word_bits(config.program.sums.words()[i].ty))]
    before: [u32; WORDS_MAX],
    /// What comes to them.
    addends: Addends,
}

/// What comes of it.
#[record(config: Config)]
struct Added {
    /// Where it goes.
    place: Place,
    /// The partial sums.
    #[count(config.program.sums.len())]
    #[name(config.program.sums.words()[i].name)]
    #[bits(config.word_bits(config.program.sums.words()[i].ty))]
    words: [u32; WORDS_MAX],
}

/// The adders, each for as many sums as there are cycles between neighbors. Partial sums are eight neighbors apart: where
/// an addition takes longer, neighbors do.
fn adders(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let mut interval = config.rate;
    loop {
        let program = Program::new("process_sums", "Adds to partial sums.");
        let Addition { place, before, addends } = Addition::<Values>::inputs(&program, config);
        let mut added = Added { place, ..Added::default() };
        for (index, word) in config.program.sums.words().into_iter().enumerate() {
            let (before, addend) = (before[index], addends.words[index]);
            added.words[index] = match word.ty {
                Scalar::Float => before.as_float(config.format) + addend.as_float(config.format),
                Scalar::Int | Scalar::Bool => (before + addend).resize(config.word_bits(word.ty)),
            };
        }
        added.outputs(&program, config);
        let datapath = compile(&program, &options.with_interval(interval))?;
        // The queue behind the pipeline, and the memory.
        let round = datapath.manifest.latency + 2;
        if round <= interval * PARTIAL_SUMS as u32 {
            return Ok(datapath);
        }
        interval += 1;
    }
}

/// The banks of partial sums.
struct Banks {
    words: Memory,
    /// By bank: it belongs to a query, and all of it is there.
    taken: Reg,
    complete: Reg,
    /// By bank: its query, and how many of its partial sums there are.
    threads: [Reg; 2],
    present: [Reg; 2],
}

impl Banks {
    fn new(m: &mut Module, config: &Config) -> Self {
        let [taken, complete] = ["taken", "complete"].map(|name| m.reg_reset(name, 2, 0));
        Self {
            words: m.memory_distributed("partial_sums", 2 * PARTIAL_SUMS as u32, width::<Addends>(config)),
            taken,
            complete,
            threads: [0, 1].map(|bank| m.reg(&format!("thread_{bank}"), config.thread_bits())),
            present: [0, 1].map(|bank| m.reg(&format!("present_{bank}"), PARTIAL_BITS + 1)),
        }
    }
}

/// Where the next neighbor is added.
struct Adding {
    bank: Reg,
    count: Reg,
    /// All partial sums have begun.
    round: Reg,
}

impl Adding {
    fn new(m: &mut Module) -> Self {
        Self {
            bank: m.reg_reset("adding", 1, 0),
            count: m.reg_reset("count", PARTIAL_BITS, 0),
            round: m.reg_reset("round", 1, 0),
        }
    }

    /// What is added to which partial sum, and takes the bank; `adds` where it is.
    fn add(
        &self,
        m: &mut Module,
        config: &Config,
        banks: &Banks,
        adds: Expr,
        tag: Tag<Wires>,
        addends: Addends<Wires>,
    ) -> Addition<Wires> {
        let Self { bank, count, round } = *self;
        let before = m.read_now(banks.words, "former_words", cat([bank.expr(), count.expr()]));
        let before = Addends::<Wires>::unpack(config, before);
        let before = Addends::choose(config, round.expr(), before, Addends::zeros(config));
        let next = m.wire("next_count", count.zext(PARTIAL_BITS + 1).add_lit(1));
        m.next_if(count, adds, tag.last.mux(lit(PARTIAL_BITS, 0), next.trunc(PARTIAL_BITS)));
        m.next_if(round, adds, !tag.last & (round.expr() | next.msb()));
        m.next_if(bank, adds & tag.last, !bank.expr());
        let present = round.mux(lit(PARTIAL_BITS + 1, PARTIAL_SUMS as u128), next);
        let present = tag.none.mux(lit(PARTIAL_BITS + 1, 0), present);
        for (which, (thread, of_bank)) in
            [!bank.expr(), bank.expr()].into_iter().zip(banks.threads.iter().zip(&banks.present))
        {
            m.next_if(*thread, adds & which, tag.thread.thread);
            m.next_if(*of_bank, adds & which, present);
        }
        let place = Place { bank: bank.expr(), partial: count.expr(), none: tag.none, last: tag.last };
        Addition { place, before: before.words, addends }
    }
}

/// Takes the partial sums of one bank after the other to where all of them are shown; returns the bank that is free again.
fn leave(m: &mut Module, config: &Config, banks: &Banks) -> Expr {
    let bank = m.reg_reset("leaving", 1, 0);
    let partial = m.reg_reset("left", PARTIAL_BITS, 0);
    let shown = m.reg_reset("shown", 1, 0);
    let pick = |of: Expr| bank.mux(of.bit(1), of.bit(0));
    let leaves = m.wire("leaves", pick(banks.complete.expr()) & !shown.expr());
    let ends = m.wire("bank_ends", leaves & partial.all());
    m.next_if(partial, leaves, partial.add_lit(1));
    m.next_if(bank, ends, !bank.expr());
    let thread = m.reg("shown_thread", config.thread_bits());
    m.next_if(thread, ends, bank.mux(banks.threads[1], banks.threads[0]));
    let present = bank.mux(banks.present[1], banks.present[0]);
    let words = m.read_now(banks.words, "leaving_words", cat([bank.expr(), partial.expr()]));
    let is_there = m.wire("is_there", partial.zext(PARTIAL_BITS + 1).lt(present));
    let words =
        Addends::choose(config, is_there, Addends::<Wires>::unpack(config, words), Addends::zeros(config)).words;
    let mut sums = Sums { thread: Thread { thread: thread.expr() }, ..Sums::default() };
    for (word, described) in config.program.sums.words().iter().enumerate() {
        // The first one comes first and has the longest way.
        let mut next = words[word];
        for place in (0..PARTIAL_SUMS).rev() {
            let register = m.reg(&format!("{}_{place}", described.name), next.width());
            m.next_if(register, leaves, next);
            next = register.expr();
            sums.partial[word][place] = next;
        }
    }
    let ready = PORTS.sums.drive(m, config, shown, sums);
    m.next(shown, ends | (shown.expr() & !ready));
    cat([bank.expr() & ends, !bank.expr() & ends])
}

/// Leads the settings that a block reads to its data path.
pub(super) fn set(
    m: &mut Module,
    config: &Config,
    datapath: rtl::Instance,
    section: Section,
    settings: &Settings<Wires>,
) {
    for source in config.program.block(section).sources() {
        if let Source::Setting(word) = source {
            m.connect(datapath, &config.program.word(source).name, settings.words[word]);
        }
    }
}

/// Neighbors that come out of the block, with what went round it.
fn block(
    m: &mut Module,
    config: &Config,
    Datapath { module, manifest }: Datapath,
    taken: Wire,
) -> (Flow<Tag<Wires>>, Addends<Wires>, Manifest) {
    let settings = PORTS.settings.declare(m, config);
    let head = PORTS.neighbor.queue(m, config);
    // As many as can be under way in the block, and in the queue itself.
    let depth = manifest.latency.div_ceil(manifest.initiation_interval) + 5;
    let (tags, tag) = Pushed::<Tag>::place(m, config, "tags", fifo_distributed(depth, &layout::<Tag>(config)));
    let block = Passage::<Operands, Addends>::place(m, "block", module);
    set(m, config, block.instance(), Section::Kernel, &settings);
    let room = block.room(m);
    m.drive(head.ready, room);
    let enters = m.wire("enters", head.valid & room);
    m.assert("tags_have_room", !enters | tags.room);
    let KernelInput { thread, none, last, words } = head.record;
    tags.push(m, config, enters, Tag { thread, none, last });
    block.push(m, config, head.valid, Operands { words });
    let out = block.out(m, config);
    m.drive(out.ready, taken);
    m.assert("a_neighbor_has_its_tag", !out.valid | tag.valid);
    (Flow { valid: out.valid, ready: tag.ready, record: tag.record }, out.record, manifest)
}

/// The unit.
///
/// # Errors
/// What the compiler rejects.
pub fn unit(config: &Config, options: &Options) -> Result<Kernel, CompileError> {
    let mut m = Module::new("process_kernel", "Goes through neighbors and keeps their sums.");
    m.parameter("rate", config.rate);
    let datapath = program::datapath(&config.program, Section::Kernel, config.format, config.rate, options)?;
    let Datapath { module: adders, manifest: sums } = adders(config, options)?;
    let adders = Passage::<Addition, Added>::place(&mut m, "sums", adders);
    let accepts = adders.room(&mut m);
    let banks = Banks::new(&mut m, config);
    let adding = Adding::new(&mut m);

    let taken = m.forward("neighbor_taken", 1);
    let (tag, addends, kernel) = block(&mut m, config, datapath, taken);
    let begins = m.wire("begins", adding.count.is_zero() & !adding.round.expr());
    let is_taken = adding.bank.mux(banks.taken.bit(1), banks.taken.bit(0));
    let adds = m.wire("adds", tag.valid & (accepts & !(begins & is_taken)));
    m.drive(taken, adds);
    m.drive(tag.ready, adds);
    let offers = m.wire("offers", tag.valid & !(begins & is_taken));
    let addition = adding.add(&mut m, config, &banks, adds, tag.record, addends);
    adders.push(&mut m, config, offers, addition);

    let added = adders.out(&mut m, config);
    m.drive(added.ready, bit(true));
    let Added { place, words } = added.record;
    let address = cat([place.bank, place.partial]);
    m.write(banks.words, added.valid & !place.none, address, Addends { words }.pack(config));
    let free = leave(&mut m, config, &banks);
    let of = |bank: Expr, happens: Expr| cat([bank & happens, !bank & happens]);
    m.next(banks.taken, (banks.taken.expr() & !free) | of(adding.bank.expr(), adds));
    m.next(banks.complete, (banks.complete.expr() & !free) | of(place.bank, added.valid & place.last));
    Ok(Kernel { module: m, kernel, sums })
}
