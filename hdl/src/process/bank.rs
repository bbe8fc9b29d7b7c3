//! The register bank (thesis 6.5.4): words of queries by thread, a copy of each for each block that reads it; golden
//! twin: `pointcore_golden::process::bank`.

use crate::units::ports::{Pulse, PulseInPorts, PulseOutPorts, QueueOut, StreamInPorts, StreamOutPorts, held};
use crate::units::wires::{Bundle, Wires};
use pointcore_contract::Record;
use pointcore_contract::process::config::{BLOCK_WORDS_MAX, Config, ITERATION_BITS};
use pointcore_contract::process::queries::{Change, FinalInput, Fresh, InitInput, Listed, Stores, Update, Wanted};
use pointcore_contract::process::records::{Gathered, KernelInput, Neighbor, Sums, Thread};
use pointcore_contract::process::stages::bank::PORTS;
use pointcore_contract::process::{Section, Source};
use rtl::{Expr, Module, Reg, lit};

/// What a memory takes in this cycle.
#[derive(Clone, Copy)]
struct Write {
    enable: Expr,
    thread: Expr,
    data: Expr,
}

/// What is written in a cycle: of one thread, but for the numbers of neighbors.
struct Writes<'a> {
    config: &'a Config,
    fresh: Pulse<Fresh<Wires>>,
    listed: Pulse<Listed<Wires>>,
    /// `final` writes, and what.
    updates: Expr,
    change: Change<Wires>,
    count: Expr,
    /// `init` writes, and what.
    stores: Option<(Expr, Stores<Wires>)>,
    /// Whose words.
    thread: Expr,
}

impl<'a> Writes<'a> {
    /// A new query's words have the way, then those that `final` writes, then those of `init`.
    fn new(m: &mut Module, config: &'a Config) -> Self {
        let fresh = PORTS.fresh.declare(m, config);
        let listed = PORTS.listed.declare(m, config);
        let update = PORTS.update.queue(m, config);
        m.drive(update.ready, !fresh.valid);
        let updates = m.wire("updates", update.transfer());
        let Update { again, change, count } = update.record;
        PORTS.again.registered(m, config, updates, again);
        let mut thread = fresh.valid.mux(fresh.record.thread.thread, again.thread.thread);
        let stores = config.has_init().then(|| {
            let stores = PORTS.stores.queue(m, config);
            m.drive(stores.ready, !(fresh.valid | update.valid));
            let stored = m.wire("stored", stores.transfer());
            PORTS.prepared.registered(m, config, stored, stores.record.thread);
            thread = (fresh.valid | update.valid).mux(thread, stores.record.thread.thread);
            (stored, stores.record)
        });
        let thread = m.wire("written_thread", thread);
        Self { config, fresh, listed, updates, change, count, stores, thread }
    }

    /// The word of a block's stores that is written to a word of the state, and when.
    fn stored(&self, section: Section, word: usize, (state, writes): (&[Expr], &[Expr])) -> Option<(Expr, Expr)> {
        let place = self.config.stored_by(section).iter().position(|&stored| stored == word)?;
        let stores = &self.config.program.block(section).results().stores;
        let field = stores.iter().position(|store| (store.first..store.first + store.words.len()).contains(&word))?;
        Some((writes[field], state[place]))
    }

    /// What a copy of the word takes.
    fn of(&self, source: Source, width: u32) -> Write {
        let Self { fresh, listed, change, .. } = self;
        let write = |enable, data| Write { enable, thread: self.thread, data };
        match source {
            Source::Query(word) if word < change.moved.len() && self.config.has_movement() => {
                let data = fresh.valid.mux(fresh.record.words.words[word], change.moved[word]);
                write(fresh.valid | (self.updates & change.moves), data)
            }
            Source::Query(word) => write(fresh.valid, fresh.record.words.words[word]),
            Source::State(word) => {
                let (mut enable, mut data) = (fresh.valid, lit(width, 0));
                if let Some((is_written, value)) = self.stored(Section::Final, word, (&change.state, &change.writes)) {
                    enable = enable | (self.updates & is_written);
                    data = self.updates.mux(value, data);
                }
                if let Some((happens, stores)) = &self.stores
                    && let Some((is_written, value)) = self.stored(Section::Init, word, (&stores.state, &stores.writes))
                {
                    enable = enable | (*happens & is_written);
                    data = happens.mux(value, data);
                }
                write(enable, data)
            }
            Source::Count => write(fresh.valid | self.updates, fresh.valid.mux(lit(ITERATION_BITS, 0), self.count)),
            Source::Neighbors => {
                Write { enable: listed.valid, thread: listed.record.thread.thread, data: listed.record.neighbors }
            }
            other => unreachable!("the bank keeps no {other:?}"),
        }
    }

    /// A block's copies of the words that it reads: those of `thread` a cycle after `enable`. A neighbor's words are
    /// those beside.
    fn read(
        &self,
        m: &mut Module,
        reader: &str,
        sources: &[Source],
        (enable, thread): (Expr, Expr),
        neighbor: Option<Neighbor<Wires>>,
    ) -> [Expr; BLOCK_WORDS_MAX] {
        let config = self.config;
        let mut words = [Expr::default(); BLOCK_WORDS_MAX];
        for (value, &source) in words.iter_mut().zip(sources) {
            let word = config.program.word(source);
            if let Source::Neighbor(index) | Source::Farthest(index) = source {
                let neighbor = neighbor.expect("a block that reads a neighbor has one");
                *value = held(m, &format!("{reader}_read_{}", word.name), enable, neighbor.words[index]);
                continue;
            }
            let width = config.word_bits(word.ty);
            let write = self.of(source, width);
            let kept = write.data.width();
            let name = format!("{reader}_copy_{}", word.name);
            let memory = m.memory(&name, 1 << config.thread_bits(), kept);
            m.write(memory, write.enable, write.thread, write.data);
            *value = m.read_if(memory, &format!("{name}_read"), enable, thread).zext(width);
        }
        words
    }
}

/// A stage in which words are read, before a queue.
struct Lane {
    valid: Reg,
    /// It takes what comes next.
    advances: Expr,
}

impl Lane {
    /// A stage of that name before a queue.
    fn new<R: Record>(m: &mut Module, name: &str, queue: &QueueOut<R>) -> Self {
        let valid = m.reg_reset(&format!("reads_{name}"), 1, 0);
        let advances = m.wire(&format!("{name}_advances"), !valid | queue.room);
        Self { valid, advances }
    }

    /// States when something comes, to be called once.
    fn arrives(&self, m: &mut Module, arrives: Expr) {
        m.next_if(self.valid, self.advances, arrives);
    }
}

/// Positions that are searched around.
fn read_wanted(m: &mut Module, writes: &Writes) {
    let config = writes.config;
    let want = PORTS.want.declare(m, config);
    let wanted = PORTS.wanted.queue(m, config);
    let lane = Lane::new(m, "wanted", &wanted);
    m.drive(want.ready, lane.advances);
    lane.arrives(m, want.valid);
    let thread = want.record.register(m, config, "wanted_read_", lane.advances);
    let sources = [0, 1, 2].map(Source::Query);
    let words = writes.read(m, "wanted", &sources, (want.transfer(), want.record.thread), None);
    wanted.push(m, config, lane.valid & lane.advances, Wanted { thread, position: [words[0], words[1], words[2]] });
}

/// What `init` reads of a thread, with a neighbor where it looks at the farthest.
fn read_init(
    m: &mut Module,
    writes: &Writes,
    (lane, queue): (Lane, QueueOut<InitInput>),
    (arrives, thread): (Expr, Thread<Wires>),
    farthest: Option<Neighbor<Wires>>,
) {
    let config = writes.config;
    lane.arrives(m, arrives);
    let words = writes.read(m, "init", &config.read_by(Section::Init), (arrives, thread.thread), farthest);
    let thread = thread.register(m, config, "init_read_", lane.advances);
    queue.push(m, config, lane.valid & lane.advances, InitInput { thread, words });
}

/// Neighbors go to `kernel` with what it reads of their query, the farthest to `init`.
fn read_blocks(m: &mut Module, writes: &Writes) {
    let config = writes.config;
    let gathered = PORTS.gathered.declare(m, config);
    let kernel = PORTS.kernel.queue(m, config);
    let lane = Lane::new(m, "kernel", &kernel);
    let Gathered { place, neighbor } = gathered.record;
    let mut ready = lane.advances;
    if config.has_init() {
        let init = PORTS.init.queue(m, config);
        let lane = Lane::new(m, "init", &init);
        if config.has_farthest() {
            ready = ready & lane.advances;
            let arrives = m.wire("farthest_arrives", gathered.transfer() & place.farthest);
            read_init(m, writes, (lane, init), (arrives, place.thread), Some(neighbor));
        } else {
            let prepare = PORTS.prepare.declare(m, config);
            m.drive(prepare.ready, lane.advances);
            read_init(m, writes, (lane, init), (prepare.transfer(), prepare.record), None);
        }
    }
    m.drive(gathered.ready, ready);
    let arrives = m.wire("neighbor_arrives", gathered.transfer() & !place.farthest);
    lane.arrives(m, arrives);
    let words =
        writes.read(m, "kernel", &config.read_by(Section::Kernel), (arrives, place.thread.thread), Some(neighbor));
    let [thread, none, last] = [("thread", place.thread.thread), ("none", place.none), ("last", place.last)]
        .map(|(name, value)| held(m, &format!("kernel_read_{name}"), lane.advances, value));
    let input = KernelInput { thread: Thread { thread }, none, last, words };
    kernel.push(m, config, lane.valid & lane.advances, input);
}

/// Sums stay where they are until what `final` reads beside them is there: two cycles a query, of which there is one in
/// eight at most.
fn read_finish(m: &mut Module, writes: &Writes) {
    let config = writes.config;
    let sums = PORTS.sums.declare(m, config);
    let finish = PORTS.finish.half(m, config);
    let has_read = m.reg_reset("finish_read", 1, 0);
    m.drive(sums.ready, has_read & finish.room);
    let take = m.wire("takes_sums", sums.transfer());
    m.next(has_read, sums.valid & !take);
    let Sums { thread, partial } = sums.record;
    let words = writes.read(m, "finish", &config.read_by(Section::Final), (sums.valid, thread.thread), None);
    finish.push(m, config, take, FinalInput { thread, words, partial });
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("process_bank", "Words of queries by thread, a copy of each for each block that reads it.");
    m.parameter("threads", config.threads);
    let writes = Writes::new(&mut m, config);
    read_wanted(&mut m, &writes);
    read_blocks(&mut m, &writes);
    read_finish(&mut m, &writes);
    m
}
