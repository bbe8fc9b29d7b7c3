//! What the search core reads: the tree and the points, as a window takes them or as they lie in memory.

use super::super::script::{Script, words};
use super::searches::{Placement, Searches};
use pointcore_contract::bus::config::TREE_WORD_BITS;
use pointcore_contract::bus::{Layout, packets};
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Bucket, Node, Points};
use std::collections::BTreeMap;

/// Bytes of a record of the tree in the window.
pub const WORD_BYTES: u32 = TREE_WORD_BITS / 8;

/// A table of what lies where: runs of beats without a gap.
pub fn table(script: &mut Script, beats: &BTreeMap<u64, Vec<u8>>) -> u32 {
    let mut runs: Vec<(u64, Vec<u8>, u32)> = vec![];
    for (address, bytes) in beats {
        match runs.last_mut() {
            Some((first, run, count)) if *first + run.len() as u64 == *address => {
                run.extend(bytes);
                *count += 1;
            }
            _ => runs.push((*address, bytes.clone(), 1)),
        }
    }
    let mut table = vec![runs.len() as u32];
    for (address, bytes, _) in runs {
        let place = script.data(&words(&bytes));
        // In beats of the memory, which the bench knows.
        table.extend([address as u32, bytes.len() as u32, place]);
    }
    script.data(&table)
}

/// The points from `base` on.
pub fn points(script: &mut Script, config: &Config, searches: &Searches, placement: &Placement, base: u32) -> u32 {
    let layout = Layout::record::<Points>(config);
    let stride = layout.stride(config.bus.memory_bits);
    let mut beats = BTreeMap::new();
    for leaf in searches.tree.writes().filter(|write| write.is_leaf) {
        let moved = placement.begins[&leaf.bucket.begin];
        for beat in 0..u32::from(leaf.bucket.beats) {
            let points = searches.tree.beat(leaf.bucket.begin + beat);
            let values: Vec<u64> = points.iter().flatten().map(|number| (*number).into()).collect();
            let address = u64::from(base) + u64::from(moved + beat) * u64::from(stride);
            beats.insert(address, layout.encode(&values, stride));
        }
    }
    table(script, &beats)
}

/// The records of the tree by number, as bytes; the leaf that begins at a beat may be without any.
pub fn tree(config: &Config, searches: &Searches, placement: &Placement, empty: Option<u32>) -> BTreeMap<u32, Vec<u8>> {
    let (node, leaf) = (Layout::record::<Node>(config), Layout::record::<Bucket>(config));
    let beat_bits = if config.tree_cache > 0 { config.bus.memory_bits } else { TREE_WORD_BITS };
    let stride = packets::tree_stride(config, beat_bits);
    let record = |write: pointcore_contract::search::records::TreeWrite| {
        if write.is_leaf {
            let beats = if empty == Some(write.bucket.begin) { 0 } else { write.bucket.beats };
            let values = [placement.begins[&write.bucket.begin].into(), beats.into()];
            (1 << config.tree_depth | write.address, leaf.encode(&values, stride))
        } else {
            let values = [write.node.split.into(), write.node.dimension.into(), write.node.internal_leaf.into()];
            (write.address, node.encode(&values, stride))
        }
    };
    searches.tree.writes().map(record).collect()
}

/// The tree in memory from `base` on.
pub fn tree_image(script: &mut Script, records: &BTreeMap<u32, Vec<u8>>, base: u32) -> u32 {
    let at =
        |(number, bytes): (&u32, &Vec<u8>)| (u64::from(base) + u64::from(*number) * bytes.len() as u64, bytes.clone());
    table(script, &records.iter().map(at).collect())
}
