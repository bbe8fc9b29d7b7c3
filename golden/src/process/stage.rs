//! The blocks `init` and `final` as units: a thread's words in, what is written of it out.

use super::block::Blocks;
use crate::datapath::{Datapath, Token};
use crate::unit::Model;
use pointcore_contract::process::config::{Config, WORDS_MAX};
use pointcore_contract::process::queries::{Change, FinalInput, Finished, InitInput, OutputWords, Stores};
use pointcore_contract::process::stages::{finish, init};
use pointcore_contract::process::{PARTIAL_SUMS, Section, Source};

/// Queries that have gone through a block in the time that `kernel` takes for a neighbor, at most: an eighth.
const NEIGHBORS: u32 = PARTIAL_SUMS as u32;

/// A block with its timing.
#[derive(Clone, Debug)]
struct Stage<T> {
    config: Config,
    blocks: Blocks,
    section: Section,
    datapath: Datapath<T>,
}

impl<T> Stage<T> {
    fn new(config: &Config, section: Section, latency: u32) -> Self {
        let blocks = Blocks::new((*config.program).clone(), config.format);
        let datapath = Datapath::new(latency, NEIGHBORS * config.rate);
        Self { config: config.clone(), blocks, section, datapath }
    }

    /// The results of the block in the order of [`pointcore_contract::process::Program::results`].
    fn results(&self, words: &[u32], settings: &[u32], partial: &[[u32; PARTIAL_SUMS]; WORDS_MAX]) -> Vec<u32> {
        let read = self.config.read_by(self.section);
        let read_settings = self.config.settings_read_by(self.section);
        let ports = self.config.program.inputs(self.section).into_iter();
        let word = |sources: &[Source], source| {
            sources.iter().position(|&other| other == source).expect("a block's words are those that it reads")
        };
        let inputs: Vec<u32> = ports
            .map(|port| match port.source {
                Source::Sum(index) => partial[index][port.partial],
                Source::Setting(index) => {
                    let place = read_settings.iter().position(|&other| other == index);
                    settings[place.expect("a block's settings are those that it reads")]
                }
                source => words[word(&read, source)],
            })
            .collect();
        self.blocks.step(self.section, &inputs)
    }

    /// The first so many results, behind which the others are left.
    fn take<const N: usize>(results: &mut std::vec::IntoIter<u32>, count: usize) -> [u32; N] {
        let mut words = [0; N];
        words.iter_mut().zip(results.by_ref().take(count)).for_each(|(word, result)| *word = result);
        words
    }
}

/// `init` of a program.
#[derive(Clone, Debug)]
pub struct Init(Stage<Stores>);

impl Init {
    /// The unit with a pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self(Stage::new(config, Section::Init, latency))
    }

    fn stores(&self, input: &InitInput, settings: &[u32]) -> Stores {
        let stage = &self.0;
        let mut results = stage.results(&input.words, settings, &[[0; PARTIAL_SUMS]; WORDS_MAX]).into_iter();
        let state = Stage::<Stores>::take(&mut results, stage.config.stored_by(Section::Init).len());
        let writes = Stage::<Stores>::take(&mut results, WORDS_MAX).map(|flag: u32| flag == 1);
        Stores { thread: input.thread, state, writes }
    }
}

impl Model for Init {
    type Config = Config;
    type In = init::In;
    type Out = init::Out;

    fn outputs(&self) -> init::Out {
        init::Out { in_ready: self.0.datapath.in_ready(), output: self.0.datapath.out().copied() }
    }

    fn clock(&mut self, inputs: &init::In) {
        let input = inputs.input.filter(|_| self.0.datapath.in_ready());
        let stores = input.map(|input| self.stores(&input, &inputs.settings.words));
        self.0.datapath.step(stores.map(Token::Kept), inputs.out_ready);
    }
}

/// `final` of a program.
#[derive(Clone, Debug)]
pub struct Finish(Stage<Finished>);

impl Finish {
    /// The unit with a pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self(Stage::new(config, Section::Final, latency))
    }

    fn finished(&self, input: &FinalInput, settings: &[u32]) -> Finished {
        let stage = &self.0;
        let config = &stage.config;
        let stores = &config.program.block(Section::Final).results().stores;
        let mut results = stage.results(&input.words, settings, &input.partial).into_iter();
        let outputs = Stage::<Finished>::take(&mut results, config.program.outputs.len());
        let state = Stage::<Finished>::take(&mut results, config.stored_by(Section::Final).len());
        let moved = Stage::<Finished>::take(&mut results, if config.has_movement() { 3 } else { 0 });
        let writes = Stage::<Finished>::take(&mut results, stores.len()).map(|flag: u32| flag == 1);
        let mut flag = |is_there| is_there && results.next() == Some(1);
        let moves = flag(config.has_movement());
        let done = flag(true);
        let search = flag(config.has_search());
        let change = Change { state, writes, moved, moves };
        Finished { thread: input.thread, outputs: OutputWords { words: outputs }, change, done, search }
    }
}

impl Model for Finish {
    type Config = Config;
    type In = finish::In;
    type Out = finish::Out;

    fn outputs(&self) -> finish::Out {
        finish::Out { in_ready: self.0.datapath.in_ready(), output: self.0.datapath.out().copied() }
    }

    fn clock(&mut self, inputs: &finish::In) {
        let input = inputs.input.filter(|_| self.0.datapath.in_ready());
        let finished = input.map(|input| self.finished(&input, &inputs.settings.words));
        self.0.datapath.step(finished.map(Token::Kept), inputs.out_ready);
    }
}
