//! Neighbors and their sums: the block `kernel` once a neighbor, and what it adds (thesis 6.5.4).
//!
//! Neighbor `i` of a query goes to partial sum `i mod 8` of each sum, which begins as +0. Two banks of partial sums take
//! turns: the sums of a query wait in theirs until they have left, while the next query's neighbors are added.

use super::block::Blocks;
use crate::datapath::Datapath;
use crate::stream::Skid;
use crate::unit::Model;
use pointcore_contract::process::config::WORDS_MAX;
use pointcore_contract::process::records::{KernelInput, Settings, Sums, Thread};
pub use pointcore_contract::process::units::kernel::{In, Out};
use pointcore_contract::process::{Config, PARTIAL_SUMS, Scalar, Section, Source};

/// Banks of partial sums.
const BANKS: usize = 2;

/// A compiled pipeline, from the manifest that the generator writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pipeline {
    /// Stages.
    pub latency: u32,
    /// Cycles from one token to the next.
    pub interval: u32,
}

/// The unit's pipelines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KernelPipelines {
    /// Of the block `kernel`.
    pub kernel: Pipeline,
    /// Of the sums' adders.
    pub sums: Pipeline,
}

/// What of a neighbor goes to the sums.
#[derive(Clone, Copy, Debug)]
struct Addends {
    thread: Thread,
    none: bool,
    last: bool,
    words: [u32; WORDS_MAX],
}

/// A neighbor's partial sums.
#[derive(Clone, Copy, Debug)]
struct Added {
    bank: usize,
    partial: usize,
    none: bool,
    last: bool,
    words: [u32; WORDS_MAX],
}

/// The partial sums of a query.
#[derive(Clone, Copy, Debug, Default)]
struct Bank {
    partial: [[u32; WORDS_MAX]; PARTIAL_SUMS],
    thread: Thread,
    /// It belongs to a query.
    taken: bool,
    /// Partial sums that it has.
    present: usize,
    /// All neighbors are added.
    complete: bool,
}

/// The unit.
#[derive(Clone, Debug)]
pub struct Kernel {
    blocks: Blocks,
    /// Types of the sums' words.
    sums: Vec<Scalar>,
    neighbor: Skid<KernelInput>,
    kernel: Datapath<Addends>,
    adders: Datapath<Added>,
    banks: [Bank; BANKS],
    /// The bank that is added to, and the neighbors of its query so far.
    adding: usize,
    count: usize,
    /// The bank that leaves, and the partial sums of it that have left.
    leaving: usize,
    left: usize,
    /// What has left so far, and whether that is all.
    out: Sums,
    is_out: bool,
}

impl Kernel {
    /// The unit after reset, with pipelines of the given lengths.
    #[must_use]
    pub fn new(config: &Config, pipelines: KernelPipelines) -> Self {
        let program = (*config.program).clone();
        Self {
            sums: program.sums.words().into_iter().map(|word| word.ty).collect(),
            blocks: Blocks::new(program, config.format),
            neighbor: Skid::default(),
            kernel: Datapath::new(pipelines.kernel.latency, pipelines.kernel.interval),
            adders: Datapath::new(pipelines.sums.latency, pipelines.sums.interval),
            banks: [Bank::default(); BANKS],
            adding: 0,
            count: 0,
            leaving: 0,
            left: 0,
            out: Sums::default(),
            is_out: false,
        }
    }

    /// What a neighbor adds.
    fn addends(&self, input: &KernelInput, settings: &Settings) -> Addends {
        let KernelInput { thread, none, last, words } = *input;
        let mut read = words.into_iter();
        let ports = self.blocks.program().inputs(Section::Kernel);
        let inputs: Vec<u32> = ports
            .iter()
            .map(|port| match port.source {
                Source::Setting(word) => settings.words[word],
                _ => read.next().expect("a block reads no more words than there may be"),
            })
            .collect();
        let mut words = [0; WORDS_MAX];
        words.iter_mut().zip(self.blocks.step(Section::Kernel, &inputs)).for_each(|(word, addend)| *word = addend);
        Addends { thread, none, last, words }
    }

    /// Adds what a neighbor brings to the bank as it is, if the bank is its query's.
    fn add(&mut self, addends: &Addends) -> Option<Added> {
        let Addends { thread, none, last, mut words } = *addends;
        let (bank, partial) = (self.adding, self.count % PARTIAL_SUMS);
        if self.count == 0 && self.banks[bank].taken {
            return None;
        }
        let before = if self.count < PARTIAL_SUMS { [0; WORDS_MAX] } else { self.banks[bank].partial[partial] };
        for ((word, before), &ty) in words.iter_mut().zip(before).zip(&self.sums) {
            *word = self.blocks.add(ty, before, *word);
        }
        self.count += 1;
        let Bank { taken, thread: of_bank, present, .. } = &mut self.banks[bank];
        (*taken, *of_bank) = (true, thread);
        *present = if none { 0 } else { self.count.min(PARTIAL_SUMS) };
        if last {
            self.count = 0;
            self.adding = (bank + 1) % BANKS;
        }
        Some(Added { bank, partial, none, last, words })
    }

    /// A partial sum of the bank that leaves goes where all of them are shown together.
    fn leave(&mut self, is_taken: bool) {
        let Bank { partial, thread, present, complete, .. } = self.banks[self.leaving];
        if self.is_out {
            self.is_out = !is_taken;
            return;
        }
        if !complete {
            return;
        }
        let at = self.left;
        self.out.thread = thread;
        for (sums, word) in self.out.partial[..self.sums.len()].iter_mut().zip(partial[at]) {
            sums[at] = if at < present { word } else { 0 };
        }
        self.left = (at + 1) % PARTIAL_SUMS;
        if self.left == 0 {
            self.is_out = true;
            let bank = &mut self.banks[self.leaving];
            (bank.taken, bank.complete) = (false, false);
            self.leaving = (self.leaving + 1) % BANKS;
        }
    }
}

impl Model for Kernel {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { neighbor_ready: self.neighbor.in_ready(), sums: self.is_out.then_some(self.out) }
    }

    fn clock(&mut self, inputs: &In) {
        let added = self.adders.out().copied();
        let addends = self.kernel.out().copied().filter(|_| self.adders.in_ready());
        let adds = addends.and_then(|addends| self.add(&addends));
        let entering = self.neighbor.out().copied().filter(|_| self.kernel.in_ready());
        let accepted = entering.map(|input| self.addends(&input, &inputs.settings));
        self.kernel.step(accepted, adds.is_some());
        self.adders.step(adds, true);
        self.leave(inputs.sums_ready);
        if let Some(Added { bank, partial, none, last, words }) = added {
            if !none {
                self.banks[bank].partial[partial] = words;
            }
            self.banks[bank].complete |= last;
        }
        self.neighbor.step(inputs.neighbor, entering.is_some());
    }
}
