//! The search core, the point-set processor, unit by unit as docs/search.md describes it.
//!
//! A unit is a [`Model`](crate::unit::Model) over the typed records of [`records`]; [`Ported`](crate::unit::Ported) gives it the
//! ports of the specification.

pub mod events;
pub mod leaf;
pub mod neighbor_cache;
pub mod point_cache;
pub mod queue;
pub mod records;
pub mod recursion;
pub mod sieve;
pub mod stack;
pub mod threads;
pub mod top;
pub mod traversal;
pub mod tree_cache;

pub use leaf::Leaf;
pub use neighbor_cache::NeighborCache;
pub use point_cache::PointCache;
pub use queue::Queue;
pub use recursion::Recursion;
pub use sieve::Sieve;
pub use stack::Stack;
pub use threads::Threads;
pub use top::Top;
pub use traversal::Traversal;
pub use tree_cache::TreeCache;

/// Stages of the compiled pipelines, from the manifests that the generator writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Latencies {
    /// Of the squared distance to a splitting plane.
    pub path: u32,
    /// Of the squared distances to a beat of points, no less than of a path: it has a path's operations and more.
    pub distance: u32,
    /// Of the neighbor cache, where there is one.
    pub neighbor_cache: Option<CacheLatencies>,
}

/// Stages of the neighbor cache's pipelines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CacheLatencies {
    /// Of the coherence check.
    pub check: u32,
    /// Of the value that queries are compared with.
    pub cover: u32,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::check_ports;
    use pointcore_contract::search::{Config, ports};

    #[test]
    fn every_record_follows_its_port_list() {
        let parts = [(1, 0, 0), (2, 64, 0), (4, 0, 16), (8, 2, 256)];
        for (lanes, point_cache, tree_cache) in parts {
            let config = Config { lanes, point_cache, tree_cache, ..Config::default() };
            check_ports(&Threads::new(&config), &ports::threads(&config));
            check_ports(&Traversal::new(&config, 1), &ports::traversal(&config));
            check_ports(&Stack::new(&config), &ports::stack(&config));
            check_ports(&Recursion::new(&config), &ports::recursion(&config));
            check_ports(&Leaf::new(&config, 1), &ports::leaf(&config));
            check_ports(&Sieve::new(&config), &ports::sieve(&config));
            check_ports(&Queue::new(&config), &ports::queue(&config));
            if point_cache > 0 {
                check_ports(&PointCache::new(&config), &ports::point_cache(&config));
            }
            if tree_cache > 0 {
                check_ports(&TreeCache::new(&config), &ports::tree_cache(&config));
            }
        }
        let config = Config { neighbor_cache: 8, ..Config::default() };
        let latencies = CacheLatencies { check: 1, cover: 1 };
        check_ports(&NeighborCache::new(&config, latencies), &ports::neighbor_cache(&config));
    }

    #[test]
    fn the_core_has_the_ports_of_its_parts() {
        let parts = [(0, 0, 0), (64, 0, 0), (0, 16, 0), (0, 0, 8), (2, 256, 1)];
        for (point_cache, tree_cache, neighbor_cache) in parts {
            let config = Config { point_cache, tree_cache, neighbor_cache, ..Config::default() };
            let cache = (neighbor_cache > 0).then_some(CacheLatencies { check: 1, cover: 1 });
            let latencies = Latencies { path: 1, distance: 1, neighbor_cache: cache };
            check_ports(&Top::new(&config, latencies), &ports::top(&config));
        }
    }
}
