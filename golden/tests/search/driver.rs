//! Runs the composed core: feeds queries, answers its fetches late and in any order, collects results, stalling every stream at
//! random.

use crate::tree::Tree;
use fastrand::Rng;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{
    Beat, BeatPlace, CacheSetup, CachedQuery, CachedResult, Fetch, Lookup, TreeRecord, TreeWrite,
};
use pointcore_contract::search::units::Events;
use pointcore_golden::search::Latencies;
use pointcore_golden::search::top::{In, Top};
use pointcore_golden::unit::Model;

/// Cycles without any transfer after which the core counts as stuck.
const PATIENCE: u32 = 10_000;

/// What surrounds the core.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings {
    /// Cycles from a request to the memory to its answer, from one to this many.
    pub latency: u64,
    /// In how many of eight cycles a stream pauses.
    pub pauses: u8,
}

/// A query's neighbors in the order of the results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    pub number: u32,
    /// Indices and squared distances.
    pub neighbors: Vec<(u32, u32)>,
    /// It is another query's neighborhood.
    pub cached: bool,
}

/// Requests that a memory answers late and in any order.
struct Requests<T> {
    /// With the cycles from which on they may be answered.
    waiting: Vec<(T, u64)>,
    /// The request that is answered.
    current: Option<T>,
}

impl<T: Copy> Requests<T> {
    const fn new() -> Self {
        Self { waiting: Vec::new(), current: None }
    }

    /// Chooses what to answer next among all requests that are old enough.
    fn choose(&mut self, cycle: u64, random: &mut Rng) {
        if self.current.is_none() {
            let ready: Vec<_> = (0..self.waiting.len()).filter(|index| self.waiting[*index].1 <= cycle).collect();
            self.current = random.choice(ready).map(|index| self.waiting.swap_remove(index).0);
        }
    }
}

/// The external memory: points and, behind a tree cache, the tree.
struct Memory<'a> {
    tree: &'a Tree,
    lanes: usize,
    fetches: Requests<Fetch>,
    /// Beats sent of the leaf that is answered.
    beats_sent: u8,
    lookups: Requests<Lookup>,
}

impl Memory<'_> {
    fn beat(&self) -> Option<Beat> {
        let fetch = self.fetches.current?;
        let address = fetch.address + u32::from(self.beats_sent);
        let place = BeatPlace { thread: fetch.thread, address, last: self.beats_sent + 1 == fetch.beats };
        let mut beat = Beat { place, ..Beat::default() };
        let first = address as usize * self.lanes;
        beat.points.lane[..self.lanes].copy_from_slice(&self.tree.points[first..first + self.lanes]);
        Some(beat)
    }

    fn record(&self) -> Option<TreeRecord> {
        let lookup = self.lookups.current?;
        let TreeWrite { node, bucket, .. } = self.tree.records[&lookup.address];
        Some(TreeRecord { lookup, node, bucket })
    }

    fn advance(&mut self) {
        self.beats_sent += 1;
        if self.fetches.current.is_some_and(|fetch| fetch.beats == self.beats_sent) {
            self.fetches.current = None;
            self.beats_sent = 0;
        }
    }
}

/// The core with a tree.
pub struct Bench<'a> {
    top: Top,
    memory: Memory<'a>,
    surroundings: Surroundings,
    random: Rng,
    /// Cycles run.
    pub cycles: u64,
    /// Nodes visited.
    pub visits: u64,
    /// Beats of distances worked on.
    pub beats: u64,
    /// Leaves found in the point cache.
    pub point_hits: u64,
    /// Records found in the tree cache.
    pub tree_hits: u64,
    /// Queries that were covered by a neighborhood in the neighbor cache.
    pub neighbor_hits: u64,
}

impl<'a> Bench<'a> {
    pub fn new(config: &Config, latencies: Latencies, tree: &'a Tree, surroundings: Surroundings, seed: u64) -> Self {
        let mut top = Top::new(config, latencies);
        if config.tree_cache == 0 {
            for write in tree.records.values() {
                top.clock(&In { tree: Some(*write), ..In::default() });
            }
        }
        let memory = Memory {
            tree,
            lanes: config.lanes as usize,
            fetches: Requests::new(),
            beats_sent: 0,
            lookups: Requests::new(),
        };
        Self {
            top,
            memory,
            surroundings,
            random: Rng::with_seed(seed),
            cycles: 0,
            visits: 0,
            beats: 0,
            point_hits: 0,
            tree_hits: 0,
            neighbor_hits: 0,
        }
    }

    /// Sets the neighbor cache up.
    pub fn set_up(&mut self, setup: CacheSetup) {
        self.top.clock(&In { setup: Some(setup), ..In::default() });
    }

    /// Lets cycles pass.
    pub fn idle(&mut self, cycles: u64) {
        (0..cycles).for_each(|_| self.top.clock(&In::default()));
        self.cycles += cycles;
    }

    fn goes_on(&mut self) -> bool {
        self.random.u8(0..8) >= self.surroundings.pauses
    }

    /// When the memory may answer a request of this cycle.
    fn due(&mut self) -> u64 {
        self.cycles + self.random.u64(1..=self.surroundings.latency)
    }

    /// Answers to all queries, in the order in which they come.
    pub fn search<Q: Copy + Into<CachedQuery>>(&mut self, queries: &[Q]) -> Vec<Answer> {
        let mut queries_left = queries.iter();
        let mut answers = Vec::new();
        let mut neighbors = Vec::new();
        let mut patience = PATIENCE;
        while answers.len() < queries.len() {
            self.memory.fetches.choose(self.cycles, &mut self.random);
            self.memory.lookups.choose(self.cycles, &mut self.random);
            let out = self.top.outputs();
            let inputs = In {
                tree: None,
                lookup_ready: self.goes_on(),
                record: self.memory.record().filter(|_| self.goes_on()),
                setup: None,
                query: queries_left.as_slice().first().map(|query| (*query).into()).filter(|_| self.goes_on()),
                fetch_ready: self.goes_on(),
                beat: self.memory.beat().filter(|_| self.goes_on()),
                result_ready: self.goes_on(),
            };
            patience -= 1;
            if inputs.query.is_some() && out.query_ready {
                queries_left.next();
                patience = PATIENCE;
            }
            if let Some(fetch) = out.fetch.filter(|_| inputs.fetch_ready) {
                assert!(fetch.beats > 0, "a leaf has a beat at least");
                let due = self.due();
                self.memory.fetches.waiting.push((fetch, due));
                patience = PATIENCE;
            }
            if let Some(lookup) = out.lookup.filter(|_| inputs.lookup_ready) {
                let due = self.due();
                self.memory.lookups.waiting.push((lookup, due));
                patience = PATIENCE;
            }
            if inputs.record.is_some() && out.record_ready {
                self.memory.lookups.current = None;
                patience = PATIENCE;
            }
            if inputs.beat.is_some() && out.beat_ready {
                self.memory.advance();
                patience = PATIENCE;
            }
            if let Some(CachedResult { result, cached }) = out.result.filter(|_| inputs.result_ready) {
                neighbors.extend(result.found.then_some((result.index, result.distance2)));
                if result.last {
                    let neighbors = std::mem::take(&mut neighbors);
                    answers.push(Answer { number: result.number, neighbors, cached });
                }
                patience = PATIENCE;
            }
            self.count(&out.events);
            self.top.clock(&inputs);
            self.cycles += 1;
            assert!(patience > 0, "the core is stuck in cycle {}: {:?}", self.cycles, self.top.outputs());
        }
        answers
    }

    fn count(&mut self, events: &Events) {
        self.visits += u64::from(events.node);
        self.beats += u64::from(events.queue.beat);
        self.point_hits += u64::from(events.point_cache.hit);
        self.tree_hits += u64::from(events.tree_cache.hit);
        self.neighbor_hits += u64::from(events.neighbor_cache.hit);
    }
}
