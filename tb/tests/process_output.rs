//! Output against its model, with queries that are done sooner or later.

use pointcore_contract::process::queries::{Finished, Numbered, Outcome};
use pointcore_contract::process::{Config, stages};
use pointcore_golden::process::Output;
use pointcore_hdl::process::output;

use crate::process::scene::{configs, field, item, place};
use crate::search::environment::{Feeds, Rule};
use crate::search::{all, lockstep};
use crate::support::cases;

const QUERIES: u64 = 200;
/// Iterations after which queries of a run are capped.
const ITERATIONS_MAX: [u64; 3] = [1, 2, 5];
/// Iterations of a query that counts to where all the bits of a count have been set.
const MANY: u64 = 0x8100;
/// A query's blocks take longer.
const BLOCK_CYCLES: u32 = 3;
/// What comes sooner in one run comes later in another: a query may begin in any cycle of another's iteration.
const DELAYS: u32 = 4;

/// Threads that finish iterations, one after the other.
#[derive(Clone)]
struct Queries {
    config: Config,
    iterations_max: u64,
    left: u64,
    /// By thread: the query's number, its complete iterations, whether the last one made it done.
    threads: Vec<(u64, u64, bool)>,
    /// What leaves, in order: number, iterations, capped.
    expected: Vec<[u64; 3]>,
    left_with: Vec<[u64; 3]>,
}

impl Queries {
    fn begin(config: &Config, feeds: &mut Feeds, count: u64, iterations_max: u64) -> Self {
        feeds.hold("iterations_max", iterations_max);
        let threads = vec![(0, 0, false); config.threads as usize];
        let (config, expected, left_with) = (config.clone(), vec![], vec![]);
        let mut queries = Self { config, iterations_max, left: count, threads, expected, left_with };
        (0..queries.config.threads.into()).for_each(|thread| queries.number(feeds, thread));
        queries
    }

    fn number(&mut self, feeds: &mut Feeds, thread: u64) {
        if self.left > 0 {
            self.left -= 1;
            let numbered = item::<Numbered>(&self.config, &[thread], &mut feeds.random);
            self.threads[thread as usize] = (numbered[1], 0, false);
            let delay = feeds.random.u32(..DELAYS);
            feeds.feed_after(1 + delay, "numbered", numbered);
        }
    }

    fn iterate(&self, feeds: &mut Feeds, thread: u64) {
        let mut finished = item::<Finished>(&self.config, &[thread], &mut feeds.random);
        // Some are done before they are capped, and some are not.
        let is_done = self.iterations_max < MANY && feeds.random.u64(..2 * self.iterations_max) == 0;
        finished[place::<Finished>(&self.config, "done")] = u64::from(is_done);
        let delay = feeds.random.u32(..DELAYS);
        feeds.feed_after(BLOCK_CYCLES + delay, "finished", finished);
    }
}

impl Rule for Queries {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "numbered" | "update" => self.iterate(feeds, fields[0]),
            "finished" => {
                let done = field::<Finished>(&self.config, fields, "done") == 1;
                let (number, iterations, _) = &mut self.threads[fields[0] as usize];
                *iterations += 1;
                let capped = !done && *iterations == self.iterations_max;
                if done || capped {
                    self.expected.push([*number, *iterations, capped.into()]);
                }
            }
            "released" => self.number(feeds, fields[0]),
            "result" => {
                let names = ["number", "iterations", "capped"];
                self.left_with.push(names.map(|name| field::<Outcome>(&self.config, fields, name)));
            }
            _ => {}
        }
    }
}

/// The same with one query, which iterates on and on.
#[derive(Clone)]
struct Patient(Queries);

impl Rule for Patient {
    const SEEDS: u64 = 1;

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        self.0.transferred(feeds, stream, fields);
    }
}

#[test]
fn queries_leave_when_they_are_done_or_capped() {
    for config in cases(configs()) {
        let begin = |feeds: &mut Feeds| {
            let iterations_max = ITERATIONS_MAX[feeds.random.usize(..ITERATIONS_MAX.len())];
            Queries::begin(&config, feeds, QUERIES, iterations_max)
        };
        let (module, model) = (output::module(&config), Output::new(&config));
        lockstep(&config, &module, &model, &stages::output::UNIT, begin, all, |queries, report| {
            assert_eq!(report.transfers("result"), QUERIES);
            assert_eq!(queries.left_with, queries.expected);
            let capped = queries.expected.iter().filter(|[_, _, capped]| *capped == 1).count() as u64;
            assert!(capped > 0 && capped < QUERIES, "{capped} are capped");
        });
    }
}

#[test]
fn a_query_iterates_as_often_as_a_count_has_bits() {
    for config in cases(configs()) {
        let begin = |feeds: &mut Feeds| Patient(Queries::begin(&config, feeds, 1, MANY));
        let (module, model) = (output::module(&config), Output::new(&config));
        lockstep(&config, &module, &model, &stages::output::UNIT, begin, all, |Patient(queries), _| {
            assert_eq!(queries.left_with, queries.expected);
            assert_eq!(queries.left_with.iter().map(|left| left[1..].to_vec()).collect::<Vec<_>>(), [[MANY, 1]]);
        });
    }
}
