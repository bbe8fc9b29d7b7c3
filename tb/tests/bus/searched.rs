//! Points and trees where a search on AXI finds them.

use pointcore_contract::Words;
use pointcore_contract::bus::packets::Packet;
use pointcore_contract::bus::{Layout, packets};
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Bucket, Node, Points};

use super::host::Host;
use crate::search::tree::Tree;
use crate::search::word;

const POINTS_BASE: u32 = 0x5000;
const TREE_BASE: u32 = 0x1000;
/// What is behind the points.
pub const LINES_BASE: u32 = 0xa000;
/// Bytes of memory.
pub const MEMORY_BYTES: usize = 0x20000;

/// The words of the tree: places, and what lies there.
pub fn tree_words(config: &Config, tree: &Tree) -> Vec<(u64, u64)> {
    let (node, leaf) = (Layout::record::<Node>(config), Layout::record::<Bucket>(config));
    let word = |write: &Vec<u64>| {
        let bytes = if write[0] == 0 { node.encode(&write[2..5], 8) } else { leaf.encode(&write[5..7], 8) };
        let place = write[1] + (write[0] << config.tree_depth);
        (place, u64::from_le_bytes(bytes.try_into().unwrap()))
    };
    tree.writes.iter().map(word).collect()
}

/// Puts words of the tree where the core finds them.
pub fn put_tree<C, I, O>(host: &mut Host<I, O>, config: &Config, words: impl IntoIterator<Item = (u64, u64)>)
where
    C: Clone,
    I: Packet<Domain = Words, Config = C>,
    O: Packet<Domain = Words, Config = C>,
{
    if config.tree_cache > 0 {
        host.write_base("tree_base", TREE_BASE);
    }
    for (place, word) in words {
        if config.tree_cache == 0 {
            assert!(host.write_tree(place, word));
        } else {
            let stride = packets::tree_stride(config, config.bus.memory_bits);
            let place = TREE_BASE as usize + place as usize * stride as usize;
            host.memory[place..place + 8].copy_from_slice(&word.to_le_bytes());
        }
    }
}

/// Puts points where the search finds them.
pub fn put_points<C, I, O>(host: &mut Host<I, O>, config: &Config, tree: &Tree)
where
    C: Clone,
    I: Packet<Domain = Words, Config = C>,
    O: Packet<Domain = Words, Config = C>,
{
    let points = Layout::record::<Points>(config);
    let stride = points.stride(config.bus.memory_bits);
    for (beat, lanes) in tree.points.chunks(config.lanes as usize).enumerate() {
        let values: Vec<u64> = lanes.iter().flatten().map(|coordinate| word(config, *coordinate)).collect();
        let place = POINTS_BASE as usize + beat * stride as usize;
        host.memory[place..place + stride as usize].copy_from_slice(&points.encode(&values, stride));
    }
    host.write_base("points_base", POINTS_BASE);
}
