//! `Config`: every parameter of the search core's neighbor search, with the ranges the hardware holds.

use crate::configuration::{Derived, OutOfRange, configuration};
use crate::splat::config::index_bits;
use crate::{Format, bus};

/// Bits of a split dimension: x, y, z.
pub const DIMENSION_BITS: u32 = 2;

/// Bits of a point's index at most.
const INDEX_BITS_MAX: u32 = 32;

/// Queries that others follow in the neighbor cache, at most: so many may come close to each other at a time.
const LEADERS_MAX: u32 = 16;

/// Queries that wait in the neighbor cache for each one they follow: as many as a search answers on the way.
const FOLLOWERS_PER_LEADER: u32 = 2;

/// Searches beyond the threads: one whose neighbors are being copied, one that waits to start, two that are being compared.
const SPARE_TICKETS: u32 = 4;

configuration! {
    /// The parameters of one search core. In a file they stand in tables; missing keys take the default, unknown keys are errors.
    pub struct Config, kind "search" {
        /// What can be asked, of which points: every key that a bit of an answer hangs on.
        features: Features {
            /// Format of coordinates and squared distances.
            geometry: Format = Format::F32.flushed(),
            described("`\"f32\"`, `\"f24\"`; with `-ftz` they flush subnormals"), User;
            /// Neighbors a priority queue holds: the largest k.
            neighbors: u32 = 16, range(1, 64), Input;
            /// Levels of internal nodes: the tree has `2^tree_depth` leaves.
            tree_depth: u32 = 14, range(1, 20), Input;
            /// Largest number of points of a leaf.
            bucket: u32 = 16, range(1, 255), User;
            /// Bits of a point's index, and of a query's number.
            index_bits: u32 = 24, range(4, INDEX_BITS_MAX), User;
            /// Neighborhoods that the coherent neighbor cache holds, which may answer in the place of a search; 0 leaves it out.
            neighbor_cache: u32 = 0, range(0, 32), User;
        }
        /// What it costs in area and time: no distance that is found hangs on it.
        implementation: Implementation {
            /// Queries under way at a time.
            threads: u32 = 16, range(1, 32), User;
            /// Points whose distance is computed in a cycle; buckets begin at multiples of it.
            lanes: u32 = 1, described("1, 2, 4, 8"), User;
            /// Leaves a thread may have under way while it goes on searching with the radius known by then.
            leaves_in_flight: u32 = 1, range(1, 4), User;
            /// Leaves whose points the point cache holds; 0 leaves it out.
            point_cache: u32 = 64, described("0, or a power of two from 2 to 256"), User;
            /// Records of the tree that the tree cache holds; 0 keeps the whole tree on chip instead.
            tree_cache: u32 = 0, described("0, or a power of two from 16 to 65536"), User;
        }
    }
}

/// A configuration the hardware cannot hold.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ConfigError {
    /// A number lies outside its range.
    #[error(transparent)]
    Range(#[from] OutOfRange),
    /// A number of cache lines that no bits of an address can choose among.
    #[error("`{key}` = {value}: expected 0 or a power of two from {low} to {high}")]
    PowerOfTwo {
        /// The TOML key.
        key: &'static str,
        /// Its value.
        value: u32,
        /// Smallest value allowed besides 0.
        low: u32,
        /// Largest value allowed.
        high: u32,
    },
    /// Lanes that do not divide a beat evenly.
    #[error("`lanes` = {0}: expected 1, 2, 4 or 8")]
    Lanes(u32),
    /// A format the operators cannot compute in.
    #[error("`geometry` = \"{0}\": expected f32, f24, f32-ftz or f24-ftz")]
    Format(Format),
    /// A width that no bus has.
    #[error(transparent)]
    Bus(#[from] bus::ConfigError),
}

/// Entries of the smallest queue.
const SIEVE_DEPTH_LEAST: u32 = 2;

impl Config {
    /// What follows from the keys.
    pub const DERIVED: &'static [Derived] = &[Derived {
        name: "sieve_depth",
        rule: "`threads`, at least 2",
        doc: " Beats of near enough points that may wait for the priority queues: one of each thread.",
    }];

    /// Checks every range.
    ///
    /// # Errors
    /// The first parameter the hardware cannot hold.
    pub fn validate(&self) -> Result<(), ConfigError> {
        self.check_ranges()?;
        if self.neighbor_cache > 0 {
            // A search bears its ticket as its number.
            let fewest = f64::from(index_bits(self.tickets()));
            OutOfRange::check("index_bits", f64::from(self.index_bits), fewest, f64::from(INDEX_BITS_MAX))?;
        }
        let caches = [("point_cache", self.point_cache, 2, 256), ("tree_cache", self.tree_cache, 16, 65_536)];
        for (key, value, low, high) in caches {
            if value != 0 && !(value.is_power_of_two() && (low..=high).contains(&value)) {
                return Err(ConfigError::PowerOfTwo { key, value, low, high });
            }
        }
        if ![1, 2, 4, 8].contains(&self.lanes) {
            return Err(ConfigError::Lanes(self.lanes));
        }
        if self.geometry.exponent != 8 || self.geometry.mantissa < 15 {
            return Err(ConfigError::Format(self.geometry));
        }
        Ok(self.bus.validate()?)
    }

    /// Bits of a squared distance or radius within the core: a number without its sign.
    #[must_use]
    pub const fn square_bits(&self) -> u32 {
        self.geometry.width() - 1
    }

    /// Bits of a thread's number.
    #[must_use]
    pub const fn thread_bits(&self) -> u32 {
        index_bits(self.threads)
    }

    /// Beats of near enough points that may wait for the priority queues: one of each thread.
    #[must_use]
    pub const fn sieve_depth(&self) -> u32 {
        if self.threads > SIEVE_DEPTH_LEAST { self.threads } else { SIEVE_DEPTH_LEAST }
    }

    /// Bits of a node's address: 1 is the root, `2i` and `2i + 1` are the children of `i`, leaves have the top bit set.
    #[must_use]
    pub const fn node_bits(&self) -> u32 {
        self.tree_depth + 1
    }

    /// Bits of a leaf's number of beats.
    #[must_use]
    pub const fn beats_bits(&self) -> u32 {
        index_bits(self.bucket.div_ceil(self.lanes) + 1)
    }

    /// Bits of a neighbor's rank.
    #[must_use]
    pub const fn rank_bits(&self) -> u32 {
        index_bits(self.neighbors + 1)
    }

    /// Bits of a point memory address: a beat of `lanes` points.
    #[must_use]
    pub const fn beat_bits(&self) -> u32 {
        let bits = self.index_bits - self.lanes.ilog2();
        if bits == 0 { 1 } else { bits }
    }

    /// Bits of the number of a neighborhood in the neighbor cache.
    #[must_use]
    pub const fn entry_bits(&self) -> u32 {
        index_bits(self.neighbor_cache)
    }

    /// Searches that the neighbor cache may have under way: a few more than there are threads, so that no thread waits for a
    /// comparison or a copy.
    #[must_use]
    pub const fn tickets(&self) -> u32 {
        self.threads + SPARE_TICKETS
    }

    /// Queries under way in the neighbor cache that others may wait for: one a thread.
    #[must_use]
    pub const fn leaders(&self) -> u32 {
        if self.threads < LEADERS_MAX { self.threads } else { LEADERS_MAX }
    }

    /// Bits of the number of a query that others may wait for.
    #[must_use]
    pub const fn leader_bits(&self) -> u32 {
        index_bits(self.leaders())
    }

    /// Queries that may wait in the neighbor cache for those they follow.
    #[must_use]
    pub const fn followers(&self) -> u32 {
        self.leaders() * FOLLOWERS_PER_LEADER
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn default_is_valid_and_errors_name_the_range() {
        assert_eq!(Config::default().validate(), Ok(()));
        let error = Config { threads: 33, ..Config::default() }.validate().unwrap_err();
        assert_eq!(error.to_string(), "`threads` = 33: expected 1 to 32");
        assert_eq!(Config { lanes: 3, ..Config::default() }.validate(), Err(ConfigError::Lanes(3)));
    }
}
