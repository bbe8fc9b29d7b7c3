//! What is around the search core: a host that asks for neighbors, search after search, and memory that answers late
//! and out of order, each stream at its own pace, with resets in between.

use super::pace::Paces;
use super::surroundings::{Idle, Pending, Surroundings, Watch, resets};
use super::trees::RandomTree;
use fastrand::Rng;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Beat, BeatPlace, CacheSetup, CachedQuery, Fetch, Lookup};
use pointcore_contract::{read, write};
use pointcore_golden::search::top::{In, Out};
use pointcore_tb::lockstep::{Flow, Stimulus};
use std::collections::VecDeque;
use std::sync::Arc;

/// Streams that can be held back, by their places among the paces: queries.
pub const QUERY: usize = 0;
/// Points.
pub const BEAT: usize = 1;
/// Records of the tree.
pub const RECORD: usize = 2;
/// Requests for points.
pub const FETCH: usize = 3;
/// Requests for records.
pub const LOOKUP: usize = 4;
/// Neighbors.
pub const RESULT: usize = 5;
/// Writes to the tree.
pub const TREE: usize = 6;
/// How many they are.
pub const STREAMS: usize = 7;
/// Requests among which memory chooses, at most.
const WINDOW: usize = 32;

/// How much there is of everything, at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// Searches one after the other.
    pub searches: usize,
    /// Points of the tree.
    pub points: u32,
    /// Queries of a search.
    pub queries: u32,
    /// Cycles that memory takes to answer.
    pub latency_cycles: u64,
    /// Cycles within which a reset comes, if one does.
    pub reset_cycles: u64,
}

/// Queries that are asked together, and how the neighbor cache judges then.
#[derive(Clone, Debug)]
pub struct Search {
    setup: CacheSetup,
    queries: Vec<CachedQuery>,
}

/// How memory answers.
#[derive(Clone, Copy, Debug)]
pub struct Answers {
    /// Cycles that it takes at most; each request takes its own time.
    pub latency: u64,
    /// Among how many of the oldest requests it chooses.
    pub window: usize,
}

/// A memory's port: what is asked of it, each with the cycle from which it may be answered, and what is being answered.
#[derive(Clone)]
struct Port<K> {
    answers: Answers,
    random: Rng,
    waiting: VecDeque<(K, u64)>,
    answering: Option<(K, u32)>,
}

impl<K: Copy> Port<K> {
    const fn new(answers: Answers, random: Rng) -> Self {
        Self { answers, random, waiting: VecDeque::new(), answering: None }
    }

    fn request(&mut self, key: K, cycle: u64) {
        self.waiting.push_back((key, cycle + self.random.u64(1..=self.answers.latency)));
    }

    /// The request that is answered in this cycle, and the number of its beat.
    fn offer(&mut self, cycle: u64) -> Option<(K, u32)> {
        if self.answering.is_none() {
            let window = self.waiting.len().min(self.answers.window);
            let chosen = if window == 0 { None } else { Some(self.random.usize(..window)) };
            // A request whose time has not come is as good as none: another one may be chosen in the next cycle.
            let chosen = chosen.filter(|&index| self.waiting[index].1 <= cycle);
            self.answering = chosen.and_then(|index| self.waiting.remove(index)).map(|(key, _)| (key, 0));
        }
        self.answering
    }

    /// The beat on offer was taken, of so many.
    fn take(&mut self, beats: u32) {
        self.answering = self.answering.map(|(key, beat)| (key, beat + 1)).filter(|(_, beat)| *beat < beats);
    }
}

/// What a host plays.
pub struct Script {
    /// The tree, with its points.
    pub tree: RandomTree,
    /// Searches, one after the other.
    pub searches: Vec<Search>,
    /// When streams are held back.
    pub paces: Paces,
    /// How memory answers.
    pub answers: Answers,
    /// Cycles in which the core is reset, the last one first.
    pub resets: Vec<u64>,
}

impl Script {
    /// A random one.
    #[must_use]
    pub fn random(config: &Config, most: Bounds, random: &mut Rng) -> Self {
        let tree = RandomTree::random(config, most.points, random);
        let search = |random: &mut Rng| Search {
            setup: RandomTree::setup(config, random),
            queries: tree.queries(config, most.queries, random),
        };
        let searches = (0..random.usize(1..=most.searches)).map(|_| search(random)).collect();
        let latency = if random.bool() { random.u64(1..20) } else { random.u64(1..=most.latency_cycles) };
        let window = if random.u8(..3) == 0 { 1 } else { random.usize(2..=WINDOW) };
        let answers = Answers { latency, window };
        Self {
            tree,
            searches,
            paces: Paces::random(random, STREAMS),
            answers,
            resets: resets(most.reset_cycles, random),
        }
    }
}

/// The host and its memory before a run, or in the midst of it.
#[derive(Clone)]
pub struct Searcher {
    config: Config,
    tree: Arc<RandomTree>,
    searches: Arc<[Search]>,
    paces: Paces,
    idle: Option<Idle>,
    watch: Watch,
    resets: Vec<u64>,
    fetches: Port<Fetch>,
    lookups: Port<Lookup>,
    inputs: In,
    /// Writes to the tree that have been made.
    written: usize,
    /// The search that is under way, whether its setup has been sent, its queries sent and answered.
    search: usize,
    is_set_up: bool,
    sent: usize,
    answered: usize,
    /// Queries of searches before.
    done: usize,
}

impl Searcher {
    /// The host of a core, out of reset; silence for so many cycles means that it is stuck. What streams that offer nothing
    /// show is filled, or left as it is.
    #[must_use]
    pub fn new(config: &Config, script: Script, idle: Option<Idle>, quiet_cycles: u64, mut random: Rng) -> Self {
        let Script { tree, searches, paces, answers, resets } = script;
        Self {
            config: config.clone(),
            tree: Arc::new(tree),
            searches: searches.into(),
            watch: Watch::new(quiet_cycles + answers.latency + paces.longest()),
            paces,
            resets,
            fetches: Port::new(answers, random.fork()),
            lookups: Port::new(answers, random.fork()),
            idle,
            inputs: In::default(),
            written: 0,
            search: 0,
            is_set_up: false,
            sent: 0,
            answered: 0,
            done: 0,
        }
    }

    /// Begins the search again that was under way, on a core that has forgotten everything.
    fn restart(&mut self) {
        let fork = |port_random: &mut Rng| port_random.fork();
        self.fetches = Port::new(self.fetches.answers, fork(&mut self.fetches.random));
        self.lookups = Port::new(self.lookups.answers, fork(&mut self.lookups.random));
        (self.written, self.is_set_up, self.sent, self.answered) = (0, false, 0, 0);
    }

    /// Takes what moved in the cycle before.
    fn account(&mut self, cycle: u64, outputs: &Out) {
        let inputs = &self.inputs;
        let query = inputs.query.is_some() && outputs.query_ready;
        let beat = inputs.beat.is_some() && outputs.beat_ready;
        let record = inputs.record.is_some() && outputs.record_ready;
        let fetch = outputs.fetch.filter(|_| inputs.fetch_ready);
        let lookup = outputs.lookup.filter(|_| inputs.lookup_ready);
        let result = outputs.result.filter(|_| inputs.result_ready);
        self.sent += usize::from(query);
        if beat && let Some((fetch, _)) = self.fetches.answering {
            self.fetches.take(fetch.beats.into());
        }
        if record {
            self.lookups.take(1);
        }
        if let Some(fetch) = fetch {
            self.fetches.request(fetch, cycle);
        }
        if let Some(lookup) = lookup {
            self.lookups.request(lookup, cycle);
        }
        self.answered += usize::from(result.is_some_and(|result| result.result.last));
        if self.search < self.searches.len() && self.answered == self.searches[self.search].queries.len() {
            self.done += self.answered;
            (self.search, self.is_set_up, self.sent, self.answered) = (self.search + 1, false, 0, 0);
        }
        let written = self.inputs.tree.is_some() || self.inputs.setup.is_some();
        if query || beat || record || written || fetch.is_some() || lookup.is_some() || result.is_some() {
            self.watch.moved(cycle);
        }
    }

    /// Sets what is offered and what is taken; an offer once made stands.
    fn offer(&mut self, cycle: u64, outputs: &Out) {
        let idle: [bool; STREAMS] = std::array::from_fn(|stream| self.paces.idle(stream, cycle));
        let config = &self.config;
        let writes = if config.tree_cache > 0 { &[][..] } else { &self.tree.writes };
        self.inputs.tree = writes.get(self.written).copied().filter(|_| !idle[TREE]);
        self.written += usize::from(self.inputs.tree.is_some());
        let search = self.searches.get(self.search);
        let is_written = self.written == writes.len() && self.inputs.tree.is_none();
        let was_set_up = self.is_set_up;
        let may_set_up = is_written && !was_set_up && self.inputs.query.is_none();
        self.inputs.setup = search.filter(|_| may_set_up && config.neighbor_cache > 0).map(|search| search.setup);
        self.is_set_up |= may_set_up;
        if self.inputs.query.is_none() || outputs.query_ready {
            let query = search.and_then(|search| search.queries.get(self.sent)).copied();
            self.inputs.query = query.filter(|_| was_set_up && !idle[QUERY]);
        }
        if self.inputs.beat.is_none() || outputs.beat_ready {
            let beat = self.fetches.answering.or_else(|| self.fetches.offer(cycle)).filter(|_| !idle[BEAT]);
            self.inputs.beat = beat.map(|(fetch, number)| {
                let address = fetch.address + number;
                let last = number + 1 == u32::from(fetch.beats);
                Beat { place: BeatPlace { thread: fetch.thread, address, last }, points: self.tree.beat(address) }
            });
        }
        if self.inputs.record.is_none() || outputs.record_ready {
            let record = self.lookups.offer(cycle).filter(|_| !idle[RECORD]);
            self.inputs.record = record.map(|(lookup, _)| self.tree.record(config, lookup));
        }
        self.inputs.fetch_ready = !idle[FETCH];
        self.inputs.lookup_ready = !idle[LOOKUP];
        self.inputs.result_ready = !idle[RESULT];
    }
}

impl Stimulus for Searcher {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let outputs: Out = read(&self.config, outputs);
        if inputs[0] == 1 {
            // What was offered to a core in reset was not taken, and need not be offered again.
            self.inputs = In::default();
        } else if cycle > 0 {
            self.account(cycle - 1, &outputs);
        }
        if self.watch.is_over(cycle, self.search == self.searches.len()) {
            return Flow::Done;
        }
        let is_reset = self.resets.pop_if(|next| *next <= cycle).is_some();
        if is_reset {
            self.restart();
        } else {
            self.offer(cycle, &outputs);
        }
        // The reset comes first.
        inputs[0] = u64::from(is_reset);
        write(&self.config, self.inputs, &mut inputs[1..]);
        if let Some(idle) = &mut self.idle {
            idle.fill(inputs);
        }
        Flow::Continue
    }
}

impl Surroundings for Searcher {
    fn stuck(&self) -> Option<u64> {
        self.watch.stuck()
    }

    fn pending(&self) -> Pending {
        let expected = self.searches.iter().map(|search| search.queries.len()).sum();
        Pending { done: self.done + self.answered, expected, what: "queries" }
    }

    fn without_watch(mut self) -> Self {
        self.watch = Watch::new(u64::MAX);
        self
    }
}
