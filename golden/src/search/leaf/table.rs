//! The leaf table: where the points of the leaves lie.

use super::In;
use crate::stream::Skid;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Bucket, Fetch, LeafVisit};

/// The table and the leaves that are looked up in it.
#[derive(Clone, Debug)]
pub struct Table {
    buckets: Vec<Bucket>,
    leaf: Skid<LeafVisit>,
    /// The entry of a leaf that was taken, as the memory shows it and a cycle later: stages f0 and f1.
    looked_up: Option<Fetch>,
    held: Option<Fetch>,
    fetch: Skid<Fetch>,
}

impl Table {
    pub fn new(config: &Config) -> Self {
        Self {
            buckets: vec![Bucket::default(); 1 << config.tree_depth],
            leaf: Skid::default(),
            looked_up: None,
            held: None,
            fetch: Skid::default(),
        }
    }

    pub fn leaf_ready(&self) -> bool {
        self.leaf.in_ready()
    }

    pub fn fetch(&self) -> Option<Fetch> {
        self.fetch.out().copied()
    }

    fn look_up(&self, visit: LeafVisit) -> Fetch {
        let Bucket { begin, beats } = self.buckets[visit.leaf as usize];
        Fetch { thread: visit.thread, address: begin, beats }
    }

    pub fn step(&mut self, inputs: &In) {
        let advances = self.held.is_none() || self.fetch.in_ready();
        let fetched = self.held.filter(|_| advances);
        if advances {
            self.held = self.looked_up.take();
            self.looked_up = self.leaf.out().map(|visit| self.look_up(*visit));
        }
        self.fetch.step(fetched, inputs.fetch_ready);
        self.leaf.step(inputs.leaf, advances);
        if let Some(write) = inputs.tree.filter(|write| write.is_leaf) {
            self.buckets[write.address as usize] = write.bucket;
        }
    }
}
