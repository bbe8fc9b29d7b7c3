//! Threads and their blocks against their model in every cycle, and each query against the interpreter: every program of
//! the library, with models of searching, gathering and `kernel` that take their time.

use std::cell::RefCell;
use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

use fastrand::Rng;
use pointcore_contract::process::library::{PROGRAMS, program};
use pointcore_contract::process::records::Settings;
use pointcore_contract::process::{Config, PARTIAL_SUMS, Scalar, Section, Source, stages};
use pointcore_contract::{Format, fields};
use pointcore_golden::float;
use pointcore_golden::process::{Blocks, Interpreter, Latencies, Neighborhood, Threads};
use pointcore_hdl::compiler::Options;
use pointcore_hdl::process::threads::{self, Core};

use crate::process::scene::{configs, settings, tame};
use crate::search::environment::{Feeds, Rule};
use crate::search::{all, lockstep};

const QUERIES: u64 = 40;
const ITERATIONS_MAX: u32 = 4;
/// Longer than a block of any program takes.
const BLOCK_CYCLES: u64 = 1500;
/// Cycles that a search takes at most.
const SEARCH_CYCLES: u32 = 60;

/// A cloud: what is where, and what is near.
#[derive(Clone)]
struct Cloud {
    config: Config,
    seed: u64,
}

impl Cloud {
    fn random(&self, what: impl Hash) -> Rng {
        let mut hasher = DefaultHasher::new();
        (self.seed, what).hash(&mut hasher);
        Rng::with_seed(hasher.finish())
    }

    /// The words of a point.
    fn point(&self, index: u64) -> Vec<u32> {
        let mut random = self.random(index);
        let types = self.config.program.neighbor.words().into_iter().map(|word| word.ty);
        types.map(|ty| tame(&mut random, self.config.format, ty)).collect()
    }

    /// The neighbors of a position: none, one, as many as there may be, or some.
    fn near(&self, position: [u32; 3]) -> Vec<u64> {
        let mut random = self.random(position);
        let most = self.config.neighbors;
        let counts = [0, 1, most, random.u32(1..=most), random.u32(1..=most.min(9)), most.min(8)];
        let count = counts[random.usize(..counts.len())];
        (0..count).map(|_| random.u64(..1 << self.config.index_bits)).collect()
    }

    fn neighborhood(&self, position: [u32; 3]) -> Neighborhood {
        let neighbors: Vec<_> = self.near(position).into_iter().map(|index| self.point(index)).collect();
        let farthest = neighbors.len().saturating_sub(1);
        Neighborhood { neighbors, farthest }
    }
}

/// The kernel as what it computes: a thread's partial sums.
#[derive(Clone)]
struct Kernel {
    blocks: Blocks,
    format: Format,
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
        let &[thread, none, last, ref words @ ..] = fields else { panic!("what `kernel` takes has three fields at least") };
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
                *sum = match ty {
                    Scalar::Float => float::add(self.format, (*sum).into(), addend.into()) as u32,
                    Scalar::Int | Scalar::Bool => sum.wrapping_add(addend),
                };
            }
            self.neighbors += 1;
        }
        (last == 1).then(|| {
            self.thread = None;
            std::iter::once(thread).chain(self.partial.iter().flatten().map(|&word| word.into())).collect()
        })
    }
}

/// Searching, gathering and `kernel`, and what each query is to leave with.
#[derive(Clone)]
struct Surroundings {
    cloud: Cloud,
    kernel: Kernel,
    interpreter: Interpreter,
    /// By number.
    expected: Vec<Vec<u64>>,
    results: u64,
    capped: u64,
    anew: u64,
    without: u64,
}

impl Surroundings {
    fn begin(config: &Config, feeds: &mut Feeds) -> Self {
        let program = &config.program;
        let random = &mut feeds.random;
        let settings = settings(program, config.format, random);
        let blocks = Blocks::new((**program).clone(), config.format);
        let kernel = Kernel {
            blocks,
            format: config.format,
            types: program.sums.words().into_iter().map(|word| word.ty).collect(),
            settings: config.settings_read_by(Section::Kernel).into_iter().map(|place| settings[place]).collect(),
            thread: None,
            neighbors: 0,
            partial: vec![],
        };
        let interpreter =
            Interpreter::new((**program).clone(), config.format, settings.clone(), ITERATIONS_MAX);
        let cloud = Cloud { config: config.clone(), seed: random.u64(..) };
        for number in 0..QUERIES {
            let types = program.query.words().into_iter().map(|word| word.ty);
            let words = types.map(|ty| tame(&mut feeds.random, config.format, ty).into());
            let query = std::iter::once(number).chain(words).collect();
            feeds.feed("query", query);
        }
        feeds.hold("iterations_max", ITERATIONS_MAX.into());
        for (field, &value) in fields::<Settings>(config).iter().zip(&settings) {
            feeds.hold(&format!("setting_{}", field.name), value.into());
        }
        let expected = vec![vec![]; QUERIES as usize];
        Self { cloud, kernel, interpreter, expected, results: 0, capped: 0, anew: 0, without: 0 }
    }

    fn search(&mut self, feeds: &mut Feeds, &[thread, x, y, z]: &[u64; 4]) {
        let near = self.cloud.near([x, y, z].map(|word| word as u32));
        let cycles = feeds.random.u32(..SEARCH_CYCLES);
        if near.is_empty() {
            self.without += 1;
            feeds.feed_after(cycles, "found", vec![thread, 1, 0, 0]);
        }
        for (rank, &index) in near.iter().enumerate() {
            let cycles = if rank == 0 { cycles } else { 0 };
            feeds.feed_after(cycles, "found", vec![thread, u64::from(rank + 1 == near.len()), 1, index]);
        }
    }
}

impl Rule for Surroundings {
    fn quiet_cycles(&self) -> u64 {
        BLOCK_CYCLES
    }

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "query" => {
                let words: Vec<u32> = fields[1..].iter().map(|&word| word as u32).collect();
                let outcome = self.interpreter.run(&words, |position| self.cloud.neighborhood(position));
                let outputs = outcome.outputs.iter().map(|&word| word.into());
                let first = [fields[0], outcome.iterations.into(), outcome.capped.into()];
                self.expected[fields[0] as usize] = first.into_iter().chain(outputs).collect();
            }
            "wanted" => {
                self.anew += 1;
                self.search(feeds, fields.try_into().expect("a search has a thread and a position"));
            }
            "gather" => {
                let &[thread, farthest, none, last, index] = fields else { panic!("a neighbor wanted has five fields") };
                let words = if none == 1 { vec![0; self.cloud.config.program.neighbor.len()] } else { self.cloud.point(index) };
                let words = words.into_iter().map(u64::from);
                feeds.feed("gathered", [thread, farthest, none, last].into_iter().chain(words).collect());
            }
            "kernel" => {
                if let Some(sums) = self.kernel.take(fields) {
                    feeds.feed("sums", sums);
                }
            }
            "result" => {
                assert_eq!(fields, self.expected[fields[0] as usize], "query {}", fields[0]);
                self.expected[fields[0] as usize].clear();
                self.results += 1;
                self.capped += fields[2];
            }
            _ => {}
        }
    }
}

/// Runs a program; returns how many queries were capped, searched for anew and without neighbors.
fn agree(config: &Config) -> [u64; 3] {
    let core = threads::core(config, &Options::default());
    let Core { module, manifests } = core.unwrap_or_else(|error| panic!("{error}"));
    let latency = |block: &str| manifests.get(block).map(|manifest| manifest.latency);
    let latencies = Latencies { init: latency("init"), finish: latency("final").expect("there is a `final`") };
    let begin = |feeds: &mut Feeds| Surroundings::begin(config, feeds);
    let seen = RefCell::new([0; 3]);
    let unit = &stages::threads::UNIT;
    lockstep(config, &module, &Threads::new(config, latencies), unit, begin, all, |surroundings, report| {
        assert_eq!(report.transfers("result"), QUERIES);
        assert_eq!(surroundings.results, QUERIES);
        let own = [surroundings.capped, surroundings.anew - QUERIES, surroundings.without];
        seen.borrow_mut().iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
    });
    seen.into_inner()
}

#[test]
fn queries_of_every_program_leave_as_the_interpreter_says() {
    let shapes = [(1, 3), (5, 64), (16, 16), (32, 8)];
    for ((name, _), (threads, neighbors)) in PROGRAMS.iter().zip(shapes.into_iter().cycle()) {
        let program = program(name);
        let is_iterated = program.block(Section::Final).results().done.is_some();
        let config = Config { program: Arc::new(program), threads, neighbors, ..configs()[0].clone() };
        let [capped, anew, without] = agree(&config);
        assert!(without > 0, "{name}: no search without neighbors");
        assert!(!is_iterated || (capped > 0 && anew > 0), "{name}: {capped} capped, {anew} searched for anew");
    }
}

#[test]
fn a_program_that_does_what_the_library_does_not_leaves_as_the_interpreter_says() {
    let [.., farthest, _] = configs();
    assert!(farthest.read_by(Section::Init).iter().any(|source| matches!(source, Source::Farthest(_))));
    let [capped, anew, without] = agree(&farthest);
    assert!(capped > 0 && anew > 0 && without > 0, "{capped} capped, {anew} searched for anew, {without} without");
}
