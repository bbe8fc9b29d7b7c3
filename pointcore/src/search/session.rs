//! Neighbor search as a library: a tree, a core, queries in, neighbors out.

use super::generate::SearchCore;
use super::order::interleaved;
use super::query::{Query, check_alike};
use super::reuse::{QueryKind, Reuse};
use super::run::{SearchOutcome, SearchRunner};
use super::work::Work;
use super::{SearchError, Tree};
use crate::generated::Progress;
use crate::generated::verilate;
use crate::memory::MemorySettings;
use crate::waveform::Waveform;
use pointcore_contract::search::Config;
use pointcore_tb::lockstep::Stall;
use pointcore_tb::verilated::{Library, Trace};
use rayon::prelude::*;
use std::sync::Arc;

/// What answers queries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SearchEngine {
    /// The bit-exact, cycle-accurate golden model.
    Golden,
    /// The generated Verilog under Verilator.
    Hardware,
    /// Both, every output compared in every cycle.
    Lockstep,
}

/// A core with a tree.
///
/// ```
/// use pointcore::search::{MemorySettings, PointSet, Query, SearchEngine, Session, Splitting, Tree};
/// use pointcore_contract::search::Config;
///
/// let config = Config { tree_depth: 4, bucket: 8, ..Config::default() };
/// let corners = (0..8_u8).map(|corner| [corner & 1, corner >> 1 & 1, corner >> 2].map(f32::from));
/// let points = PointSet::new(config.geometry, &corners.collect::<Vec<_>>())?;
/// let tree = Tree::build(&config, &points, Splitting::Median)?;
/// let session = Session::open(config, tree, MemorySettings::default(), SearchEngine::Golden)?;
///
/// let query = Query { point: [0.9, 0.3, 0.0], k: 2, radius: None };
/// let outcome = session.search(&[query])?;
/// let nearest: Vec<u32> = outcome.neighbors[0].iter().map(|neighbor| neighbor.point).collect();
/// assert_eq!(nearest, [1, 3]);
/// assert!(outcome.counters.cycles > 0);
/// # Ok::<(), pointcore::search::SearchError>(())
/// ```
pub struct Session {
    config: Config,
    tree: Tree,
    memory: MemorySettings,
    core: SearchCore,
    /// The verilated core, unless the golden model answers alone.
    library: Option<Arc<Library>>,
    engine: SearchEngine,
    reuse: Reuse,
    /// Runs of queries that take turns.
    runs: usize,
    stall: Stall,
    seed: u64,
    reproduce: String,
    waveform: Option<Waveform>,
}

impl Session {
    /// Generates the core of a configuration, and verilates it if it is to run. The tree must have been built for the same
    /// configuration.
    ///
    /// # Errors
    /// Configuration or memory settings are not valid, or tools are missing or fail.
    pub fn open(config: Config, tree: Tree, memory: MemorySettings, engine: SearchEngine) -> Result<Self, SearchError> {
        config.validate()?;
        memory.validate()?;
        tree.check(&config)?;
        let core = SearchCore::generate(&config)?;
        let library = if engine == SearchEngine::Golden { None } else { Some(verilate(&core.design, Trace::Off)?) };
        let (reuse, runs, stall, seed, reproduce) = (Reuse::default(), 1, Stall::Never, 1, String::new());
        Ok(Self { config, tree, memory, core, library, engine, reuse, runs, stall, seed, reproduce, waveform: None })
    }

    /// As [`Session::open`] on the hardware, of which a waveform is written.
    ///
    /// # Errors
    /// As [`Session::open`].
    pub fn open_traced(
        config: Config,
        tree: Tree,
        memory: MemorySettings,
        waveform: Waveform,
    ) -> Result<Self, SearchError> {
        let golden = Self::open(config, tree, memory, SearchEngine::Golden)?;
        let library = Some(verilate(&golden.core.design, Trace::On)?);
        Ok(Self { library, engine: SearchEngine::Hardware, waveform: Some(waveform), ..golden })
    }

    /// Holds streams back at random, chooses among answers of the memory and the hardware's uninitialized values.
    #[must_use]
    pub fn randomized(mut self, stall: Stall, seed: u64) -> Self {
        (self.stall, self.seed) = (stall, seed);
        self
    }

    /// Lets the neighbor cache answer within these limits.
    ///
    /// # Errors
    /// A factor has no meaning.
    pub fn reusing(mut self, reuse: Reuse) -> Result<Self, SearchError> {
        reuse.validate()?;
        self.reuse = reuse;
        Ok(self)
    }

    /// Cuts the queries of a search into so many runs of equal length that take turns, so that near ones are not under way together
    /// (thesis 6.6.3); the answers stay in the order of the queries.
    #[must_use]
    pub fn interleaved(mut self, runs: usize) -> Self {
        self.runs = runs;
        self
    }

    /// The command to print when hardware and model differ.
    #[must_use]
    pub fn reproduced_by(mut self, command: String) -> Self {
        self.reproduce = command;
        self
    }

    /// The core.
    #[must_use]
    pub const fn core(&self) -> &SearchCore {
        &self.core
    }

    /// The tree.
    #[must_use]
    pub const fn tree(&self) -> &Tree {
        &self.tree
    }

    /// Asks queries one after the other; as many are under way at a time as the core has threads.
    ///
    /// # Errors
    /// A query has no meaning; hardware and model differ; the core is stuck.
    pub fn search(&self, queries: &[Query]) -> Result<SearchOutcome, SearchError> {
        self.search_with(queries, &|_, _| {})
    }

    /// As [`Session::search`], and tells of the progress.
    ///
    /// # Errors
    /// As [`Session::search`].
    pub fn search_with(&self, queries: &[Query], progress: Progress) -> Result<SearchOutcome, SearchError> {
        check_alike(&self.config, queries)?;
        let kind = queries.first().map_or(QueryKind::Nearest, Query::kind);
        let encode = |(index, query): (usize, &Query)| query.encode(&self.config, self.reuse, index);
        let queries = queries.par_iter().enumerate().map(encode).collect::<Result<Vec<_>, SearchError>>()?;
        let order = interleaved(queries.len(), self.runs);
        let queries: Vec<_> = order.iter().map(|query| queries[*query]).collect();
        let work = Work {
            config: &self.config,
            tree: &self.tree,
            queries: &queries,
            reuse: self.reuse,
            kind,
            memory: self.memory,
        };
        let runner = SearchRunner { work, stall: self.stall, seed: self.seed, progress, reproduce: &self.reproduce };
        let mut outcome = match (self.engine, &self.library) {
            (SearchEngine::Hardware, Some(library)) => runner.hardware(library, self.waveform.as_ref()),
            (SearchEngine::Lockstep, Some(library)) => runner.lockstep(&self.core, library),
            _ => runner.golden(&self.core),
        }?;
        let mut neighbors = vec![Vec::new(); order.len()];
        let mut cycles = vec![0; order.len()];
        for ((query, found), taken) in order.into_iter().zip(outcome.neighbors).zip(outcome.query_cycles) {
            (neighbors[query], cycles[query]) = (found, taken);
        }
        (outcome.neighbors, outcome.query_cycles) = (neighbors, cycles);
        Ok(outcome)
    }
}
