//! The pass through neighbors and its sums against their model, and against the sums of queries one by one.

use std::collections::VecDeque;
use std::sync::Arc;

use pointcore_contract::Format;
use pointcore_contract::process::library::{PROGRAMS, program};
use pointcore_contract::process::{Config, PARTIAL_SUMS, Section, Source, units};
use pointcore_golden::process::{Blocks, Kernel, KernelPipelines, Pipeline};
use pointcore_hdl::compiler::{Manifest, Options};
use pointcore_hdl::process::kernel;

use crate::search::environment::{Feeds, Rule};
use crate::search::{all, lockstep};

const QUERIES: u64 = 60;

fn config(name: &str, format: Format, rate: u32) -> Config {
    let program = Arc::new(program(name));
    Config { program, format, index_bits: 10, neighbors: 64, threads: 128, rate, line_points: 4, cache_lines: 64 }
}

const fn pipeline(manifest: &Manifest) -> Pipeline {
    Pipeline { latency: manifest.latency, interval: manifest.initiation_interval }
}

/// Queries of all numbers of neighbors.
#[derive(Clone)]
struct Queries {
    blocks: Blocks,
    settings: Vec<u64>,
    /// By query: its thread, and its partial sums of all sums.
    expected: VecDeque<Vec<u64>>,
}

impl Queries {
    fn word(&self, config: &Config, feeds: &mut Feeds) -> u64 {
        let number = 4.0 * feeds.random.f32() - 2.0;
        u64::from(number.to_bits() >> (f32::MANTISSA_DIGITS - 1 - config.format.mantissa))
    }

    /// A query with its neighbors; what comes of it is added as the interpreter adds.
    fn ask(&mut self, config: &Config, feeds: &mut Feeds) {
        let neighbors = [0, 1, 7, 8, 9, 16, 64][feeds.random.usize(..7)];
        let thread = feeds.random.u64(..u64::from(config.threads));
        let read = config.read_by(Section::Kernel).len();
        let sums = config.program.sums.words();
        let mut partial = vec![[0; PARTIAL_SUMS]; sums.len()];
        for index in 0..neighbors {
            let words: Vec<u64> = (0..read).map(|_| self.word(config, feeds)).collect();
            let mut next = words.iter();
            let ports = self.blocks.program().inputs(Section::Kernel);
            let inputs: Vec<u32> = ports
                .iter()
                .map(|port| match port.source {
                    Source::Setting(setting) => self.settings[setting] as u32,
                    _ => *next.next().expect("there is a word for each that is read") as u32,
                })
                .collect();
            let addends = self.blocks.step(Section::Kernel, &inputs);
            for ((partial, word), addend) in partial.iter_mut().zip(&sums).zip(addends) {
                let partial = &mut partial[index % PARTIAL_SUMS];
                *partial = self.blocks.add(word.ty, *partial, addend);
            }
            let last = u64::from(index + 1 == neighbors);
            feeds.feed("neighbor", [thread, 0, last].into_iter().chain(words).collect());
        }
        if neighbors == 0 {
            let words: Vec<u64> = (0..read).map(|_| self.word(config, feeds)).collect();
            feeds.feed("neighbor", [thread, 1, 1].into_iter().chain(words).collect());
        }
        let partial = partial.into_iter().flatten().map(u64::from);
        self.expected.push_back([thread].into_iter().chain(partial).collect());
    }
}

impl Rule for Queries {
    const SEEDS: u64 = 12;

    fn transferred(&mut self, _: &mut Feeds, stream: &str, fields: &[u64]) {
        if stream == "sums" {
            assert_eq!(Some(fields.to_vec()), self.expected.pop_front());
        }
    }
}

fn agrees(config: &Config) {
    let kernel::Kernel { module, kernel, sums } =
        kernel::unit(config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let model = Kernel::new(config, KernelPipelines { kernel: pipeline(&kernel), sums: pipeline(&sums) });
    let begin = |feeds: &mut Feeds| {
        let blocks = Blocks::new((*config.program).clone(), config.format);
        let mut queries = Queries { blocks, settings: vec![], expected: VecDeque::new() };
        for word in config.program.settings.words() {
            let value = queries.word(config, feeds);
            feeds.hold(&format!("setting_{}", word.name), value);
            queries.settings.push(value);
        }
        (0..QUERIES).for_each(|_| queries.ask(config, feeds));
        queries
    };
    lockstep(config, &module, &model, &units::kernel::UNIT, begin, all, |queries, report| {
        assert!(queries.expected.is_empty());
        assert_eq!(report.transfers("sums"), QUERIES);
    });
}

#[test]
fn sums_are_those_of_the_model_and_of_each_query_alone() {
    for (index, (name, _)) in PROGRAMS.iter().enumerate() {
        let format = [Format::F32.flushed(), Format::F24.flushed()][index % 2];
        agrees(&config(name, format, 1 + index as u32 % 3));
    }
}
