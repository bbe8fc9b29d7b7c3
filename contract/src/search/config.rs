//! `Config`: every parameter of the search core's neighbor search, with the ranges the hardware holds.

use crate::splat::config::index_bits;
use crate::{Format, bus};
use serde::{Deserialize, Serialize};

/// Bits of a split dimension: x, y, z.
pub const DIMENSION_BITS: u32 = 2;

/// Searches beyond the threads: one whose neighbors are being copied, one that waits to start, two that are being compared.
const SPARE_TICKETS: u32 = 4;

/// The parameters of one search core. Missing keys take the default, unknown keys are errors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Config {
    /// Format of coordinates and squared distances.
    pub geometry: Format,
    /// Queries under way at a time.
    pub threads: u32,
    /// Neighbors a priority queue holds: the largest k.
    pub neighbors: u32,
    /// Points whose distance is computed in a cycle; buckets begin at multiples of it.
    pub lanes: u32,
    /// Levels of internal nodes: the tree has `2^tree_depth` leaves.
    pub tree_depth: u32,
    /// Largest number of points of a leaf.
    pub bucket: u32,
    /// Bits of a point's index, and of a query's number.
    pub index_bits: u32,
    /// Leaves a thread may have under way while it goes on searching with the radius known by then.
    pub leaves_in_flight: u32,
    /// Beats of near enough points that may wait for the priority queues.
    pub sieve_depth: u32,
    /// Leaves whose points the point cache holds, a power of two; 0 leaves it out.
    pub point_cache: u32,
    /// Records of the tree that the tree cache holds, a power of two; 0 keeps the whole tree on chip instead.
    pub tree_cache: u32,
    /// Neighborhoods that the coherent neighbor cache holds; 0 leaves it out.
    pub neighbor_cache: u32,
    /// Widths of the bus around the core.
    pub bus: bus::Config,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            geometry: Format::F32.flushed(),
            threads: 16,
            neighbors: 16,
            lanes: 1,
            tree_depth: 14,
            bucket: 16,
            index_bits: 24,
            leaves_in_flight: 1,
            sieve_depth: 16,
            point_cache: 64,
            tree_cache: 0,
            neighbor_cache: 0,
            bus: bus::Config::default(),
        }
    }
}

/// A configuration the hardware cannot hold.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ConfigError {
    /// A number lies outside its range.
    #[error("`{key}` = {value}: expected {low} to {high}")]
    Range {
        /// The TOML key.
        key: &'static str,
        /// Its value.
        value: u32,
        /// Smallest value allowed.
        low: u32,
        /// Largest value allowed.
        high: u32,
    },
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

impl Config {
    /// Checks every range.
    ///
    /// # Errors
    /// The first parameter the hardware cannot hold.
    pub fn validate(&self) -> Result<(), ConfigError> {
        // A search bears its ticket as its number.
        let fewest_index_bits = if self.neighbor_cache == 0 { 4 } else { index_bits(self.tickets()).max(4) };
        let ranges = [
            ("threads", self.threads, 1, 32),
            ("neighbors", self.neighbors, 1, 64),
            ("tree_depth", self.tree_depth, 1, 20),
            ("bucket", self.bucket, 1, 255),
            ("index_bits", self.index_bits, fewest_index_bits, 32),
            ("leaves_in_flight", self.leaves_in_flight, 1, 4),
            ("sieve_depth", self.sieve_depth, 2, 64),
            ("neighbor_cache", self.neighbor_cache, 0, 32),
        ];
        for (key, value, low, high) in ranges {
            if !(low..=high).contains(&value) {
                return Err(ConfigError::Range { key, value, low, high });
            }
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

    /// Bits of a thread's number.
    #[must_use]
    pub const fn thread_bits(&self) -> u32 {
        index_bits(self.threads)
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
