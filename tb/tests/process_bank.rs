//! The register bank against its model, with threads that write and read in their order.

use pointcore_contract::process::queries::{Fresh, Stores, Update};
use pointcore_contract::process::records::{Gathered, Sums};
use pointcore_contract::process::{Config, stages};
use pointcore_golden::process::Bank;
use pointcore_hdl::process::bank;

use crate::process::scene::{configs, item};
use crate::search::environment::{Feeds, Rule};
use crate::search::{all, lockstep};
use crate::support::cases;

const ITERATIONS: u64 = 400;

/// Threads whose words are written and read, block after block.
#[derive(Clone)]
struct Threads {
    config: Config,
    left: u64,
}

impl Threads {
    fn begin(&mut self, feeds: &mut Feeds, thread: u64) {
        let fresh = item::<Fresh>(&self.config, &[thread], &mut feeds.random);
        feeds.feed("fresh", fresh);
    }

    /// The neighbors of a query; the farthest alone for `init`.
    fn gather(&self, feeds: &mut Feeds, thread: u64, farthest: bool) {
        let count = if farthest { 1 } else { feeds.random.u64(1..4) };
        for rank in 0..count {
            let none = u64::from(count == 1);
            let place = [thread, farthest.into(), none, u64::from(!farthest && rank + 1 == count)];
            let gathered = item::<Gathered>(&self.config, &place, &mut feeds.random);
            feeds.feed("gathered", gathered);
        }
    }

    /// An iteration begins.
    fn iterate(&self, feeds: &mut Feeds, thread: u64) {
        if self.config.has_farthest() {
            self.gather(feeds, thread, true);
        } else if self.config.has_init() {
            feeds.feed("prepare", vec![thread]);
        } else {
            self.gather(feeds, thread, false);
        }
    }
}

impl Rule for Threads {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        let thread = fields[0];
        match stream {
            "fresh" => feeds.feed("want", vec![thread]),
            "wanted" => {
                let neighbors = feeds.random.u64(0..=self.config.neighbors.into());
                feeds.feed("listed", vec![thread, neighbors]);
            }
            "listed" => self.iterate(feeds, thread),
            "init" => {
                let stores = item::<Stores>(&self.config, &[thread], &mut feeds.random);
                feeds.feed("stores", stores);
            }
            "prepared" => self.gather(feeds, thread, false),
            // Thread, none, last.
            "kernel" if fields[2] == 1 => {
                let sums = item::<Sums>(&self.config, &[thread], &mut feeds.random);
                feeds.feed("sums", sums);
            }
            "finish" if self.left > 0 => {
                self.left -= 1;
                if feeds.random.u8(..3) == 0 {
                    self.begin(feeds, thread);
                } else {
                    let update = item::<Update>(&self.config, &[thread], &mut feeds.random);
                    feeds.feed("update", update);
                }
            }
            "again" if fields[1] == 1 => feeds.feed("want", vec![thread]),
            "again" => self.iterate(feeds, thread),
            _ => {}
        }
    }
}

#[test]
fn words_are_read_as_they_were_written() {
    for config in cases(configs()) {
        let begin = |feeds: &mut Feeds| {
            let mut threads = Threads { config: config.clone(), left: ITERATIONS };
            (0..config.threads.into()).for_each(|thread| threads.begin(feeds, thread));
            threads
        };
        let (module, model) = (bank::module(&config), Bank::new(&config));
        lockstep(&config, &module, &model, &stages::bank::UNIT, begin, all, |_, report| {
            assert_eq!(report.transfers("finish"), ITERATIONS + u64::from(config.threads));
            assert!(report.transfers("again") > 0);
            assert!(report.transfers("prepared") > 0 || !config.has_init());
        });
    }
}
