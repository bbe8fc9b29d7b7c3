//! The stacks against their model.

use pointcore_contract::search::{Config, units};
use pointcore_golden::search::Stack;
use pointcore_hdl::search::stack;

use crate::search::environment::{Feeds, Rule};
use crate::search::{configs, lockstep};
use crate::support::cases;

const BATCHES: u32 = 80;

/// Each thread pushes a batch, then pops some paths, now and then more than there are; pushes and pops of different
/// threads come together.
#[derive(Clone)]
struct Batches {
    config: Config,
    left: u32,
    sizes: Vec<usize>,
    pushes_left: Vec<usize>,
    pops_left: Vec<usize>,
}

impl Batches {
    fn depth(&self) -> usize {
        self.config.tree_depth as usize
    }

    fn push(&mut self, feeds: &mut Feeds, thread: usize) {
        if self.left == 0 {
            return;
        }
        self.left -= 1;
        let count = feeds.random.usize(0..=self.depth() - self.sizes[thread]);
        self.pushes_left[thread] = count;
        self.sizes[thread] += count;
        for _ in 0..count {
            // What is kept is not looked at.
            let distance2 = feeds.random.u64(..self.config.geometry.sign_mask());
            let item = vec![thread as u64, feeds.random.u64(1..1 << self.config.node_bits()), distance2];
            feeds.feed("push", item);
        }
        if count == 0 {
            self.pop(feeds, thread);
        }
    }

    fn pop(&mut self, feeds: &mut Feeds, thread: usize) {
        let count = feeds.random.usize(1..=self.depth() + 1);
        self.pops_left[thread] = count;
        self.sizes[thread] = self.sizes[thread].saturating_sub(count);
        (0..count).for_each(|_| feeds.feed("pop", vec![thread as u64]));
    }
}

impl Rule for Batches {
    fn transferred(&mut self, feeds: &mut Feeds, stream: &str, fields: &[u64]) {
        let thread = fields[0] as usize;
        match stream {
            "push" => {
                self.pushes_left[thread] -= 1;
                if self.pushes_left[thread] == 0 {
                    self.pop(feeds, thread);
                }
            }
            "pop" => {
                self.pops_left[thread] -= 1;
                if self.pops_left[thread] == 0 {
                    self.push(feeds, thread);
                }
            }
            _ => {}
        }
    }
}

/// The path that `top_*` shows does not matter while `top_empty`, the first of the outputs, is set.
fn top_of_nothing(outputs: &mut [u64]) {
    if outputs[0] == 1 {
        outputs[1..].fill(0);
    }
}

#[test]
fn stacks_agree_with_the_model() {
    for config in cases(configs()) {
        let threads = config.threads as usize;
        let begin = |feeds: &mut Feeds| {
            let zeros = vec![0; threads];
            let (pushes_left, pops_left) = (zeros.clone(), zeros.clone());
            let left = BATCHES * config.threads;
            let mut batches = Batches { config: config.clone(), left, sizes: zeros, pushes_left, pops_left };
            (0..threads).for_each(|thread| batches.push(feeds, thread));
            batches
        };
        let (module, model) = (stack::module(&config), Stack::new(&config));
        lockstep(&config, &module, &model, &units::stack::UNIT, begin, top_of_nothing, |batches, report| {
            assert_eq!(batches.left, 0);
            assert!(report.transfers("push") > 0 && report.transfers("pop") > report.transfers("push") / 2);
        });
    }
}
