//! The point processor at its ports.

use super::config::Config;
use crate::process::config::ITERATION_BITS;
use crate::process::queries::{Outcome, Query};
use crate::process::records::{LineFetch, Neighbor, Settings};
use crate::search::records::{Beat, CacheSetup, Fetch, Lookup, TreeRecord, TreeWrite};
use crate::{Unit, process, record, search, unit};

/// What every search of a run asks for.
#[record(config: search::Config)]
pub struct Neighborhood {
    /// Neighbors wanted.
    #[bits(config.rank_bits())]
    pub k: u8,
    /// Squared radius within which neighbors count.
    #[bits(config.geometry.width())]
    pub radius2: u32,
    /// With a neighbor cache, the radius within which a neighborhood must be complete to be reused: 0 for k nearest neighbors, the
    /// radius of balls.
    #[when(config.neighbor_cache > 0)]
    #[bits(config.geometry.width())]
    pub reach: u32,
}

/// What the point processor did.
#[record(config: Config)]
pub struct Events {
    /// The search.
    #[with(&config.search)]
    pub search: search::units::Events,
    /// The process core.
    #[with(&config.process)]
    pub process: process::stages::Events,
}

/// The point processor.
#[unit(points_top, config: Config)]
pub struct Top {
    /// Write to the tree memories, not while a query is under way.
    #[when(config.search.tree_cache == 0)]
    #[with(&config.search)]
    tree: PulseIn<TreeWrite>,
    /// Requests for records of the tree.
    #[when(config.search.tree_cache > 0)]
    #[with(&config.search)]
    lookup: Out<Lookup>,
    /// Records of the tree from memory, in any order.
    #[when(config.search.tree_cache > 0)]
    #[with(&config.search)]
    record: In<TreeRecord>,
    /// How the neighbor cache judges its neighborhoods, not while a query is under way.
    #[when(config.search.neighbor_cache > 0)]
    #[with(&config.search)]
    setup: PulseIn<CacheSetup>,
    /// What every search asks for.
    #[with(&config.search)]
    search: Input<Neighborhood>,
    /// Constants of the run.
    #[port("setting")]
    #[with(&config.process)]
    settings: Input<Settings>,
    /// Iterations that a query has at most, at least one.
    #[bits(ITERATION_BITS)]
    iterations_max: Input<u16>,
    /// Queries.
    #[with(&config.process)]
    query: In<Query>,
    /// Requests to the memory of positions, as the search wants them.
    #[with(&config.search)]
    fetch: Out<Fetch>,
    /// Positions from memory: the beats of a request in order and together, requests in any order.
    #[with(&config.search)]
    beat: In<Beat>,
    /// Requests to the memory of points, as the program wants them.
    #[with(&config.process)]
    line: Out<LineFetch>,
    /// The points of the lines from memory, in the order of the requests.
    #[with(&config.process)]
    fill: In<Neighbor>,
    /// Queries that leave, in any order.
    #[with(&config.process)]
    result: Out<Outcome>,
    /// Nothing is under way.
    idle: Output<bool>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<Events>,
}

/// Every unit of the point processor.
pub static UNITS: [&Unit<Config>; 1] = [&top::UNIT];
