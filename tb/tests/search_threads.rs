//! Thread control against its model, with surroundings that end searches sooner or later.

use pointcore_contract::search::units;
use pointcore_golden::search::Threads;
use pointcore_hdl::search::threads;

use crate::search::environment::{Feeds, Rule};
use crate::search::{all, configs, lockstep, query};
use crate::support::cases;

const QUERIES: u64 = 600;
/// Pulses without order.
const PULSES: u32 = 2000;

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
    for config in cases(configs()) {
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

/// A thread as surroundings without order see it.
#[derive(Clone, Copy, Default)]
struct Leaves {
    /// Reached, or about to be.
    under_way: u32,
    /// Of those, the ones that have not been ended.
    open: u32,
    /// Has a query, and is not about to be released.
    busy: bool,
}

/// Pulses at any time: nothing but the ends of leaves waits for what they follow from.
#[derive(Clone)]
struct Disorder {
    leaves_in_flight: u32,
    threads: Vec<Leaves>,
    left: u32,
}

impl Disorder {
    /// Some pulse that is possible.
    fn pulse(&mut self, feeds: &mut Feeds) {
        let thread = feeds.random.usize(..self.threads.len());
        let leaves = self.threads[thread];
        let cycles = feeds.random.u32(..3);
        let name = match feeds.random.u8(..8) {
            0..4 if leaves.open > 0 => return self.end(feeds, thread),
            4..6 if leaves.under_way < self.leaves_in_flight && leaves.busy => {
                self.threads[thread].under_way += 1;
                "reached"
            }
            6 if leaves.under_way == 0 => return self.end(feeds, thread),
            _ => "empty",
        };
        feeds.feed_after(cycles, name, vec![thread as u64]);
    }

    /// Brings a thread nearer to its release.
    fn end(&mut self, feeds: &mut Feeds, thread: usize) {
        let leaves = &mut self.threads[thread];
        if leaves.open > 0 {
            leaves.open -= 1;
            let end = ["leaf_done", "skipped"][feeds.random.usize(..2)];
            feeds.feed(end, vec![thread as u64]);
        } else if leaves.under_way == 0 && leaves.busy {
            leaves.busy = false;
            feeds.feed("released", vec![thread as u64]);
        }
    }
}

impl Rule for Disorder {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        let leaves = (stream != "query").then(|| &mut self.threads[fields[0] as usize]);
        match (stream, leaves) {
            ("reached", Some(leaves)) => leaves.open += 1,
            ("leaf_done" | "skipped", Some(leaves)) => leaves.under_way -= 1,
            ("start", Some(leaves)) => leaves.busy = true,
            _ => {}
        }
        // More than one follows from each, until enough have been; then the threads come to their ends.
        match self.left {
            0 if stream != "query" => self.end(feeds, fields[0] as usize),
            0 => {}
            _ => {
                self.left -= 1;
                (0..2).for_each(|_| self.pulse(feeds));
                if self.left == 0 {
                    (0..self.threads.len()).for_each(|thread| self.end(feeds, thread));
                }
            }
        }
    }
}

#[test]
fn threads_agree_with_the_model_when_pulses_come_without_order() {
    for config in cases(configs()) {
        let begin = |feeds: &mut Feeds| {
            for number in 0..QUERIES {
                let query = query(&config, number, &mut feeds.random);
                feeds.feed("query", query);
            }
            let threads = vec![Leaves::default(); config.threads as usize];
            Disorder { leaves_in_flight: config.leaves_in_flight, threads, left: PULSES }
        };
        let (module, model) = (threads::module(&config), Threads::new(&config));
        lockstep(&config, &module, &model, &units::threads::UNIT, begin, all, |disorder, report| {
            assert_eq!(disorder.left, 0);
            assert!(report.transfers("released") > 0 && report.transfers("start") > u64::from(config.threads));
        });
    }
}
