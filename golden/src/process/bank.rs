//! The register bank: what threads keep of their queries, for the blocks to read.
//!
//! One thread's words are written in a cycle: a new query's first, else those that `final` writes, else those of `init`.
//! What is written in a cycle is read from the next one on.

use crate::stream::{HalfBuffer, Skid};
use crate::unit::Model;
use pointcore_contract::process::config::{Config, WORDS_MAX};
use pointcore_contract::process::queries::{Again, FinalInput, InitInput, Stores, Update, Wanted};
use pointcore_contract::process::records::{Gathered, KernelInput, Thread};
pub use pointcore_contract::process::stages::bank::{In, Out};
use pointcore_contract::process::{Section, Source, Store};

/// What is kept of a query.
#[derive(Clone, Debug)]
struct Kept {
    query: Vec<u32>,
    state: Vec<u32>,
    neighbors: u8,
    count: u16,
}

/// The register bank.
#[derive(Clone, Debug)]
pub struct Bank {
    config: Config,
    kept: Vec<Kept>,
    stores: Skid<Stores>,
    prepared: Option<Thread>,
    update: Skid<Update>,
    again: Option<Again>,
    reads: Reads,
    want: Lane<Wanted>,
    init: Lane<InitInput>,
    kernel: Lane<KernelInput>,
    /// The words of the thread of `sums` have been read.
    has_read: bool,
    finish: HalfBuffer<FinalInput>,
}

/// What the blocks read.
#[derive(Clone, Debug)]
struct Reads {
    init: Vec<Source>,
    kernel: Vec<Source>,
    finish: Vec<Source>,
}

/// What is read for a stream, and the queue behind.
#[derive(Clone, Debug)]
struct Lane<T> {
    read: Option<T>,
    queue: Skid<T>,
}

impl<T> Default for Lane<T> {
    fn default() -> Self {
        Self { read: None, queue: Skid::default() }
    }
}

impl<T: Copy> Lane<T> {
    fn advances(&self) -> bool {
        self.read.is_none() || self.queue.in_ready()
    }

    /// `item` is what is read in this cycle, if anything is taken.
    fn step(&mut self, item: Option<T>, out_ready: bool) {
        let advances = self.advances();
        self.queue.step(self.read.filter(|_| advances), out_ready);
        if advances {
            self.read = item;
        }
    }
}

impl Bank {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let program = &config.program;
        let kept =
            Kept { query: vec![0; program.query.len()], state: vec![0; program.state.len()], neighbors: 0, count: 0 };
        let [init, kernel, finish] = Section::ALL.map(|section| config.read_by(section));
        Self {
            kept: vec![kept; config.threads as usize],
            config: config.clone(),
            stores: Skid::default(),
            prepared: None,
            update: Skid::default(),
            again: None,
            reads: Reads { init, kernel, finish },
            want: Lane::default(),
            init: Lane::default(),
            kernel: Lane::default(),
            has_read: false,
            finish: HalfBuffer::default(),
        }
    }

    /// The words that a block reads of a thread.
    fn words<const N: usize>(&self, sources: &[Source], thread: Thread, neighbor: &[u32]) -> [u32; N] {
        let kept = &self.kept[usize::from(thread.thread)];
        let mut words = [0; N];
        for (word, source) in words.iter_mut().zip(sources) {
            *word = match *source {
                Source::Query(index) => kept.query[index],
                Source::State(index) => kept.state[index],
                Source::Neighbor(index) | Source::Farthest(index) => neighbor[index],
                Source::Neighbors => kept.neighbors.into(),
                Source::Count => kept.count.into(),
                Source::Sum(_) | Source::Setting(_) => unreachable!("the bank keeps neither sums nor settings"),
            };
        }
        words
    }

    fn gathered_ready(&self) -> bool {
        self.kernel.advances() && (!self.config.has_farthest() || self.init.advances())
    }

    /// What the lanes read in this cycle.
    fn read(&mut self, inputs: &In) {
        let wanted = inputs.want.filter(|_| self.want.advances()).map(|thread| {
            let query = &self.kept[usize::from(thread.thread)].query;
            Wanted { thread, position: [query[0], query[1], query[2]] }
        });
        let gathered = inputs.gathered.filter(|_| self.gathered_ready());
        let farthest = gathered.filter(|gathered| gathered.place.farthest);
        let prepare = inputs.prepare.filter(|_| self.init.advances());
        let prepare = prepare.map(|thread| (thread, [0; WORDS_MAX]));
        let farthest = farthest.map(|Gathered { place, neighbor }| (place.thread, neighbor.words));
        let init = prepare
            .or(farthest)
            .map(|(thread, neighbor)| InitInput { thread, words: self.words(&self.reads.init, thread, &neighbor) });
        let kernel = gathered.filter(|gathered| !gathered.place.farthest).map(|Gathered { place, neighbor }| {
            let words = self.words(&self.reads.kernel, place.thread, &neighbor.words);
            KernelInput { thread: place.thread, none: place.none, last: place.last, words }
        });
        let takes_sums = self.has_read && self.finish.in_ready();
        let finish = inputs.sums.filter(|_| takes_sums).map(|sums| FinalInput {
            thread: sums.thread,
            words: self.words(&self.reads.finish, sums.thread, &[]),
            partial: sums.partial,
        });
        self.has_read = inputs.sums.is_some() && !takes_sums;
        self.want.step(wanted, inputs.wanted_ready);
        self.init.step(init, inputs.init_ready);
        self.kernel.step(kernel, inputs.kernel_ready);
        self.finish.step(finish, inputs.finish_ready);
    }

    fn write(&mut self, inputs: &In) {
        (self.prepared, self.again) = (None, None);
        let update = self.update.out().copied().filter(|_| inputs.fresh.is_none());
        let stores = self.stores.out().copied().filter(|_| inputs.fresh.is_none() && update.is_none());
        self.update.step(inputs.update, update.is_some());
        self.stores.step(inputs.stores, stores.is_some());
        let program = self.config.program.clone();
        if let Some(fresh) = inputs.fresh {
            let kept = &mut self.kept[usize::from(fresh.thread.thread)];
            let words = kept.query.len();
            kept.query.copy_from_slice(&fresh.words.words[..words]);
            kept.state.fill(0);
            kept.count = 0;
        } else if let Some(Update { again, change, count }) = update {
            let kept = &mut self.kept[usize::from(again.thread.thread)];
            store(&mut kept.state, &program.block(Section::Final).results().stores, &change.state, &change.writes);
            if change.moves {
                kept.query[..3].copy_from_slice(&change.moved);
            }
            kept.count = count;
            self.again = Some(again);
        } else if let Some(Stores { thread, state, writes }) = stores {
            let kept = &mut self.kept[usize::from(thread.thread)];
            store(&mut kept.state, &program.block(Section::Init).results().stores, &state, &writes);
            self.prepared = Some(thread);
        }
        if let Some(listed) = inputs.listed {
            self.kept[usize::from(listed.thread.thread)].neighbors = listed.neighbors;
        }
    }
}

/// Writes those fields that are to be written; `words` has those of all, one after the other.
fn store(state: &mut [u32], stores: &[Store], mut words: &[u32], writes: &[bool]) {
    for (field, &is_written) in stores.iter().zip(writes) {
        let (own, others) = words.split_at(field.words.len());
        if is_written {
            state[field.first..field.first + own.len()].copy_from_slice(own);
        }
        words = others;
    }
}

impl Model for Bank {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            stores_ready: self.stores.in_ready(),
            prepared: self.prepared,
            update_ready: self.update.in_ready(),
            again: self.again,
            want_ready: self.want.advances(),
            wanted: self.want.queue.out().copied(),
            prepare_ready: self.init.advances(),
            gathered_ready: self.gathered_ready(),
            init: self.init.queue.out().copied(),
            kernel: self.kernel.queue.out().copied(),
            sums_ready: self.has_read && self.finish.in_ready(),
            finish: self.finish.out().copied(),
        }
    }

    fn clock(&mut self, inputs: &In) {
        self.read(inputs);
        self.write(inputs);
    }
}
