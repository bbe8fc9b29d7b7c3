//! What is searched, for the core's generator and for those who use the core.

use pointcore_contract::Format;
use pointcore_contract::search::Config;

/// A search core that is small: a tree of 5 levels, 4 threads, no cache.
#[must_use]
pub fn config() -> Config {
    Config {
        geometry: Format::F24.flushed(),
        neighbors: 8,
        tree_depth: 5,
        bucket: 8,
        index_bits: 16,
        threads: 4,
        point_cache: 0,
        ..Config::default()
    }
}
