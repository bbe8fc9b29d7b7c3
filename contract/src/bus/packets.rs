//! What travels and lies in memory: the records that are packets, and those that are memory.

use super::layout::Layout;
use crate::points;
use crate::process::{self, records::Neighbor};
use crate::search;
use crate::search::records::{Bucket, CachedQuery, CachedResult, Node, Points};
use crate::splat;
use crate::splat::config::MERGED_DEPTH_BITS;
use crate::splat::records::{Depth, Fragment, PayloadWord, Pixel, Splat};
use crate::{Field, Record, fields, places};

/// A record that travels as a packet.
pub trait Packet: Record {
    /// The flag that is set in a run's last packet, where packets have one.
    #[must_use]
    fn end(_config: &Self::Config) -> Option<usize> {
        None
    }

    /// The fields that not all values make sense of.
    #[must_use]
    fn ranges(_config: &Self::Config) -> Vec<FieldRange> {
        vec![]
    }
}

/// The values that a field of a packet may have, its bits read as a number without sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FieldRange {
    /// The field's place in its record.
    pub field: usize,
    /// Its smallest value.
    pub low: u32,
    /// Its largest value.
    pub high: u32,
}

impl Packet for Splat {
    fn end(config: &splat::Config) -> Option<usize> {
        places::<Self>(config).end
    }
}

impl Packet for Fragment {
    fn end(config: &splat::Config) -> Option<usize> {
        places::<Self>(config).end
    }
}

impl Packet for CachedQuery {
    /// At least one neighbor, no more than the core finds; a squared radius from zero to infinity, neither negative nor NaN.
    fn ranges(config: &search::Config) -> Vec<FieldRange> {
        let places = places::<Self>(config).query;
        let neighbors = places.k.map(|field| FieldRange { field, low: 1, high: config.neighbors });
        let infinity = config.geometry.infinity() as u32;
        let radius2 = places.radius2.map(|field| FieldRange { field, low: 0, high: infinity });
        neighbors.into_iter().chain(radius2).collect()
    }
}

impl Packet for CachedResult {}

impl Packet for process::queries::Query {}

impl Packet for process::queries::Outcome {}

/// A record with a name and a purpose, for documents.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedRecord {
    /// What it is called.
    pub name: &'static str,
    /// One line.
    pub doc: &'static str,
    /// Its fields in order.
    pub fields: Vec<Field>,
    /// Bytes it takes, padding included.
    pub bytes: u32,
}

fn packet(name: &'static str, doc: &'static str, fields: Vec<Field>, stream_bits: u32) -> NamedRecord {
    let bytes = Layout::of(&fields).packet_bytes(stream_bits);
    NamedRecord { name, doc, fields, bytes }
}

fn memory(name: &'static str, doc: &'static str, fields: Vec<Field>, memory_bits: u32) -> NamedRecord {
    let bytes = Layout::of(&fields).stride(memory_bits);
    NamedRecord { name, doc, fields, bytes }
}

/// Packets and memory records of the renderer.
#[must_use]
pub fn splat(config: &splat::Config) -> Vec<NamedRecord> {
    let bus = &config.bus;
    let mut records = vec![
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
    ];
    if config.has_payloads_in_memory() {
        let doc = "A word of a payload, which only the core reads and writes.";
        records.push(memory("payload_word", doc, fields::<PayloadWord>(config), bus.memory_bits));
    }
    if config.merge.is_on() {
        let doc = "A depth that fragments are tested against, or samples of what moves.";
        records.push(memory("depth", doc, fields::<Depth>(config), MERGED_DEPTH_BITS));
    }
    records
}

/// Packets and memory records of the search core.
#[must_use]
pub fn search(config: &search::Config) -> Vec<NamedRecord> {
    let stream_bits = config.bus.stream_bits;
    let packets = vec![
        packet("query", "A point whose neighbors are sought.", fields::<CachedQuery>(config), stream_bits),
        packet(
            "result",
            "A neighbor, nearest first; `last` closes its query.",
            fields::<CachedResult>(config),
            stream_bits,
        ),
    ];
    packets.into_iter().chain(search_memory(config)).collect()
}

/// Packets and memory records of the point processor.
#[must_use]
pub fn points(config: &points::Config) -> Vec<NamedRecord> {
    let points::Config { search, process } = config;
    let stream_bits = search.bus.stream_bits;
    let own = vec![
        packet("query", "What the program is asked.", fields::<process::queries::Query>(process), stream_bits),
        packet("result", "What leaves with a query.", fields::<process::queries::Outcome>(process), stream_bits),
        memory(
            "point",
            "A point as the program reads it, in the places that the search's points have; behind one another from `lines_base` on.",
            fields::<Neighbor>(process),
            search.bus.memory_bits,
        ),
    ];
    own.into_iter().chain(search_memory(search)).collect()
}

/// Memory records of a search.
fn search_memory(config: &search::Config) -> Vec<NamedRecord> {
    let bus = &config.bus;
    let tree_bits = if config.tree_cache == 0 { super::config::TREE_WORD_BITS } else { bus.memory_bits };
    // Both kinds of record of a tree lie one beside the other.
    let tree = |name, doc, fields| NamedRecord {
        bytes: tree_stride(config, tree_bits),
        ..memory(name, doc, fields, tree_bits)
    };
    vec![
        memory(
            "points",
            "As many points as the core has lanes; a lane without a point holds NaN.",
            fields::<Points>(config),
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
