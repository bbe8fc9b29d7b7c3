//! Leaf processing against its model on small random trees.

use pointcore_contract::search::{Config, units};
use pointcore_golden::search::Leaf;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::search::leaf;

use crate::search::environment::{Feeds, Rule};
use crate::search::tree::Tree;
use crate::search::{all, configs, lockstep, start};
use crate::support::cases;

const LEAVES: u64 = 600;
/// Leaves that a thread visits at once, at most: enough for the beats of a few threads to fill the unit.
const AT_ONCE: u64 = 12;

/// Threads that visit a few leaves at a time, and the memory.
#[derive(Clone)]
struct Visits {
    config: Config,
    tree: Tree,
    writes_left: usize,
    visits_left: u64,
    /// Leaves that each thread visits.
    under_way: Vec<u64>,
}

impl Visits {
    fn begin(&mut self, feeds: &mut Feeds) {
        (0..self.config.threads.into()).for_each(|thread| self.restart(feeds, thread));
    }

    fn answer(&self, feeds: &mut Feeds, thread: u64, address: u64, beats: u64) {
        self.tree.beats(thread, address, beats).for_each(|beat| feeds.feed("beat", beat));
    }

    fn restart(&mut self, feeds: &mut Feeds, thread: u64) {
        if self.visits_left > 0 {
            let visits = feeds.random.u64(1..=AT_ONCE.min(self.visits_left));
            self.visits_left -= visits;
            self.under_way[thread as usize] = visits;
            let start = start(&self.config, thread, 0, &mut feeds.random);
            feeds.feed("start", start);
        }
    }

    fn visit(&self, feeds: &mut Feeds, thread: u64) {
        let leaves = self.tree.leaves();
        let number = leaves[feeds.random.usize(..leaves.len())];
        if self.config.tree_cache == 0 {
            feeds.feed("leaf", vec![thread, number]);
        } else {
            let leaf = self.tree.record((1 << self.config.tree_depth) + number);
            self.answer(feeds, thread, leaf[3], leaf[4]);
        }
    }
}

impl Rule for Visits {
    const SEEDS: u64 = 20;

    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "tree" => {
                self.writes_left -= 1;
                if self.writes_left == 0 {
                    self.begin(feeds);
                }
            }
            "start" => (0..self.under_way[fields[0] as usize]).for_each(|_| self.visit(feeds, fields[0])),
            "fetch" => {
                let &[thread, address, beats] = fields else { panic!("a request has three fields") };
                self.answer(feeds, thread, address, beats);
            }
            "candidates" if fields[2] == 1 => {
                let under_way = &mut self.under_way[fields[0] as usize];
                *under_way -= 1;
                if *under_way == 0 {
                    self.restart(feeds, fields[0]);
                }
            }
            _ => {}
        }
    }
}

#[test]
fn leaves_agree_with_the_model() {
    let [one, few, ..] = configs();
    let without_table = [one, few].map(|config| Config { tree_cache: 16, ..config });
    for config in cases(configs().into_iter().chain(without_table)) {
        let unit = leaf::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let begin = |feeds: &mut Feeds| {
            let tree = Tree::fine(&config, &mut feeds.random);
            let writes_left = tree.writes.len();
            let under_way = vec![0; config.threads as usize];
            let mut visits = Visits { config: config.clone(), writes_left, tree, visits_left: LEAVES, under_way };
            match config.tree_cache {
                0 => visits.tree.writes.iter().for_each(|write| feeds.feed("tree", write.clone())),
                _ => visits.begin(feeds),
            }
            visits
        };
        let model = Leaf::new(&config, unit.manifest.latency);
        lockstep(&config, &unit.module, &model, &units::leaf::UNIT, begin, all, |_, report| {
            assert_eq!(report.transfers("fetch"), if config.tree_cache == 0 { LEAVES } else { 0 });
            assert!(report.transfers("candidates") >= LEAVES, "every leaf has a beat");
            assert_eq!(report.transfers("candidates"), report.transfers("beat"));
        });
    }
}
