//! The host around the search core: loads the tree, streams queries, plays the point memory, collects results, counts.

use super::Tree;
use super::answers::Answers;
use super::counters::SearchCounters;
use super::query::Neighbor;
use super::work::Work;
use crate::generated::Progress;
use crate::memory::{ExternalMemory, RequestSize};
use pointcore_contract::search::records::{Beat, BeatPlace, CacheSetup, Fetch, Lookup, TreeRecord, TreeWrite};
use pointcore_contract::{read, write};
use pointcore_golden::search::top::{In, Out};
use pointcore_tb::lockstep::{Flow, Stalls, Stimulus};
use std::sync::Arc;

/// The memory's port for points.
const POINTS: usize = 0;
/// The memory's port for records of the tree.
const TREE: usize = 1;
/// The memory's ports.
const PORTS: usize = 2;
/// Cycles between two reports of progress.
const PROGRESS_INTERVAL_CYCLES: u64 = 1024;
/// Cycles without a transfer after which a core counts as stuck: the longest search among cached points takes fewer.
const QUIET_CYCLES: u64 = 1_000_000;

/// Why a host has finished.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Every query is answered.
    Answered,
    /// Nothing has moved for too long.
    Stuck,
}

/// What a request to the memory asks for.
#[derive(Clone, Copy, Debug)]
enum Request {
    Points(Fetch),
    Record(Lookup),
}

/// The host as a stimulus: it sees the outputs of the cycle before.
#[derive(Clone)]
pub struct SearchHost<'a> {
    work: Work<'a>,
    stalls: Stalls,
    progress: Progress<'a>,
    writes: Arc<[TreeWrite]>,
    setup: Option<CacheSetup>,
    first_query_cycle: u64,
    memory: ExternalMemory<Request>,
    inputs: In,
    sent: usize,
    last_transfer: u64,
    quiet_cycles: u64,
    answers: Answers<'a>,
    /// Whether and how it ended.
    pub end: Option<End>,
    /// Counts so far.
    pub counters: SearchCounters,
}

impl<'a> SearchHost<'a> {
    /// A host that asks each query once; `stalls` says when it holds back, `seed` orders the memory's answers.
    #[must_use]
    pub fn new(work: Work<'a>, stalls: Stalls, seed: u64, progress: Progress<'a>) -> Self {
        let Work { config, tree, memory, .. } = work;
        let memory = ExternalMemory::new(memory, PORTS, tree.beat_bytes(), seed);
        let beats = config.bucket.div_ceil(config.lanes);
        let longest = memory.answer_cycles(RequestSize { beats, beat_bytes: tree.beat_bytes() });
        let writes: Arc<[TreeWrite]> = if config.tree_cache > 0 { Arc::default() } else { tree.writes().collect() };
        let setup = (config.neighbor_cache > 0).then(|| work.reuse.setup(config.geometry, work.kind));
        Self {
            work,
            stalls,
            progress,
            setup,
            // A tree cache clears a line a cycle.
            first_query_cycle: (writes.len() as u64).max(config.tree_cache.into()) + 1,
            writes,
            memory,
            inputs: In::default(),
            sent: 0,
            last_transfer: 0,
            quiet_cycles: QUIET_CYCLES + longest,
            answers: Answers::new(work),
            end: None,
            counters: SearchCounters::new(config),
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
        self.answers.answered()
    }

    /// Queries to be answered.
    #[must_use]
    pub const fn queries(&self) -> usize {
        self.work.queries.len()
    }

    /// What the host counted, and the neighbors and the cycles by query.
    #[must_use]
    pub fn into_results(self) -> (SearchCounters, Vec<Vec<Neighbor>>, Vec<u32>) {
        let (neighbors, cycles) = self.answers.into_results();
        (self.counters, neighbors, cycles)
    }

    /// Sets the inputs of `cycle`, seeing the outputs of the cycle before.
    pub fn drive(&mut self, cycle: u64, outputs: &Out) -> Flow {
        if cycle > self.first_query_cycle {
            self.account(cycle - 1, outputs);
        } else {
            self.last_transfer = cycle;
        }
        if self.answered() == self.queries() {
            self.end = Some(End::Answered);
        } else if cycle - self.last_transfer > self.quiet_cycles {
            self.end = Some(End::Stuck);
        }
        if self.end.is_some() {
            self.counters.cycles = cycle.saturating_sub(self.first_query_cycle);
            self.counters.requests = self.memory.requests_taken;
            self.counters.bytes = self.memory.bus().bytes();
            return Flow::Done;
        }
        if cycle.is_multiple_of(PROGRESS_INTERVAL_CYCLES) {
            (self.progress)(cycle, self.answered() as f64 / self.queries() as f64);
        }
        self.inputs.tree = self.writes.get(cycle as usize).copied();
        self.inputs.setup = self.setup.filter(|_| cycle + 1 == self.first_query_cycle);
        if cycle >= self.first_query_cycle {
            self.offer(cycle, outputs);
        }
        Flow::Continue
    }

    /// Accounts for what moved in `cycle`.
    fn account(&mut self, cycle: u64, outputs: &Out) {
        let query = self.inputs.query.is_some();
        let [query_moved, query_waits] = [query && outputs.query_ready, query && !outputs.query_ready];
        let beat = self.inputs.beat.is_some();
        let [beat_moved, beat_waits] = [beat && outputs.beat_ready, beat && !outputs.beat_ready];
        let record_moved = self.inputs.record.is_some() && outputs.record_ready;
        self.sent += usize::from(query_moved);
        let counts = [
            (&mut self.counters.query_wait, query_waits),
            (&mut self.counters.beat_wait, beat_waits),
            (&mut self.counters.beats, beat_moved),
            (&mut self.counters.records, record_moved),
        ];
        counts.into_iter().for_each(|(count, happened)| *count += u64::from(happened));
        if beat_moved {
            self.memory.take(POINTS);
        }
        if record_moved {
            self.memory.take(TREE);
        }
        let fetch = outputs.fetch.filter(|_| self.inputs.fetch_ready);
        if let Some(fetch) = fetch {
            let extent = RequestSize { beats: fetch.beats.into(), beat_bytes: self.work.tree.beat_bytes() };
            self.memory.request(POINTS, Request::Points(fetch), extent, cycle);
        }
        let lookup = outputs.lookup.filter(|_| self.inputs.lookup_ready);
        if let Some(lookup) = lookup {
            let extent = RequestSize { beats: 1, beat_bytes: Tree::record_bytes(self.work.config) };
            self.memory.request(TREE, Request::Record(lookup), extent, cycle);
        }
        let result = outputs.result.filter(|_| self.inputs.result_ready);
        if let Some(result) = result {
            self.counters.results += u64::from(result.result.found);
            self.answers.collect(result, cycle);
        }
        self.counters.count(self.work.config, outputs.events);
        if query_moved || beat_moved || record_moved || fetch.is_some() || lookup.is_some() || result.is_some() {
            self.last_transfer = cycle;
        }
    }

    /// Offers what there is, unless the stalls hold it back; an offer once made stands.
    fn offer(&mut self, cycle: u64, outputs: &Out) {
        if self.inputs.query.is_none() || outputs.query_ready {
            self.inputs.query = self.answers.number(self.sent).filter(|_| !self.stalls.stalled());
            if let Some(query) = &self.inputs.query {
                self.answers.offered(query, self.sent, cycle);
            }
        }
        self.memory.advance(cycle);
        if self.inputs.beat.is_none() || outputs.beat_ready {
            let beat = self.memory.offer(POINTS, cycle).filter(|_| !self.stalls.stalled());
            self.inputs.beat = beat.and_then(|(request, number)| self.beat(request, number));
        }
        if self.inputs.record.is_none() || outputs.record_ready {
            let record = self.memory.offer(TREE, cycle).filter(|_| !self.stalls.stalled());
            self.inputs.record = record.and_then(|(request, _)| self.record(request));
        }
        self.inputs.fetch_ready = !self.stalls.stalled();
        self.inputs.lookup_ready = !self.stalls.stalled();
        self.inputs.result_ready = !self.stalls.stalled();
    }

    fn beat(&self, request: Request, number: u32) -> Option<Beat> {
        let Request::Points(fetch) = request else { return None };
        let address = fetch.address + number;
        let place = BeatPlace { thread: fetch.thread, address, last: number + 1 == u32::from(fetch.beats) };
        let mut beat = Beat { place, ..Beat::default() };
        let points = self.work.tree.beat(address);
        beat.points.lane[..points.len()].copy_from_slice(points);
        Some(beat)
    }

    fn record(&self, request: Request) -> Option<TreeRecord> {
        let Request::Record(lookup) = request else { return None };
        Some(self.work.tree.record(lookup))
    }
}

/// The host at the core's ports, a word each.
impl Stimulus for SearchHost<'_> {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let config = self.work.config;
        let flow = SearchHost::drive(self, cycle, &read(config, outputs));
        // The reset comes first.
        write(config, self.inputs, &mut inputs[1..]);
        flow
    }
}
