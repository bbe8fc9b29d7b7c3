//! What can be wrong with points, trees and queries.

use super::Rounding;
use crate::generated::GenerateError;
use crate::memory::MemoryError;
use crate::scene::SceneError;
use pointcore_contract::search::config::ConfigError;
use pointcore_contract::{Format, points};
use pointcore_tb::lockstep::LockstepError;
use pointcore_tb::verilated::VerilatedError;

/// A search that cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum SearchError {
    /// A model file.
    #[error(transparent)]
    Model(#[from] SceneError),
    /// Nothing to search in.
    #[error("the point set is empty: a search needs at least one point")]
    NoPoint,
    /// A point that is nowhere.
    #[error("vertex {index} lies at {point:?}: coordinates must be finite in {format}")]
    Coordinate {
        /// Index of the point.
        index: usize,
        /// The point as given.
        point: [f32; 3],
        /// The core's format.
        format: Format,
    },
    /// Points too near for the format.
    #[error("too many neighbors would be wrong. Rounding: {0}: {remedy}", remedy = .0.remedy())]
    Rounding(Rounding),
    /// A tree that is too small.
    #[error(
        "{points} points, but a tree of `tree_depth` = {depth} and `bucket` = {bucket} holds {capacity}: raise `tree_depth` to \
         {needed} or enlarge `bucket`"
    )]
    Capacity {
        /// Number of points.
        points: usize,
        /// The configuration's `tree_depth`.
        depth: u32,
        /// The configuration's `bucket`.
        bucket: u32,
        /// Points that fit.
        capacity: usize,
        /// The depth that would hold them.
        needed: u32,
    },
    /// A point memory beyond the core's addresses.
    #[error(
        "the buckets take {places} places in the point memory, but `index_bits` = {bits} tell {limit} apart: raise it to {needed}"
    )]
    Addresses {
        /// Places, those that fill up beats among them.
        places: usize,
        /// The configuration's `index_bits`.
        bits: u32,
        /// Places that fit.
        limit: u64,
        /// The bits that would do.
        needed: u32,
    },
    /// A configuration the hardware cannot hold.
    #[error(transparent)]
    Config(#[from] ConfigError),
    /// A point processor the hardware cannot hold.
    #[error(transparent)]
    PointProcessor(#[from] points::ConfigError),
    /// A tree on a core for which it was not built.
    #[error("the tree was built for other hardware: build it with the configuration of the session")]
    OtherTree,
    /// Nothing has moved for too long.
    #[error("the core is stuck in cycle {cycle}, after {answered} of {queries} queries")]
    Stuck {
        /// Cycle, counted from the end of the reset.
        cycle: u64,
        /// Queries answered until then.
        answered: usize,
        /// Queries asked.
        queries: usize,
    },
    /// A query without meaning.
    #[error("query {index}: {problem}")]
    Query {
        /// Index of the query.
        index: usize,
        /// What is wrong and what would be right.
        problem: String,
    },
    /// A setting of the memory without meaning.
    #[error(transparent)]
    Memory(#[from] MemoryError),
    /// A factor of reuse without meaning.
    #[error("{setting} is {value}: expected {expected}")]
    Reuse {
        /// What is set.
        setting: &'static str,
        /// To what.
        value: f32,
        /// What would be right.
        expected: &'static str,
    },
    /// A fault of the generator.
    #[error("the hardware could not be generated: {0}")]
    Generate(#[from] GenerateError),
    /// Verilator, the compiler, or an assertion in the hardware.
    #[error(transparent)]
    Verilated(#[from] VerilatedError),
    /// Hardware and model differ, or the run did not end.
    #[error(transparent)]
    Lockstep(#[from] LockstepError),
}
