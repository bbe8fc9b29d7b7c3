//! A search for `search_axi`.

use super::{AddressSpace, Packets, Region, Vectors, VectorsError, writes};
use crate::number::encode;
use crate::search::{MemorySettings, Neighbor, Query, QueryKind, Reuse, SearchEngine, Session, Tree};
use pointcore_contract::bus::config::TREE_WORD_BITS;
use pointcore_contract::bus::registers::{RegisterMap, SearchRegisters};
use pointcore_contract::bus::{Layout, packets};
use pointcore_contract::fields;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Bucket, CachedQuery, CachedResult, Lookup, Node, Points};
use std::collections::HashMap;

/// A search, with points, and the tree unless the core holds it, in memory from `base` on.
///
/// Results of a query come in the order of the vectors, queries in any order. A neighbor cache may answer with more neighbors, in the
/// order of another query: the vectors hold what is left when the host has measured, sorted and cut them.
///
/// # Errors
/// There is no place for the memory, the numbers of queries repeat, or the golden model fails.
pub fn search(
    config: &Config,
    tree: Tree,
    queries: &[Query],
    reuse: Reuse,
    base: u64,
) -> Result<Vectors, VectorsError> {
    let limit = 1 << config.index_bits;
    if queries.len() as u64 > limit {
        return Err(VectorsError::Numbers { queries: queries.len(), bits: config.index_bits, limit });
    }
    let mut memory = AddressSpace::new(base)?;
    let points = points(config, &tree, &mut memory)?;
    let nodes = nodes(config, &tree, &mut memory)?;
    let places: HashMap<u32, u32> =
        (0..tree.memory().len() as u32).filter_map(|place| Some((tree.source(place)?, place))).collect();
    let asked = queries.iter().enumerate().map(|(index, query)| query.encode(config, reuse, index));
    let asked = asked.collect::<Result<Vec<_>, _>>()?;
    let session =
        Session::open(config.clone(), tree, MemorySettings::default(), SearchEngine::Golden)?.reusing(reuse)?;
    let found = session.search(queries)?.neighbors;

    let mut values = vec![("points_base", points.base), ("queries", queries.len() as u32)];
    if config.tree_cache > 0 {
        values.push(("tree_base", nodes.base));
    }
    if config.neighbor_cache > 0 {
        let setup = reuse.setup(config.geometry, queries.first().map_or(QueryKind::Nearest, Query::kind));
        values.push(("cache_ball", setup.ball.into()));
        values.push(("cache_far_scale", setup.far_scale));
        values.push(("cache_margin_scale", setup.margin_scale));
    }
    let (query_fields, result_fields) = (fields::<CachedQuery>(config), fields::<CachedResult>(config));
    let sent = asked.iter().enumerate().map(|(number, asked)| {
        let query = &asked.sent.query;
        let [x, y, z] = query.point.map(u64::from);
        let words = [number as u64, query.k.into(), query.radius2.into(), x, y, z, asked.sent.reach.into()];
        words[..query_fields.len()].to_vec()
    });
    let results = found.iter().enumerate().flat_map(|(number, neighbors)| {
        let result = |(last, neighbor): (bool, Option<&Neighbor>)| {
            let index = neighbor.map_or(0, |neighbor| places[&neighbor.point]);
            let distance2 = neighbor.map_or(0, |neighbor| encode(config.geometry, neighbor.distance2));
            let found = neighbor.is_some();
            [number as u64, last.into(), found.into(), index.into(), distance2.into(), 0][..result_fields.len()]
                .to_vec()
        };
        let count = neighbors.len();
        let some = neighbors.iter().enumerate().map(move |(rank, neighbor)| (rank + 1 == count, Some(neighbor)));
        let none = (count == 0).then_some((true, None));
        some.chain(none).map(result).collect::<Vec<_>>()
    });
    Ok(Vectors {
        top: "search_axi",
        stream_bits: config.bus.stream_bits,
        memory_bits: config.bus.memory_bits,
        registers: writes(&SearchRegisters::registers(config), values),
        send: Packets::new("query", &query_fields, &config.bus, sent),
        receive: Packets::new("result", &result_fields, &config.bus, results),
        memory: vec![points, nodes],
    })
}

/// The points, a beat a record.
fn points(config: &Config, tree: &Tree, memory: &mut AddressSpace) -> Result<Region, VectorsError> {
    let layout = Layout::record::<Points>(config);
    let stride = layout.stride(config.bus.memory_bits);
    let beat = |points: &[[u32; 3]]| {
        let values: Vec<u64> = points.iter().flatten().map(|number| (*number).into()).collect();
        layout.encode(&values, stride)
    };
    let contents: Vec<u8> = tree.memory().chunks_exact(config.lanes as usize).flat_map(beat).collect();
    let bytes = contents.len() as u64;
    let base = memory.take("a point memory", bytes)?;
    let file = Some("points.bin".to_owned());
    Ok(Region { name: "points", port: "m_axi", base, bytes, stride, file, contents: Some(contents) })
}

/// Nodes and leaves: written through the window, or read from memory.
fn nodes(config: &Config, tree: &Tree, memory: &mut AddressSpace) -> Result<Region, VectorsError> {
    let (node, leaf) = (Layout::record::<Node>(config), Layout::record::<Bucket>(config));
    let in_memory = config.tree_cache > 0;
    let stride = packets::tree_stride(config, if in_memory { config.bus.memory_bits } else { TREE_WORD_BITS });
    let first_leaf = 1 << config.tree_depth;
    let record = |address: u32| {
        let record = tree.record(Lookup { address, ..Lookup::default() });
        if address < first_leaf {
            let node_values =
                [record.node.split.into(), record.node.dimension.into(), record.node.internal_leaf.into()];
            node.encode(&node_values, stride)
        } else {
            leaf.encode(&[record.bucket.begin.into(), record.bucket.beats.into()], stride)
        }
    };
    let contents: Vec<u8> = (0..2 * first_leaf).flat_map(record).collect();
    let bytes = contents.len() as u64;
    let (port, base) = if in_memory { ("m_axi_tree", memory.take("a tree", bytes)?) } else { ("s_axi", 0) };
    let file = Some("tree.bin".to_owned());
    Ok(Region { name: "tree", port, base, bytes, stride, file, contents: Some(contents) })
}
