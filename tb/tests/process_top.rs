//! The whole process core against its model in every cycle, and each query against the interpreter: every program of
//! the library, with models of the search and of the memory that answer late.

use std::cell::RefCell;

use pointcore_contract::process::{Config, stages};
use pointcore_golden::process::{KernelPipelines, Latencies, Pipeline, Top};
use pointcore_hdl::compiler::Options;
use pointcore_hdl::process::top::{self, Core};

use crate::process::cloud::{BLOCK_CYCLES, QUERIES, Queries, Seen};
use crate::process::scene::every_program;
use crate::search::environment::{Feeds, Rule};
use crate::search::{all, lockstep};
use crate::support::cases;

/// Cycles that the memory takes at most.
const MEMORY_CYCLES: u32 = 40;

/// Queries with a search and a memory around them.
#[derive(Clone)]
struct Surroundings {
    config: Config,
    queries: Queries,
}

impl Rule for Surroundings {
    const SEEDS: u64 = 7;

    fn quiet_cycles(&self) -> u64 {
        BLOCK_CYCLES
    }

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        if stream == "fetch" {
            let points = u64::from(self.config.line_points);
            for point in 0..points {
                let cycles = if point == 0 { feeds.random.u32(..MEMORY_CYCLES) } else { 0 };
                let words = self.queries.cloud.point(fields[0] * points + point);
                feeds.feed_after(cycles, "fill", words.into_iter().map(u64::from).collect());
            }
        }
        self.queries.transferred(feeds, stream, fields);
    }
}

#[test]
fn queries_of_every_program_leave_as_the_interpreter_says() {
    for config in cases(every_program()) {
        let Core { module, manifests } =
            top::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let latencies = Latencies {
            init: manifests.get("init").map(|manifest| manifest.latency),
            finish: manifests["final"].latency,
        };
        let [kernel, sums] = ["kernel", "sums"].map(|block| &manifests[block]);
        let [kernel, sums] = [kernel, sums]
            .map(|manifest| Pipeline { latency: manifest.latency, interval: manifest.initiation_interval });
        let model = Top::new(&config, latencies, KernelPipelines { kernel, sums });
        let begin = |feeds: &mut Feeds| {
            feeds.pulse("forget");
            Surroundings { config: config.clone(), queries: Queries::begin(&config, feeds) }
        };
        let seen = RefCell::new(Seen::default());
        lockstep(&config, &module, &model, &stages::top::UNIT, begin, all, |surroundings, report| {
            assert_eq!(report.transfers("result"), QUERIES);
            assert!(report.transfers("fetch") > 0);
            surroundings.queries.finish(&mut seen.borrow_mut());
        });
        seen.into_inner().check(&config);
    }
}
