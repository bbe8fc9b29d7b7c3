//! The hardware that a search calls for, where the user does not say.

use super::Splitting;
use super::kdtree::depth_for;
use pointcore_contract::search::Config;

/// Points a cycle: with fewer, distances bound a search for ten neighbors; with more, nodes do.
const LANES: u32 = 4;
/// Leaves that a thread has under way: with as many lanes, latency counts for more than a few needless visits.
const LEAVES_IN_FLIGHT: u32 = 2;
/// Levels that a tree of mid-points may be deeper than a full one: its leaves are not evenly filled.
const MIDPOINT_SPARE_LEVELS: u32 = 1;
/// The largest `neighbors`.
const NEIGHBORS_LIMIT: u32 = 64;
/// The largest `tree_depth`.
const DEPTH_LIMIT: u32 = 20;

/// The default configuration with four lanes, queues for `k` neighbors and a tree for so many points.
#[must_use]
pub fn config_for(points: usize, k: u32, splitting: Splitting) -> Config {
    let default = Config::default();
    let spare = if splitting == Splitting::Midpoint { MIDPOINT_SPARE_LEVELS } else { 0 };
    Config {
        lanes: LANES,
        leaves_in_flight: LEAVES_IN_FLIGHT,
        neighbors: k.clamp(default.neighbors, NEIGHBORS_LIMIT),
        tree_depth: (depth_for(points, default.bucket) + spare).min(DEPTH_LIMIT),
        ..default
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn searches_of_all_sizes_get_valid_hardware() {
        for points in [1, 1000, 134_345, 20_000_000] {
            for k in [0, 1, 17, 64, 1000] {
                for splitting in [Splitting::Median, Splitting::Packed, Splitting::Midpoint] {
                    assert_eq!(config_for(points, k, splitting).validate(), Ok(()));
                }
            }
        }
        assert_eq!(config_for(100_000, 30, Splitting::Packed).neighbors, 30);
        assert_eq!(config_for(100_000, 30, Splitting::Packed).tree_depth, 13);
    }
}
