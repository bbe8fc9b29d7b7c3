//! What travels and lies in memory: the records that are packets, and those that are memory.

use super::layout::Layout;
use crate::search;
use crate::search::records::{Bucket, CachedQuery, CachedResult, Node, Points};
use crate::splat;
use crate::splat::records::{Fragment, Pixel, Splat};
use crate::{Field, fields};

/// A record with a name and a purpose, for documents.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Packet {
    /// What it is called.
    pub name: &'static str,
    /// One line.
    pub doc: &'static str,
    /// Its fields in order.
    pub fields: Vec<Field>,
    /// Bytes it takes, padding included.
    pub bytes: u32,
}

/// The values that a field of a packet may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldRange {
    /// The field.
    pub name: &'static str,
    /// Its smallest value.
    pub low: u32,
    /// Its largest value.
    pub high: u32,
}

/// The range of a query's `k`.
#[must_use]
pub const fn query_range(config: &search::Config) -> FieldRange {
    FieldRange { name: "k", low: 1, high: config.neighbors }
}

fn packet(name: &'static str, doc: &'static str, fields: Vec<Field>, stream_bits: u32) -> Packet {
    let bytes = Layout::of(&fields).packet_bytes(stream_bits);
    Packet { name, doc, fields, bytes }
}

fn memory(name: &'static str, doc: &'static str, fields: Vec<Field>, memory_bits: u32) -> Packet {
    let bytes = Layout::of(&fields).stride(memory_bits);
    Packet { name, doc, fields, bytes }
}

/// Packets and memory records of the renderer.
#[must_use]
pub fn splat(config: &splat::Config) -> Vec<Packet> {
    let bus = &config.bus;
    vec![
        packet(
            "splat",
            "A splat in world space, or with `end` set the end of the frame.",
            fields::<Splat>(config),
            bus.stream_bits,
        ),
        packet(
            "fragment",
            "A pixel of the picture, or with `end` set the end of the frame.",
            fields::<Fragment>(config),
            bus.stream_bits,
        ),
        memory(
            "pixel",
            "A pixel of the reconstruction buffer, which only the core reads and writes.",
            fields::<Pixel>(config),
            bus.memory_bits,
        ),
    ]
}

/// The query and the result of a search core, with or without a neighbor cache.
#[must_use]
pub fn query_and_result(config: &search::Config) -> [Vec<Field>; 2] {
    [fields::<CachedQuery>(config), fields::<CachedResult>(config)]
}

/// The points of a beat of the search core: `x0`, `y0`, `z0`, `x1` …
#[must_use]
pub fn points(config: &search::Config) -> Vec<Field> {
    fields::<Points>(config)
}

/// Packets and memory records of the search core.
#[must_use]
pub fn search(config: &search::Config) -> Vec<Packet> {
    let bus = &config.bus;
    let [query, result] = query_and_result(config);
    let tree_bits = if config.tree_cache == 0 { super::config::TREE_WORD_BITS } else { bus.memory_bits };
    // Both kinds of record of a tree lie one beside the other.
    let tree =
        |name, doc, fields| Packet { bytes: tree_stride(config, tree_bits), ..memory(name, doc, fields, tree_bits) };
    vec![
        packet("query", "A point whose neighbors are sought.", query, bus.stream_bits),
        packet("result", "A neighbor, nearest first; `last` closes its query.", result, bus.stream_bits),
        memory(
            "points",
            "As many points as the core has lanes; a lane without a point holds NaN.",
            points(config),
            bus.memory_bits,
        ),
        tree("tree_node", "An internal node of the tree.", fields::<Node>(config)),
        tree("tree_leaf", "Where the points of a leaf lie, in beats.", fields::<Bucket>(config)),
    ]
}

/// Bytes from one record of the tree to the next.
#[must_use]
pub fn tree_stride(config: &search::Config, beat_bits: u32) -> u32 {
    let records = [Layout::record::<Node>(config), Layout::record::<Bucket>(config)];
    let strides = records.map(|layout| layout.stride(beat_bits));
    strides.into_iter().fold(super::config::TREE_WORD_BITS / 8, u32::max)
}
