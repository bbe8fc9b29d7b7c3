//! A kd-tree as the host builds it: implicit nodes, internal leaves, buckets that begin at a beat.

use fastrand::Rng;
use pointcore_contract::Format;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Bucket, Point, TreeWrite};
use pointcore_golden::float;
use std::collections::BTreeMap;

/// A tree's memories.
pub struct Tree {
    /// Writes that load the tree, by the addresses of their records in external memory.
    pub records: BTreeMap<u32, TreeWrite>,
    /// The point memory, `lanes` points a beat, NaN where there is none.
    pub points: Vec<Point>,
    /// Nodes that are leaves before the deepest level.
    pub internal_leaves: usize,
}

/// The encoding of a number in the core's format.
pub fn encode(format: Format, number: f32) -> u32 {
    float::convert(Format::F32, format, u64::from(number.to_bits())) as u32
}

/// The coordinates that a point's encodings in the core's format stand for.
pub fn decode(format: Format, point: Point) -> [f64; 3] {
    point.map(|bits| f32::from_bits(float::convert(format, Format::F32, bits.into()) as u32).into())
}

/// A tree whose splits are at the median mostly, and somewhere else often enough to be unbalanced.
pub fn build(config: &Config, points: &mut [[f32; 3]], random: &mut Rng) -> Tree {
    let mut tree = Tree { records: BTreeMap::new(), points: Vec::new(), internal_leaves: 0 };
    tree.divide(config, points, 1, 0, random);
    tree
}

impl Tree {
    fn divide(&mut self, config: &Config, points: &mut [[f32; 3]], node: u32, level: u32, random: &mut Rng) {
        if level == config.tree_depth {
            return self.add_leaf(config, points, node - (1 << level));
        }
        let mut write = TreeWrite { address: node, ..TreeWrite::default() };
        if points.len() <= config.bucket as usize && random.bool() {
            write.node.internal_leaf = true;
            self.internal_leaves += 1;
            self.records.insert(node, write);
            return self.add_leaf(config, points, (node << (config.tree_depth - level)) - (1 << config.tree_depth));
        }
        let child_capacity = (config.bucket as usize) << (config.tree_depth - level - 1);
        let (fewest, most) = (points.len().saturating_sub(child_capacity), points.len().min(child_capacity));
        let middle = if random.u8(0..4) == 0 { random.usize(fewest..=most) } else { points.len() / 2 };
        write.node.dimension = random.u8(0..3);
        let axis = usize::from(write.node.dimension);
        points.sort_by(|a, b| a[axis].total_cmp(&b[axis]));
        // Points on the plane may lie on both sides.
        let on_plane = points.get(middle).or(points.last());
        write.node.split = on_plane.map_or(0, |point| encode(config.geometry, point[axis]));
        self.records.insert(node, write);
        let (left, right) = points.split_at_mut(middle);
        self.divide(config, left, 2 * node, level + 1, random);
        self.divide(config, right, 2 * node + 1, level + 1, random);
    }

    fn add_leaf(&mut self, config: &Config, points: &[[f32; 3]], address: u32) {
        let lanes = config.lanes as usize;
        let begin = (self.points.len() / lanes) as u32;
        let beats = points.len().div_ceil(lanes).max(1);
        self.points.extend(points.iter().map(|point| point.map(|number| encode(config.geometry, number))));
        self.points.resize((begin as usize + beats) * lanes, [config.geometry.quiet_nan() as u32; 3]);
        let write =
            TreeWrite { is_leaf: true, address, bucket: Bucket { begin, beats: beats as u8 }, ..TreeWrite::default() };
        self.records.insert(1 << config.tree_depth | address, write);
    }
}
