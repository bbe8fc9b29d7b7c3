//! Thread control against its model, with surroundings that end searches sooner or later.

use pointcore_contract::search::units;
use pointcore_golden::search::Threads;
use pointcore_hdl::search::threads;

use crate::search::environment::{Feeds, Rule};
use crate::search::{all, configs, lockstep, query};

const QUERIES: u64 = 600;

/// Descents reach leaves, leaves are done or skipped later, pops find a path or an empty stack.
#[derive(Clone)]
struct Searches;

impl Rule for Searches {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        let thread = vec![fields[0]];
        match stream {
            "descend" => feeds.feed("reached", thread),
            "reached" => {
                let end = ["leaf_done", "skipped"][feeds.random.usize(..2)];
                feeds.feed(end, thread);
            }
            "pop" if feeds.random.u8(..4) == 0 => feeds.feed("empty", thread),
            "pop" => feeds.feed("reached", thread),
            "finish" => feeds.feed("released", thread),
            _ => {}
        }
    }
}

#[test]
fn threads_agree_with_the_model_until_every_query_is_finished() {
    for config in configs() {
        let begin = |feeds: &mut Feeds| {
            for number in 0..QUERIES {
                let query = query(&config, number, &mut feeds.random);
                feeds.feed("query", query);
            }
            Searches
        };
        let (module, model) = (threads::module(&config), Threads::new(&config));
        lockstep(&config, &module, &model, &units::threads::UNIT, begin, all, |_, report| {
            assert_eq!(report.transfers("finish"), QUERIES);
            let [done, skipped] = ["leaf_done", "skipped"].map(|end| report.transfers(end));
            assert_eq!(report.transfers("reached"), done + skipped);
            assert!(done > 0 && skipped > 0);
        });
    }
}
