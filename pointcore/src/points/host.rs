//! The host around the point processor: loads the tree, streams queries, plays the memories, collects results, counts.

use super::counters::PointsCounters;
use crate::generated::Progress;
use crate::memory::{ExternalMemory, MemorySettings, RequestSize};
use crate::number::encode;
use crate::process::Answer;
use crate::search::{QueryKind, Reuse, Tree};
use pointcore_contract::points::Config;
use pointcore_contract::points::units::Neighborhood;
use pointcore_contract::points::units::top::{In, Out};
use pointcore_contract::process::config::WORDS_MAX;
use pointcore_contract::process::queries::{Outcome, Query, QueryWords};
use pointcore_contract::process::records::{LineFetch, Neighbor, Settings};
use pointcore_contract::search::records::{Beat, BeatPlace, CacheSetup, Fetch, Lookup, TreeRecord, TreeWrite};
use pointcore_contract::{read, width, write};
use pointcore_tb::lockstep::{Flow, Stalls, Stimulus};
use std::collections::HashMap;
use std::sync::Arc;

/// The memory's ports: positions for the search, records of the tree, lines of points for the program.
const POSITIONS: usize = 0;
const TREE: usize = 1;
const LINES: usize = 2;
const PORTS: usize = 3;
/// Cycles between two reports of progress.
const PROGRESS_INTERVAL_CYCLES: u64 = 1024;
/// Cycles without a transfer after which a core counts as stuck: the longest search and the longest block take fewer.
const QUIET_CYCLES: u64 = 1_000_000;

/// What is asked of the program.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    /// A word for each of the settings'.
    pub settings: &'a [u32],
    /// Iterations of a query at most, at least one.
    pub iterations: u32,
    /// The words of each query.
    pub queries: &'a [Vec<u32>],
    /// The words of each point as a neighbor, by the user's index.
    pub points: &'a [Vec<u32>],
    /// Neighbors of a query at most.
    pub k: u32,
    /// Only neighbors nearer than this count.
    pub radius: Option<f32>,
}

/// What a host works on.
#[derive(Clone, Copy)]
pub struct Work<'a> {
    /// The hardware's configuration.
    pub config: &'a Config,
    /// The tree and its points.
    pub tree: &'a Tree,
    /// The program's part.
    pub task: Task<'a>,
    /// What the neighbor cache may answer, if there is one.
    pub reuse: Reuse,
    /// How the memory answers.
    pub memory: MemorySettings,
}

impl Work<'_> {
    /// What every search asks for: with a neighbor cache one neighbor more, whose distance tells how far a neighborhood reaches.
    fn neighborhood(&self) -> Neighborhood {
        let (format, has_cache) = (self.config.search.geometry, self.config.search.neighbor_cache > 0);
        let Task { k, radius, .. } = self.task;
        let searched = if has_cache && radius.is_none() { k + 1 } else { k };
        let extension = if has_cache { self.reuse.alpha } else { 1.0 };
        let radius2 = radius.map_or(f32::INFINITY, |radius| (radius * extension) * (radius * extension));
        let k = u8::try_from(searched).expect("the hardware holds at most 64 neighbors");
        Neighborhood { k, radius2: encode(format, radius2), reach: encode(format, radius.unwrap_or(0.0)) }
    }

    fn setup(&self) -> Option<CacheSetup> {
        let kind = if self.task.radius.is_some() { QueryKind::Ball } else { QueryKind::Nearest };
        (self.config.search.neighbor_cache > 0).then(|| self.reuse.setup(self.config.search.geometry, kind))
    }

    fn point_bytes(&self) -> u32 {
        width::<Neighbor>(&self.config.process).div_ceil(u8::BITS)
    }
}

/// What a request to the memory asks for.
#[derive(Clone, Copy, Debug)]
enum Request {
    Positions(Fetch),
    Record(Lookup),
    Line(LineFetch),
}

/// The host as a stimulus: it sees the outputs of the cycle before.
#[derive(Clone)]
pub(super) struct PointsHost<'a> {
    work: Work<'a>,
    stalls: Stalls,
    progress: Progress<'a>,
    writes: Arc<[TreeWrite]>,
    first_query_cycle: u64,
    memory: ExternalMemory<Request>,
    inputs: In,
    sent: usize,
    /// Queries under way by their numbers, which repeat.
    under_way: HashMap<u32, usize>,
    answers: Vec<Option<Answer>>,
    pub answered: usize,
    last_transfer: u64,
    /// Nothing has moved for too long.
    pub is_stuck: bool,
    pub counters: PointsCounters,
}

/// A record of words from a slice.
fn padded(words: &[u32]) -> [u32; WORDS_MAX] {
    let mut padded = [0; WORDS_MAX];
    padded[..words.len()].copy_from_slice(words);
    padded
}

impl<'a> PointsHost<'a> {
    pub fn new(work: Work<'a>, stalls: Stalls, seed: u64, progress: Progress<'a>) -> Self {
        let Work { config, tree, task, .. } = work;
        let has_cache = config.search.tree_cache > 0;
        let writes: Arc<[TreeWrite]> = if has_cache { Arc::default() } else { tree.writes().collect() };
        let lines = config.process.cache_lines.max(config.search.tree_cache);
        let inputs = In {
            search: work.neighborhood(),
            settings: Settings { words: padded(task.settings) },
            iterations_max: u16::try_from(task.iterations).expect("a core counts up to 65535 iterations"),
            ..In::default()
        };
        Self {
            work,
            stalls,
            progress,
            // Caches clear a line a cycle.
            first_query_cycle: (writes.len() as u64).max(lines.into()) + 1,
            writes,
            memory: ExternalMemory::new(work.memory, PORTS, tree.beat_bytes(), seed).ordered(LINES),
            inputs,
            sent: 0,
            under_way: HashMap::new(),
            answers: vec![None; task.queries.len()],
            answered: 0,
            last_transfer: 0,
            is_stuck: false,
            counters: PointsCounters::new(config),
        }
    }

    pub const fn inputs(&self) -> &In {
        &self.inputs
    }

    pub fn into_results(self) -> (Vec<Answer>, PointsCounters) {
        (self.answers.into_iter().map(|answer| answer.expect("every query has left")).collect(), self.counters)
    }

    /// Sets the inputs of `cycle`, seeing the outputs of the cycle before.
    pub fn drive(&mut self, cycle: u64, outputs: &Out) -> Flow {
        if cycle > self.first_query_cycle {
            self.account(cycle - 1, outputs);
        } else {
            self.last_transfer = cycle;
        }
        self.is_stuck = cycle - self.last_transfer > QUIET_CYCLES;
        let queries = self.work.task.queries.len();
        if self.answered == queries || self.is_stuck {
            self.counters.cycles = cycle.saturating_sub(self.first_query_cycle);
            self.counters.bytes = self.memory.bus().bytes();
            return Flow::Done;
        }
        if cycle.is_multiple_of(PROGRESS_INTERVAL_CYCLES) {
            (self.progress)(cycle, self.answered as f64 / queries as f64);
        }
        self.inputs.tree = self.writes.get(cycle as usize).copied();
        self.inputs.setup = self.work.setup().filter(|_| cycle + 1 == self.first_query_cycle);
        if cycle >= self.first_query_cycle {
            self.offer(cycle, outputs);
        }
        Flow::Continue
    }

    /// Accounts for what moved in `cycle`.
    fn account(&mut self, cycle: u64, outputs: &Out) {
        let query = self.inputs.query.is_some();
        let query_moved = query && outputs.query_ready;
        self.sent += usize::from(query_moved);
        self.counters.query_wait += u64::from(query && !query_moved);
        let taken = [
            (POSITIONS, self.inputs.beat.is_some() && outputs.beat_ready),
            (TREE, self.inputs.record.is_some() && outputs.record_ready),
            (LINES, self.inputs.fill.is_some() && outputs.fill_ready),
        ];
        taken.into_iter().filter(|(_, moved)| *moved).for_each(|(port, _)| self.memory.take(port));
        let asked = self.requests(cycle, outputs);
        let result = outputs.result.filter(|_| self.inputs.result_ready);
        if let Some(result) = result {
            self.collect(&result);
        }
        self.counters.events.count(self.work.config, outputs.events);
        if query_moved || asked || result.is_some() || taken.into_iter().any(|(_, moved)| moved) {
            self.last_transfer = cycle;
        }
    }

    /// Hands requests to the memory; returns whether there are any.
    fn requests(&mut self, cycle: u64, outputs: &Out) -> bool {
        let Work { config, tree, .. } = self.work;
        let fetch = outputs.fetch.filter(|_| self.inputs.fetch_ready);
        let lookup = outputs.lookup.filter(|_| self.inputs.lookup_ready);
        let line = outputs.line.filter(|_| self.inputs.line_ready);
        let size = |beats, beat_bytes| RequestSize { beats, beat_bytes };
        let requests = [
            fetch.map(|fetch| (POSITIONS, Request::Positions(fetch), size(fetch.beats.into(), tree.beat_bytes()))),
            lookup.map(|lookup| (TREE, Request::Record(lookup), size(1, Tree::record_bytes(&config.search)))),
            line.map(|line| (LINES, Request::Line(line), size(config.process.line_points, self.work.point_bytes()))),
        ];
        for (port, request, size) in requests.into_iter().flatten() {
            self.memory.request(port, request, size, cycle);
        }
        fetch.is_some() || lookup.is_some() || line.is_some()
    }

    fn collect(&mut self, outcome: &Outcome) {
        let index = self.under_way.remove(&outcome.number).expect("results bear the number of a query under way");
        let words = self.work.config.process.program.outputs.len();
        self.answers[index] = Some(Answer {
            outputs: outcome.outputs.words[..words].to_vec(),
            iterations: outcome.iterations.into(),
            capped: outcome.capped,
            neighbors: None,
        });
        self.answered += 1;
    }

    /// Offers what there is, unless the stalls hold it back; an offer once made stands.
    fn offer(&mut self, cycle: u64, outputs: &Out) {
        if self.inputs.query.is_none() || outputs.query_ready {
            self.inputs.query = self.next_query();
        }
        self.memory.advance(cycle);
        if self.inputs.beat.is_none() || outputs.beat_ready {
            let beat = self.memory.offer(POSITIONS, cycle).filter(|_| !self.stalls.stalled());
            self.inputs.beat = beat.and_then(|(request, number)| self.beat(request, number));
        }
        if self.inputs.record.is_none() || outputs.record_ready {
            let record = self.memory.offer(TREE, cycle).filter(|_| !self.stalls.stalled());
            self.inputs.record = record.and_then(|(request, _)| self.record(request));
        }
        if self.inputs.fill.is_none() || outputs.fill_ready {
            let point = self.memory.offer(LINES, cycle).filter(|_| !self.stalls.stalled());
            self.inputs.fill = point.and_then(|(request, number)| self.point(request, number));
        }
        for ready in [
            &mut self.inputs.fetch_ready,
            &mut self.inputs.lookup_ready,
            &mut self.inputs.line_ready,
            &mut self.inputs.result_ready,
        ] {
            *ready = !self.stalls.stalled();
        }
    }

    /// The next query, unless its number is under way.
    fn next_query(&mut self) -> Option<Query> {
        let words = self.work.task.queries.get(self.sent)?;
        let number = (self.sent as u64 & ((1 << self.work.config.process.index_bits) - 1)) as u32;
        if self.under_way.contains_key(&number) || self.stalls.stalled() {
            return None;
        }
        self.under_way.insert(number, self.sent);
        Some(Query { number, words: QueryWords { words: padded(words) } })
    }

    fn beat(&self, request: Request, number: u32) -> Option<Beat> {
        let Request::Positions(fetch) = request else { return None };
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

    /// A point of a line; zeros where the search's memory has none.
    fn point(&self, request: Request, number: u32) -> Option<Neighbor> {
        let Request::Line(LineFetch { line }) = request else { return None };
        let place = line * self.work.config.process.line_points + number;
        let words =
            self.work.tree.source(place).map_or([0; WORDS_MAX], |index| padded(&self.work.task.points[index as usize]));
        Some(Neighbor { words })
    }
}

/// The host at the core's ports, a word each.
impl Stimulus for PointsHost<'_> {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        let config = self.work.config;
        let flow = PointsHost::drive(self, cycle, &read(config, outputs));
        // The reset comes first.
        write(config, self.inputs, &mut inputs[1..]);
        flow
    }
}
