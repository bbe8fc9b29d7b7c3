//! Threads and their blocks against their model in every cycle, and each query against the interpreter: every program
//! of the library, with models of searching, gathering and `kernel` that take their time. What leaves with sums that no neighbors
//! have is not asked of the interpreter.

use std::cell::RefCell;

use pointcore_contract::process::records::Sums;
use pointcore_contract::process::{Config, PARTIAL_SUMS, Scalar, Section, stages};
use pointcore_golden::process::{Blocks, Latencies, Threads};
use pointcore_hdl::compiler::Options;
use pointcore_hdl::process::threads::{self, Core};

use crate::process::cloud::{BLOCK_CYCLES, QUERIES, Queries, Seen};
use crate::process::scene::every_program;
use crate::process::stage;
use crate::search::environment::{Feeds, Rule};
use crate::search::{all, lockstep};
use crate::support::cases;

/// The kernel as what it computes: a thread's partial sums.
#[derive(Clone)]
struct Kernel {
    blocks: Blocks,
    types: Vec<Scalar>,
    /// The settings that it reads.
    settings: Vec<u32>,
    /// Whose sums these are, and how many neighbors are in them.
    thread: Option<u64>,
    neighbors: usize,
    partial: Vec<[u32; PARTIAL_SUMS]>,
}

impl Kernel {
    /// Takes a neighbor; returns the sums after the last one.
    fn take(&mut self, fields: &[u64]) -> Option<Vec<u64>> {
        let &[thread, none, last, ref words @ ..] = fields else { panic!("`kernel` takes three fields at least") };
        if self.thread.is_none() {
            (self.thread, self.neighbors) = (Some(thread), 0);
            self.partial = vec![[0; PARTIAL_SUMS]; self.types.len()];
        }
        assert_eq!(self.thread, Some(thread), "a query's neighbors come together");
        if none == 0 {
            let words: Vec<u32> = words.iter().map(|&word| word as u32).chain(self.settings.clone()).collect();
            let addends = self.blocks.step(Section::Kernel, &words);
            for ((partial, &ty), addend) in self.partial.iter_mut().zip(&self.types).zip(addends) {
                let sum = &mut partial[self.neighbors % PARTIAL_SUMS];
                *sum = self.blocks.add(ty, *sum, addend);
            }
            self.neighbors += 1;
        }
        (last == 1).then(|| {
            self.thread = None;
            std::iter::once(thread).chain(self.partial.iter().flatten().map(|&word| word.into())).collect()
        })
    }
}

/// Queries with searching, gathering and `kernel` around them.
#[derive(Clone)]
struct Surroundings {
    config: Config,
    queries: Queries,
    kernel: Kernel,
}

impl Surroundings {
    fn begin(config: &Config, feeds: &mut Feeds) -> Self {
        let mut queries = Queries::begin(config, feeds);
        queries.are_expected = feeds.random.bool();
        let read = config.settings_read_by(Section::Kernel).into_iter();
        let kernel = Kernel {
            blocks: Blocks::new((*config.program).clone(), config.format),
            types: config.program.sums.words().into_iter().map(|word| word.ty).collect(),
            settings: read.map(|place| queries.settings[place]).collect(),
            thread: None,
            neighbors: 0,
            partial: vec![],
        };
        Self { config: config.clone(), queries, kernel }
    }
}

impl Rule for Surroundings {
    const SEEDS: u64 = 6;

    fn quiet_cycles(&self) -> u64 {
        BLOCK_CYCLES
    }

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "gather" => {
                let &[thread, farthest, none, last, index] = fields else { panic!("a neighbor has five fields") };
                let point = self.queries.cloud.point(index);
                let words = if none == 1 { vec![0; self.config.program.neighbor.len()] } else { point };
                let words = words.into_iter().map(u64::from);
                feeds.feed("gathered", [thread, farthest, none, last].into_iter().chain(words).collect());
            }
            "kernel" => {
                if let Some(mut sums) = self.kernel.take(fields) {
                    if !self.queries.are_expected {
                        sums = stage::words::<Sums>(&self.config, &mut feeds.random);
                        sums[0] = fields[0];
                    }
                    feeds.feed("sums", sums);
                }
            }
            other => self.queries.transferred(feeds, other, fields),
        }
    }
}

#[test]
fn queries_of_every_program_leave_as_the_interpreter_says() {
    for config in cases(every_program()) {
        let core = threads::core(&config, &Options::default());
        let Core { module, manifests } = core.unwrap_or_else(|error| panic!("{error}"));
        let latency = |block: &str| manifests.get(block).map(|manifest| manifest.latency);
        let latencies = Latencies { init: latency("init"), finish: latency("final").expect("there is a `final`") };
        let model = Threads::new(&config, latencies);
        let begin = |feeds: &mut Feeds| Surroundings::begin(&config, feeds);
        let seen = RefCell::new(Seen::default());
        lockstep(&config, &module, &model, &stages::threads::UNIT, begin, all, |surroundings, report| {
            assert_eq!(report.transfers("result"), QUERIES);
            surroundings.queries.finish(&mut seen.borrow_mut());
        });
        seen.into_inner().check(&config);
    }
}
