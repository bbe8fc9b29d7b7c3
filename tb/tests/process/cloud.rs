//! Queries of a random cloud, and what the interpreter says that they leave with.

use std::collections::HashMap;
use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};

use fastrand::Rng;
use pointcore_contract::fields;
use pointcore_contract::process::records::Settings;
use pointcore_contract::process::{Config, Section};
use pointcore_golden::process::{Interpreter, Neighborhood};

use super::scene::{number, settings, tame, within};
use crate::search::environment::Feeds;

/// Queries of a run: more than any core has threads.
pub const QUERIES: u64 = 48;
/// Longer than a block of any program takes.
pub const BLOCK_CYCLES: u64 = 1500;
const ITERATIONS_MAX: u32 = 4;
/// How many times some points' numbers are doubled.
const MAGNITUDES: std::ops::Range<i32> = -24..16;
/// Cycles that a search takes at most.
const SEARCH_CYCLES: u32 = 60;

/// A cloud: what is where, and what is near.
#[derive(Clone)]
pub struct Cloud {
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
    pub fn point(&self, index: u64) -> Vec<u32> {
        let mut random = self.random(index);
        let types = self.config.program.neighbor.words().into_iter().map(|word| word.ty);
        // Sums of small numbers show what is small in them; not in every cloud, for they hardly take several iterations.
        let is_varied = self.seed.is_multiple_of(2) && random.bool();
        let mut magnitude = || if is_varied { 2_f64.powi(random.i32(MAGNITUDES)) } else { 1.0 };
        let [position, attributes] = [magnitude(), magnitude()];
        // Where a point is decides whether what it has counts.
        let attributes = if random.bool() { attributes } else { position };
        let magnitudes = [position; 3].into_iter().chain(std::iter::repeat(attributes));
        types.zip(magnitudes).map(|(ty, magnitude)| within(magnitude, &mut random, self.config.format, ty)).collect()
    }

    /// The neighbors of a position: none, one, as many as there may be, or some.
    fn near(&self, position: [u32; 3]) -> Vec<u64> {
        let mut random = self.random(position);
        let most = self.config.neighbors;
        let counts = [0, 1, most, random.u32(1..=most), random.u32(1..=most.min(9)), most.min(8)];
        let count = counts[random.usize(..counts.len())];
        let (points, center) = (1 << self.config.index_bits, random.u64(..1 << self.config.index_bits));
        let index =
            |random: &mut Rng| if random.bool() { (center + random.u64(..16)) % points } else { random.u64(..points) };
        (0..count).map(|_| index(&mut random)).collect()
    }

    fn neighborhood(&self, position: [u32; 3]) -> Neighborhood {
        let neighbors: Vec<_> = self.near(position).into_iter().map(|index| self.point(index)).collect();
        let farthest = neighbors.len().saturating_sub(1);
        Neighborhood { neighbors, farthest }
    }
}

/// The queries of a run, the searches for them, and what each is to leave with.
#[derive(Clone)]
pub struct Queries {
    /// What is searched.
    pub cloud: Cloud,
    /// Constants of the run.
    pub settings: Vec<u32>,
    interpreter: Interpreter,
    /// By number, of those that have not left.
    expected: HashMap<u64, Vec<u64>>,
    /// The sums are those of the neighbors, so the interpreter's results are.
    pub are_expected: bool,
    searches: u64,
    /// Searches that found nothing.
    empty: u64,
    left: u64,
    capped: u64,
}

/// What happened in runs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Seen {
    /// Queries that had no iteration left.
    pub capped: u64,
    /// Searches beyond the first of each query.
    pub anew: u64,
    /// Searches that found nothing.
    pub empty: u64,
}

impl Queries {
    /// Feeds queries and constants.
    pub fn begin(config: &Config, feeds: &mut Feeds) -> Self {
        let program = &config.program;
        let settings = settings(program, config.format, &mut feeds.random);
        let cloud = Cloud { config: config.clone(), seed: feeds.random.u64(..) };
        for index in 0..QUERIES {
            let number = number(config, index);
            let types = program.query.words().into_iter().map(|word| word.ty);
            let words = types.map(|ty| tame(&mut feeds.random, config.format, ty).into());
            let query = std::iter::once(number).chain(words).collect();
            feeds.feed("query", query);
        }
        feeds.hold("iterations_max", ITERATIONS_MAX.into());
        for (field, &value) in fields::<Settings>(config).iter().zip(&settings) {
            feeds.hold(&format!("setting_{}", field.name), value.into());
        }
        let interpreter = Interpreter::new((**program).clone(), config.format, settings.clone(), ITERATIONS_MAX);
        let (expected, are_expected) = (HashMap::new(), true);
        Self { cloud, settings, interpreter, expected, are_expected, searches: 0, empty: 0, left: 0, capped: 0 }
    }

    /// A query, a search or a result has moved.
    pub fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "query" => {
                let words: Vec<u32> = fields[1..].iter().map(|&word| word as u32).collect();
                let outcome = self.interpreter.run(&words, |position| self.cloud.neighborhood(position));
                let outputs = outcome.outputs.iter().map(|&word| word.into());
                let first = [fields[0], outcome.iterations.into(), outcome.capped.into()];
                self.expected.insert(fields[0], first.into_iter().chain(outputs).collect());
            }
            "wanted" => self.search(feeds, fields.try_into().expect("a search has a thread and a position")),
            "result" => {
                let expected = self.expected.remove(&fields[0]).expect("it has not left");
                assert!(!self.are_expected || fields == expected, "query {}: {fields:?}, {expected:?}", fields[0]);
                self.left += 1;
                self.capped += fields[2];
            }
            _ => {}
        }
    }

    fn search(&mut self, feeds: &mut Feeds, &[thread, x, y, z]: &[u64; 4]) {
        self.searches += 1;
        let near = self.cloud.near([x, y, z].map(|word| word as u32));
        let cycles = feeds.random.u32(..SEARCH_CYCLES);
        if near.is_empty() {
            self.empty += 1;
            feeds.feed_after(cycles, "found", vec![thread, 1, 0, 0]);
        }
        for (rank, &index) in near.iter().enumerate() {
            let cycles = if rank == 0 { cycles } else { 0 };
            feeds.feed_after(cycles, "found", vec![thread, u64::from(rank + 1 == near.len()), 1, index]);
        }
    }

    /// Every query has left; adds what was seen of them.
    pub fn finish(&self, seen: &mut Seen) {
        assert_eq!(self.left, QUERIES);
        seen.capped += self.capped;
        seen.anew += self.searches - QUERIES;
        seen.empty += self.empty;
    }
}

impl Seen {
    /// The runs of a program had everything that may happen in them.
    pub fn check(self, config: &Config) {
        let name = config.program.name();
        assert!(self.empty > 0, "{name}: {self:?}");
        let is_iterated = config.program.block(Section::Final).results().done.is_some();
        assert!(!is_iterated || self.capped > 0, "{name}: {self:?}");
        assert!(!config.has_search() || self.anew > 0, "{name}: {self:?}");
    }
}
