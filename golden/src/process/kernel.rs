//! Neighbors and their sums: the block `kernel` once a neighbor, and what it adds (thesis 6.5.4).
//!
//! Neighbor `i` of a query goes to partial sum `i mod 8` of each sum, which begins as +0. Banks of partial sums take
//! turns: the sums of a query wait in theirs until they have left, while the next queries' neighbors are added.

use super::block::Blocks;
use crate::datapath::{Datapath, Token};
use crate::stream::Skid;
use crate::unit::Model;
use pointcore_contract::process::config::WORDS_MAX;
use pointcore_contract::process::records::{KernelInput, Settings, Sums, Thread};
pub use pointcore_contract::process::units::kernel::{In, Out};
use pointcore_contract::process::{Config, PARTIAL_SUMS, Scalar, Section, Source};

/// Banks of partial sums. A bank is held while its query's neighbors come, while the adders take the last one in, and
/// while the sums leave: for queries of eight neighbors three times as long as they take to come.
const BANKS: usize = 4;

/// Partial sums that leave a bank in a cycle: all of them, and the cycles in which they are shown, take fewer cycles
/// than eight neighbors.
const LEAVING: usize = 2;

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
            adders: Datapath::always_taken(pipelines.sums.latency, pipelines.sums.interval),
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

    /// Partial sums of the bank that leaves go where all of them are shown together.
    fn leave(&mut self, is_taken: bool) {
        let Bank { partial, thread, present, complete, .. } = self.banks[self.leaving];
        if self.is_out {
            self.is_out = !is_taken;
            return;
        }
        if !complete {
            return;
        }
        self.out.thread = thread;
        for at in self.left..self.left + LEAVING {
            for (sums, word) in self.out.partial[..self.sums.len()].iter_mut().zip(partial[at]) {
                sums[at] = if at < present { word } else { 0 };
            }
        }
        self.left = (self.left + LEAVING) % PARTIAL_SUMS;
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
        self.kernel.step(accepted.map(Token::Kept), adds.is_some());
        self.adders.step(adds.map(Token::Kept), true);
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

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::Format;
    use pointcore_contract::process::library::program;
    use std::sync::Arc;

    const QUERIES: u32 = 60;
    /// Queries whose sums leave while the pipelines fill.
    const MARGIN: u32 = 20;
    /// `process_bank` takes sums in the second cycle in which they are shown.
    const SHOWN: u32 = 2;

    /// Cycles a query, of queries of so many neighbors that are always there.
    fn cycles(rate: u32, sums: u32, neighbors: u32) -> f64 {
        let config = Config {
            program: Arc::new(program("mls")),
            format: Format::F32.flushed(),
            index_bits: 10,
            neighbors: 64,
            threads: 64,
            rate,
            line_points: 4,
            cache_lines: 16,
        };
        let pipelines = [40, sums].map(|latency| Pipeline { latency, interval: rate });
        let mut unit = Kernel::new(&config, KernelPipelines { kernel: pipelines[0], sums: pipelines[1] });
        let (mut sent, mut left, mut shown, mut first, mut last, mut now) = (0, 0, 0, 0, 0, 0_u32);
        while left < QUERIES {
            let out = unit.outputs();
            let last_one = sent % neighbors + 1 == neighbors;
            let neighbor = KernelInput { last: last_one, ..KernelInput::default() };
            shown = if out.sums.is_some() { shown + 1 } else { 0 };
            let sums_ready = shown >= SHOWN;
            unit.clock(&In { neighbor: Some(neighbor), sums_ready, ..In::default() });
            sent += u32::from(out.neighbor_ready);
            if sums_ready {
                first = if left == MARGIN { now } else { first };
                last = now;
                left += 1;
            }
            now += 1;
            assert!(now < 100_000, "it stands still after {left} queries");
        }
        f64::from(last - first) / f64::from(QUERIES - 1 - MARGIN)
    }

    #[test]
    fn neighbors_are_taken_at_the_rate_across_queries() {
        // The longest adders that are ready for a partial sum again when its next neighbor comes.
        for (rate, sums) in [(1, 6), (1, 4), (2, 14), (3, 22)] {
            for neighbors in [8, 9, 11, 16, 64] {
                assert_eq!(cycles(rate, sums, neighbors), f64::from(rate * neighbors), "{rate} {sums} {neighbors}");
            }
        }
    }
}
