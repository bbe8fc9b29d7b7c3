//! The records that flow through the search core: names and widths of their fields, in order.
//!
//! Coordinates and squared distances are values of [`Config::geometry`]; everything else is an unsigned integer.

use super::config::{Config, DIMENSION_BITS};
use crate::splat::records::Field;

fn field(name: &str, width: u32) -> Field {
    (name.to_owned(), width)
}

fn thread(config: &Config) -> Field {
    field("thread", config.thread_bits())
}

fn coordinates(config: &Config) -> Vec<Field> {
    ["x", "y", "z"].map(|axis| field(axis, config.geometry.width())).to_vec()
}

/// A query as the host sends it: its number, the k wanted, the squared radius within which neighbors count, the point.
#[must_use]
pub fn query(config: &Config) -> Vec<Field> {
    let mut record = vec![field("number", config.index_bits), field("k", config.rank_bits())];
    record.push(field("radius2", config.geometry.width()));
    record.extend(coordinates(config));
    record
}

/// One neighbor of a query, nearest first; `last` closes the query. A query without any neighbor has one result with
/// `found` low.
#[must_use]
pub fn result(config: &Config) -> Vec<Field> {
    vec![
        field("number", config.index_bits),
        field("last", 1),
        field("found", 1),
        field("index", config.index_bits),
        field("distance2", config.geometry.width()),
    ]
}

/// A query as the host sends it to a core with a neighbor cache. `reach` is the radius around the query within which a cached
/// neighborhood must be complete: 0 for k nearest neighbors, the radius of a ball query.
#[must_use]
pub fn cached_query(config: &Config) -> Vec<Field> {
    let mut record = query(config);
    record.push(field("reach", config.geometry.width()));
    record
}

/// A neighbor from a core with a neighbor cache. Where `cached` is high, the squared distance is that to the query whose
/// neighborhood is reused.
#[must_use]
pub fn cached_result(config: &Config) -> Vec<Field> {
    let mut record = result(config);
    record.push(field("cached", 1));
    record
}

/// How the neighbor cache judges its neighborhoods: whether queries are balls (thesis table 6.1), the factor of the distance to
/// the farthest neighbor, and that of what is left of it.
#[must_use]
pub fn cache_setup(config: &Config) -> Vec<Field> {
    let width = config.geometry.width();
    vec![field("ball", 1), field("far_scale", width), field("margin_scale", width)]
}

/// A request for a record of a tree in external memory: nodes lie at their own addresses, leaf `l` of the deepest level at
/// `2^tree_depth + l`.
#[must_use]
pub fn lookup(config: &Config) -> Vec<Field> {
    vec![thread(config), field("address", config.node_bits())]
}

/// A record of the tree from external memory, under the thread and address of its request: of a node `split`, `dimension` and
/// `internal_leaf` count, of a leaf `begin` and `beats`.
#[must_use]
pub fn tree_record(config: &Config) -> Vec<Field> {
    let mut record = lookup(config);
    record.extend(node(config));
    record.extend(bucket(config));
    record
}

/// What a node holds.
#[must_use]
pub fn node(config: &Config) -> Vec<Field> {
    let split = field("split", config.geometry.width());
    vec![split, field("dimension", DIMENSION_BITS), field("internal_leaf", 1)]
}

/// Where the points of a leaf lie.
#[must_use]
pub fn bucket(config: &Config) -> Vec<Field> {
    vec![field("begin", config.beat_bits()), field("beats", config.beats_bits())]
}

/// A node with its thread and address.
#[must_use]
pub fn node_record(config: &Config) -> Vec<Field> {
    let mut record = descent(config);
    record.extend(node(config));
    record
}

/// A write to the tree memories by the host. `is_leaf` chooses the leaf table (address: the leaf's number), else the node
/// memory.
#[must_use]
pub fn tree_write(config: &Config) -> Vec<Field> {
    let mut record = vec![field("is_leaf", 1), field("address", config.tree_depth)];
    record.extend(node(config));
    record.extend(bucket(config));
    record
}

/// A thread taking up a query.
#[must_use]
pub fn start(config: &Config) -> Vec<Field> {
    let mut record = vec![thread(config)];
    record.extend(query(config));
    record
}

/// Where a thread is to descend from.
#[must_use]
pub fn descent(config: &Config) -> Vec<Field> {
    vec![thread(config), field("node", config.node_bits())]
}

/// A path not taken: subtree and squared distance of the query to the splitting plane.
#[must_use]
pub fn path(config: &Config) -> Vec<Field> {
    vec![field("node", config.node_bits()), field("distance2", config.geometry.width())]
}

/// A thread alone.
#[must_use]
pub fn thread_only(config: &Config) -> Vec<Field> {
    vec![thread(config)]
}

/// A leaf that a thread has reached: its number counts the leaves of the tree's deepest level (eq. 6.7).
#[must_use]
pub fn leaf(config: &Config) -> Vec<Field> {
    vec![thread(config), field("leaf", config.tree_depth)]
}

/// A request for the points of a leaf: `beats` beats (at least one) from `address` on, to be answered under `thread`.
#[must_use]
pub fn fetch(config: &Config) -> Vec<Field> {
    vec![thread(config), field("address", config.beat_bits()), field("beats", config.beats_bits())]
}

/// A beat of points from memory; the beats of a request come in order and together, requests in any order. A lane
/// without a point holds NaN coordinates.
#[must_use]
pub fn beat(config: &Config) -> Vec<Field> {
    let mut record = vec![thread(config), field("address", config.beat_bits()), field("last", 1)];
    for lane in 0..config.lanes {
        record.extend(coordinates(config).into_iter().map(|(axis, width)| (format!("{axis}{lane}"), width)));
    }
    record
}

/// A beat of squared distances; lane `i` is the point `address·lanes + i`, NaN where there is none.
#[must_use]
pub fn candidates(config: &Config) -> Vec<Field> {
    let mut record = vec![thread(config), field("address", config.beat_bits()), field("last", 1)];
    record.extend((0..config.lanes).map(|lane| field(&format!("distance{lane}"), config.geometry.width())));
    record
}

/// A thread's search radius after a leaf.
#[must_use]
pub fn radius(config: &Config) -> Vec<Field> {
    vec![thread(config), field("radius2", config.geometry.width())]
}
