//! The host around core B: loads the tree, streams queries, plays the point memory, collects results, counts.

use super::Tree;
use super::memory::{Extent, Memory, MemorySettings};
use super::points::decode;
use super::query::Neighbor;
use crate::core_a::Progress;
use crate::lockstep::{Flow, Stalls, Stimulus};
use pointcore_golden::core_b::records::{Beat, BeatPlace, CachedQuery, CachedResult, Fetch, Query, Shape, TreeWrite};
use pointcore_golden::core_b::top::{In, Out};
use pointcore_golden::unit::{self, Record, Visitor, Word};
use pointcore_spec::core_b::{Config, ports};
use std::sync::Arc;

/// The memory's port for points.
const POINTS: usize = 0;
/// Cycles between two reports of progress.
const PROGRESS_INTERVAL_CYCLES: u64 = 1024;
/// Cycles without a transfer after which a core counts as stuck: the longest search among cached points takes fewer.
const QUIET_CYCLES: u64 = 1_000_000;

/// What a run counted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counters {
    /// Cycles from the first query offered to the last result.
    pub cycles: u64,
    /// Cycles in which the core reported each of [`ports::events`].
    pub events: Vec<(&'static str, u64)>,
    /// Requests to the memory.
    pub requests: u64,
    /// Beats taken from the memory.
    pub beats: u64,
    /// Bytes that the memory moved, whole bursts.
    pub bytes: u64,
    /// Cycles in which a beat was on offer and not taken.
    pub beat_wait: u64,
    /// Cycles in which a query was on offer and not taken.
    pub query_wait: u64,
    /// Neighbors found.
    pub neighbors: u64,
}

impl Counters {
    /// The count of an event; 0 for one that this core does not have.
    #[must_use]
    pub fn event(&self, name: &str) -> u64 {
        self.events.iter().find(|(event, _)| *event == name).map_or(0, |(_, count)| *count)
    }
}

/// Why a host has finished.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Every query is answered.
    Answered,
    /// Nothing has moved for too long.
    Stuck,
}

/// What a host works on.
#[derive(Clone, Copy)]
pub struct Work<'a> {
    /// The hardware's configuration.
    pub config: &'a Config,
    /// The tree and its points.
    pub tree: &'a Tree,
    /// What to ask; numbers are given by the host.
    pub queries: &'a [Query],
    /// How the memory answers.
    pub memory: MemorySettings,
}

/// The host as a stimulus: it sees the outputs of the cycle before.
#[derive(Clone)]
pub struct Host<'a> {
    work: Work<'a>,
    stalls: Stalls,
    progress: Progress<'a>,
    writes: Arc<[TreeWrite]>,
    memory: Memory<Fetch>,
    inputs: In,
    sent: usize,
    /// Numbers under way with the indices of their queries.
    under_way: Vec<(u32, usize)>,
    answered: usize,
    last_transfer: u64,
    quiet_cycles: u64,
    /// Whether and how it ended.
    pub end: Option<End>,
    /// Neighbors by query.
    pub neighbors: Vec<Vec<Neighbor>>,
    /// Counts so far.
    pub counters: Counters,
}

impl<'a> Host<'a> {
    /// A host that asks each query once; `stalls` says when it holds back, `seed` orders the memory's answers.
    #[must_use]
    pub fn new(work: Work<'a>, stalls: Stalls, seed: u64, progress: Progress<'a>) -> Self {
        let Work { config, tree, queries, memory } = work;
        let memory = Memory::new(memory, 1, tree.beat_bytes(), seed);
        let longest =
            memory.answer_cycles(Extent { beats: config.bucket.div_ceil(config.lanes), beat_bytes: tree.beat_bytes() });
        let events = ports::events(config).into_iter().map(|event| (event, 0)).collect();
        Self {
            work,
            stalls,
            progress,
            writes: tree.writes().collect(),
            memory,
            inputs: In::default(),
            sent: 0,
            under_way: Vec::new(),
            answered: 0,
            last_transfer: 0,
            quiet_cycles: QUIET_CYCLES + longest,
            end: None,
            neighbors: vec![Vec::new(); queries.len()],
            counters: Counters { events, ..Counters::default() },
        }
    }

    /// The inputs of the present cycle.
    #[must_use]
    pub const fn inputs(&self) -> &In {
        &self.inputs
    }

    /// Queries answered so far.
    #[must_use]
    pub const fn answered(&self) -> usize {
        self.answered
    }

    /// Sets the inputs of `cycle`, seeing the outputs of the cycle before.
    pub fn drive(&mut self, cycle: u64, outputs: &Out) -> Flow {
        let first_query_cycle = self.writes.len() as u64;
        if cycle > first_query_cycle {
            self.account(cycle - 1, outputs);
        } else {
            self.last_transfer = cycle;
        }
        if self.answered == self.work.queries.len() {
            self.end = Some(End::Answered);
        } else if cycle - self.last_transfer > self.quiet_cycles {
            self.end = Some(End::Stuck);
        }
        if self.end.is_some() {
            self.counters.cycles = cycle.saturating_sub(first_query_cycle);
            self.counters.requests = self.memory.requests_taken;
            self.counters.bytes = self.memory.bytes;
            return Flow::Done;
        }
        if cycle.is_multiple_of(PROGRESS_INTERVAL_CYCLES) {
            (self.progress)(cycle, self.answered as f64 / self.work.queries.len() as f64);
        }
        self.inputs.tree = self.writes.get(cycle as usize).copied();
        if cycle >= first_query_cycle {
            self.offer(cycle, outputs);
        }
        Flow::Continue
    }

    /// Accounts for what moved in `cycle`.
    fn account(&mut self, cycle: u64, outputs: &Out) {
        let mut moved = false;
        if self.inputs.query.is_some() {
            moved |= outputs.query_ready;
            self.sent += usize::from(outputs.query_ready);
            self.counters.query_wait += u64::from(!outputs.query_ready);
        }
        if let Some(fetch) = outputs.fetch.filter(|_| self.inputs.fetch_ready) {
            moved = true;
            let extent = Extent { beats: fetch.beats.into(), beat_bytes: self.work.tree.beat_bytes() };
            self.memory.request(POINTS, fetch, extent, cycle);
        }
        if self.inputs.beat.is_some() {
            self.counters.beat_wait += u64::from(!outputs.beat_ready);
            if outputs.beat_ready {
                moved = true;
                self.counters.beats += 1;
                self.memory.take(POINTS);
            }
        }
        if outputs.result.is_some() && self.inputs.result_ready {
            moved = true;
            self.collect(outputs);
        }
        let mut outputs = *outputs;
        let shape = Shape::new(self.work.config);
        outputs.visit(shape, &mut EventCounter(self.counters.events.iter_mut()));
        if moved {
            self.last_transfer = cycle;
        }
    }

    fn collect(&mut self, outputs: &Out) {
        let Some(CachedResult { result, .. }) = outputs.result else { return };
        let place = self.under_way.iter().position(|(number, _)| *number == result.number);
        let place = place.expect("results bear the number of a query under way");
        let query = self.under_way[place].1;
        if result.found {
            let point = self.work.tree.source(result.index).expect("neighbors are points, not places without one");
            let distance2 = decode(self.work.config.geometry, result.distance2);
            self.neighbors[query].push(Neighbor { point, distance2 });
            self.counters.neighbors += 1;
        }
        if result.last {
            self.under_way.swap_remove(place);
            self.answered += 1;
        }
    }

    /// Offers what there is, unless the stalls hold it back; an offer once made stands.
    fn offer(&mut self, cycle: u64, outputs: &Out) {
        if self.inputs.query.is_none() || outputs.query_ready {
            self.inputs.query = self.next_query().map(CachedQuery::from);
        }
        self.memory.advance(cycle);
        if self.inputs.beat.is_none() || outputs.beat_ready {
            let beat = self.memory.offer(POINTS, cycle).filter(|_| !self.stalls.stalled());
            self.inputs.beat = beat.map(|(fetch, number)| self.beat(fetch, number));
        }
        self.inputs.fetch_ready = !self.stalls.stalled();
        self.inputs.result_ready = !self.stalls.stalled();
    }

    /// The next query, unless its number is under way: numbers repeat.
    fn next_query(&mut self) -> Option<Query> {
        let query = *self.work.queries.get(self.sent)?;
        let number = (self.sent as u64 & ((1 << self.work.config.index_bits) - 1)) as u32;
        let free = self.under_way.iter().all(|(other, _)| *other != number);
        (free && !self.stalls.stalled()).then(|| {
            self.under_way.push((number, self.sent));
            Query { number, ..query }
        })
    }

    fn beat(&self, fetch: Fetch, number: u32) -> Beat {
        let address = fetch.address + number;
        let place = BeatPlace { thread: fetch.thread, address, last: number + 1 == u32::from(fetch.beats) };
        let mut beat = Beat { place, ..Beat::default() };
        let points = self.work.tree.beat(address);
        beat.points[..points.len()].copy_from_slice(points);
        beat
    }
}

/// Adds up the fields named after events, which come in the order of [`ports::events`].
struct EventCounter<'a>(std::slice::IterMut<'a, (&'static str, u64)>);

impl Visitor for EventCounter<'_> {
    #[inline]
    fn field(&mut self, name: &str, value: &mut impl Word) {
        if name.starts_with("event_") {
            let (event, count) = self.0.next().expect("the core has the events of its configuration");
            debug_assert_eq!(*event, name);
            *count += value.to_word();
        }
    }

    fn fields(&mut self, _name: &str, _values: &mut [u32]) {}

    fn prefix(&mut self, _prefix: &'static str) {}
}

/// The host at the core's ports, a word each.
impl Stimulus for Host<'_> {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let shape = Shape::new(self.work.config);
        let flow = Host::drive(self, cycle, &unit::read(shape, outputs));
        // The reset comes first.
        unit::write(shape, self.inputs, &mut inputs[1..]);
        flow
    }
}
