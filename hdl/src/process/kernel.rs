//! Neighbors and their sums: the block `kernel` once a neighbor, and what it adds (thesis 6.5.4); golden twin:
//! `pointcore_golden::process::kernel`.
//!
//! A partial sum is read as its neighbor enters the adders, and written as it leaves them; eight neighbors later it is
//! read again.

use pointcore_contract::process::config::{BLOCK_WORDS_MAX, WORDS_MAX};
use pointcore_contract::process::records::{KernelInput, Settings, Thread};
use pointcore_contract::process::units::kernel::PORTS;
use pointcore_contract::process::{Config, PARTIAL_SUMS, Scalar, Section, Source};
use pointcore_contract::record;

use super::partial_sums::{Addends, BANK_BITS, BANKS, Banks, PARTIAL_BITS, Place};
use super::program;
use crate::compiler::{CompileError, Datapath, Manifest, Options, Program, compile};
use crate::search::parts::sets::{contains, decode};
use crate::stream::fifo_distributed;
use crate::units::passage::Passage;
use crate::units::ports::{Flow, InputPorts, StreamInPorts};
use crate::units::queue::Pushed;
use crate::units::values::{Terms, Values};
use crate::units::wires::{Bundle, Wires, layout};
use rtl::{Expr, Module, Reg, Wire, bit, lit};

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
        let datapath = compile(&program, &options.with_interval(interval).taken_at_once())?;
        // The register behind the pipeline, and the memory.
        let round = datapath.manifest.latency + 2;
        if round <= interval * PARTIAL_SUMS as u32 {
            return Ok(datapath);
        }
        interval += 1;
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
            bank: m.reg_reset("adding", BANK_BITS, 0),
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
        let before = banks.former(m, config, bank.expr(), count.expr());
        let before = Addends::choose(config, round.expr(), before, Addends::zeros(config));
        let next = m.wire("next_count", count.zext(PARTIAL_BITS + 1).add_lit(1));
        m.next_if(count, adds, tag.last.mux(lit(PARTIAL_BITS, 0), next.trunc(PARTIAL_BITS)));
        m.next_if(round, adds, !tag.last & (round.expr() | next.msb()));
        m.next_if(bank, adds & tag.last, bank.add_lit(1));
        let present = round.mux(lit(PARTIAL_BITS + 1, PARTIAL_SUMS as u128), next);
        let present = tag.none.mux(lit(PARTIAL_BITS + 1, 0), present);
        banks.take(m, adds, bank.expr(), tag.thread.thread, present);
        let place = Place { bank: bank.expr(), partial: count.expr(), none: tag.none, last: tag.last };
        Addition { place, before: before.words, addends }
    }
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
    let tags = fifo_distributed(manifest.tokens(), &layout::<Tag>(config));
    let (tags, tag) = Pushed::<Tag>::place(m, config, "tags", tags);
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
    let is_taken = contains(banks.taken, adding.bank);
    let adds = m.wire("adds", tag.valid & (accepts & !(begins & is_taken)));
    m.drive(taken, adds);
    m.drive(tag.ready, adds);
    let offers = m.wire("offers", tag.valid & !(begins & is_taken));
    let addition = adding.add(&mut m, config, &banks, adds, tag.record, addends);
    adders.push(&mut m, config, offers, addition);

    let added = adders.out(&mut m, config);
    m.drive(added.ready, bit(true));
    let Added { place, words } = added.record;
    banks.write(&mut m, config, added.valid, place, Addends { words });
    banks.leave(&mut m, config, decode(adds, adding.bank, BANKS), decode(added.valid & place.last, place.bank, BANKS));
    Ok(Kernel { module: m, kernel, sums })
}
