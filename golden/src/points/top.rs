//! The search and the process core behind it, wired up cycle for cycle.

use crate::unit::Model;
use crate::{process, search};
use pointcore_contract::points::Config;
use pointcore_contract::points::units::Events;
pub use pointcore_contract::points::units::top::{In, Out};
use pointcore_contract::process::queries::{Found, Wanted};
use pointcore_contract::process::records::Thread;
use pointcore_contract::search::records::{CachedQuery, CachedResult, Query};

/// Lengths of the pipelines.
#[derive(Clone, Copy, Debug)]
pub struct Latencies {
    /// Of the search.
    pub search: search::Latencies,
    /// Of the blocks beside `kernel`.
    pub blocks: process::Latencies,
    /// Of `kernel`.
    pub kernel: process::KernelPipelines,
}

/// The point processor.
#[derive(Clone, Debug)]
pub struct Top {
    search: search::Top,
    process: process::Top,
}

impl Top {
    /// The core after reset, with pipelines of the given lengths.
    #[must_use]
    pub fn new(config: &Config, latencies: Latencies) -> Self {
        Self {
            search: search::Top::new(&config.search, latencies.search),
            process: process::Top::new(&config.process, latencies.blocks, latencies.kernel),
        }
    }
}

/// A thread's search.
fn asked(wanted: Wanted, inputs: &In) -> CachedQuery {
    let neighborhood = inputs.search;
    let (number, k, radius2) = (u32::from(wanted.thread.thread), neighborhood.k, neighborhood.radius2);
    CachedQuery { query: Query { number, k, radius2, point: wanted.position }, reach: neighborhood.reach }
}

/// What a search found, by the thread that wanted it.
fn found(CachedResult { result, .. }: CachedResult) -> Found {
    let thread = Thread { thread: u8::try_from(result.number).expect("a search bears its thread as its number") };
    Found { thread, last: result.last, found: result.found, index: result.index }
}

impl Model for Top {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let search = self.search.outputs();
        let process = self.process.outputs();
        Out {
            lookup: search.lookup,
            record_ready: search.record_ready,
            query_ready: process.query_ready,
            fetch: search.fetch,
            beat_ready: search.beat_ready,
            line: process.fetch,
            fill_ready: process.fill_ready,
            result: process.result,
            idle: process.idle,
            events: Events { search: search.events, process: process.events },
        }
    }

    fn clock(&mut self, inputs: &In) {
        let search = self.search.outputs();
        let process = self.process.outputs();
        self.search.clock(&search::top::In {
            tree: inputs.tree,
            lookup_ready: inputs.lookup_ready,
            record: inputs.record,
            setup: inputs.setup,
            query: process.wanted.map(|wanted| asked(wanted, inputs)),
            fetch_ready: inputs.fetch_ready,
            beat: inputs.beat,
            result_ready: process.found_ready,
        });
        self.process.clock(&process::top::In {
            settings: inputs.settings,
            iterations_max: inputs.iterations_max,
            forget: false,
            query: inputs.query,
            wanted_ready: search.query_ready,
            found: search.result.map(found),
            fetch_ready: inputs.line_ready,
            fill: inputs.fill,
            result_ready: inputs.result_ready,
        });
    }
}
