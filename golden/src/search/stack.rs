//! Stack: the paths not taken, a stack a thread in one memory (thesis figure 6.8).
//!
//! A stack holds a path a level at most, since what is on it lies above the node the thread descends from.

use crate::unit::Model;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Path, Push, Thread};
pub use pointcore_contract::search::units::stack::{In, Out};

/// The stacks of all threads.
#[derive(Clone, Debug)]
pub struct Stack {
    capacity: usize,
    paths: Vec<Path>,
    depths: Vec<usize>,
    top: Option<Path>,
}

impl Stack {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let (threads, capacity) = (config.threads as usize, config.tree_depth as usize);
        Self { capacity, paths: vec![Path::default(); threads * capacity], depths: vec![0; threads], top: None }
    }

    fn address(&self, thread: Thread) -> usize {
        thread.index() * self.capacity + self.depths[thread.index()]
    }
}

impl Model for Stack {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { top_empty: self.top.is_none(), top: self.top.unwrap_or_default() }
    }

    fn clock(&mut self, inputs: &In) {
        if let Some(thread) = inputs.pop {
            self.top = if self.depths[thread.index()] > 0 {
                self.depths[thread.index()] -= 1;
                Some(self.paths[self.address(thread)])
            } else {
                None
            };
        }
        if let Some(Push { thread, path }) = inputs.push {
            assert!(self.depths[thread.index()] < self.capacity, "a stack holds a path a level at most");
            let address = self.address(thread);
            self.paths[address] = path;
            self.depths[thread.index()] += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::for_each_seed;

    #[test]
    fn every_thread_has_a_stack_of_its_own() {
        for_each_seed("stack", |random| {
            let mut unit = Stack::new(&Config { threads: 5, tree_depth: 3, ..Config::default() });
            let mut stacks = vec![Vec::new(); 5];
            let mut shown = None;
            let (mut pops, mut empty) = (0, 0);
            for node in 0..2000 {
                let Out { top_empty, top } = unit.outputs();
                assert_eq!((!top_empty).then_some(top), shown);
                let pushing = random.usize(0..5);
                let popping = (pushing + random.usize(1..5)) % 5;
                let (pushes, popped) = (random.bool() && stacks[pushing].len() < 3, random.bool());
                let path = Path { node, distance2: random.u32(..) };
                let thread = |index: usize| Thread { thread: index as u8 };
                unit.clock(&In {
                    push: pushes.then_some(Push { thread: thread(pushing), path }),
                    pop: popped.then_some(thread(popping)),
                });
                if pushes {
                    stacks[pushing].push(path);
                }
                if popped {
                    shown = stacks[popping].pop();
                    pops += u32::from(shown.is_some());
                    empty += u32::from(shown.is_none());
                }
            }
            assert!(pops > 300 && empty > 100, "{pops} paths popped, {empty} stacks found empty");
        });
    }
}
