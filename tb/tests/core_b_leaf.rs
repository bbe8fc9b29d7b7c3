//! Leaf processing against its model on small random trees.

use pointcore_golden::core_b::Leaf;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::core_b::leaf;
use pointcore_spec::core_b::{Config, ports};

use crate::core_b::environment::{Feeds, Rule};
use crate::core_b::tree::Tree;
use crate::core_b::{all, configs, lockstep, start};

const LEAVES: u64 = 150;

/// Threads that visit one leaf after the other, and the memory.
#[derive(Clone)]
struct Visits {
    config: Config,
    tree: Tree,
    writes_left: usize,
    visits_left: u64,
}

impl Visits {
    fn restart(&mut self, feeds: &mut Feeds, thread: u64) {
        if self.visits_left > 0 {
            self.visits_left -= 1;
            let start = start(&self.config, thread, 0, &mut feeds.random);
            feeds.feed("start", start);
        }
    }
}

impl Rule for Visits {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        match stream {
            "tree" => {
                self.writes_left -= 1;
                if self.writes_left == 0 {
                    (0..self.config.threads.into()).for_each(|thread| self.restart(feeds, thread));
                }
            }
            "start" => {
                let leaves: Vec<_> = self.tree.writes.iter().filter(|write| write[0] == 1).collect();
                let number = leaves[feeds.random.usize(..leaves.len())][1];
                feeds.feed("leaf", vec![fields[0], number]);
            }
            "fetch" => {
                let &[thread, address, beats] = fields else { panic!("a request has three fields") };
                for beat in address..address + beats {
                    let mut item = vec![thread, beat, u64::from(beat + 1 == address + beats)];
                    item.extend(self.tree.beat(beat));
                    feeds.feed("beat", item);
                }
            }
            "candidates" if fields[2] == 1 => self.restart(feeds, fields[0]),
            _ => {}
        }
    }
}

#[test]
fn leaves_agree_with_the_model() {
    for config in configs() {
        let unit = leaf::datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        let begin = |feeds: &mut Feeds| {
            let tree = Tree::random(&config, &mut feeds.random);
            tree.writes.iter().for_each(|write| feeds.feed("tree", write.clone()));
            Visits { config: config.clone(), writes_left: tree.writes.len(), tree, visits_left: LEAVES }
        };
        let model = Leaf::new(&config, unit.manifest.latency);
        lockstep(&unit.module, &model, &ports::leaf(&config), begin, all, |_, report| {
            assert_eq!(report.transfers("fetch"), LEAVES);
            assert!(report.transfers("candidates") >= LEAVES, "every leaf has a beat");
            assert_eq!(report.transfers("candidates"), report.transfers("beat"));
        });
    }
}
