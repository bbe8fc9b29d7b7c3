//! Kd-trees as the search core takes them: an implicit heap, buckets that begin at a beat.
//!
//! Node 1 is the root, `2i` and `2i + 1` are the children of `i`; a node of at most `bucket` points is a leaf wherever it lies, and
//! the table of leaves has it where eq. 6.7 puts it: at the leftmost leaf of the deepest level below it. Points left of a plane have
//! coordinates ≤ the split, points right of it ≥, which is all the search asks for: equal coordinates may lie on both sides.

mod divide;
mod records;
mod splitting;

use splitting::Item;
pub use splitting::Splitting;

use super::{PointSet, SearchError};
use crate::number::encode;
use divide::Part;
use pointcore_contract::Format;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::Point;
use std::fmt;

/// What a node holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node {
    /// A plane across `dimension`.
    Split {
        /// 0, 1 or 2 for x, y or z.
        dimension: u8,
        /// The plane's coordinate.
        split: f32,
    },
    /// A leaf before the deepest level.
    Leaf,
}

/// Where the points of a leaf lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bucket {
    /// First beat.
    pub begin: u32,
    /// Number of beats, at least one.
    pub beats: u32,
    /// Number of points.
    pub points: u32,
}

/// A tree with its point memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Tree {
    format: Format,
    lanes: u32,
    /// By address; `None` where no node is.
    nodes: Vec<Option<Node>>,
    /// By number among those of the deepest level.
    leaves: Vec<Option<Bucket>>,
    memory: Vec<Point>,
    /// The user's index of the point in each place.
    sources: Vec<Option<u32>>,
}

/// The smallest `tree_depth` whose leaves hold so many points.
#[must_use]
pub fn depth_for(points: usize, bucket: u32) -> u32 {
    points.div_ceil(bucket as usize).next_power_of_two().ilog2().max(1)
}

impl Tree {
    /// Builds a tree for the hardware of a configuration.
    ///
    /// # Errors
    /// The configuration is not valid, or its tree or point memory is too small.
    pub fn build(config: &Config, points: &PointSet, splitting: Splitting) -> Result<Self, SearchError> {
        config.validate()?;
        let (depth, bucket, count) = (config.tree_depth, config.bucket, points.points().len());
        let capacity = (bucket as usize) << depth;
        if count > capacity {
            return Err(SearchError::Capacity {
                points: count,
                depth,
                bucket,
                capacity,
                needed: depth_for(count, bucket),
            });
        }
        let item = |(index, point): (usize, &[f32; 3])| Item { point: *point, index: index as u32 };
        let mut items: Vec<Item> = points.points().iter().enumerate().map(item).collect();
        let parts = divide::divide(&mut items, divide::Limits { depth, bucket: bucket as usize, splitting });

        let mut tree = Self {
            format: points.format(),
            lanes: config.lanes,
            nodes: vec![None; 1 << depth],
            leaves: vec![None; 1 << depth],
            memory: Vec::new(),
            sources: Vec::new(),
        };
        let mut rest = &items[..];
        for part in parts {
            match part {
                Part::Split { node, dimension, split } => {
                    tree.nodes[node as usize] = Some(Node::Split { dimension, split });
                }
                Part::Leaf { node, points } => {
                    let (bucket, others) = rest.split_at(points);
                    rest = others;
                    tree.add_leaf(node, depth, bucket);
                }
            }
        }
        let (places, bits) = (tree.memory.len(), config.index_bits);
        if places as u64 > 1 << bits {
            let needed = (places as u64).next_power_of_two().ilog2();
            return Err(SearchError::Addresses { places, bits, limit: 1 << bits, needed });
        }
        Ok(tree)
    }

    /// Whether this tree fits the hardware of a configuration.
    pub(crate) fn check(&self, config: &Config) -> Result<(), SearchError> {
        let same = self.format == config.geometry
            && self.lanes == config.lanes
            && self.leaves.len() == 1 << config.tree_depth
            && self.memory.len() as u64 <= 1 << config.index_bits
            && self.leaves.iter().flatten().all(|bucket| bucket.points <= config.bucket);
        if same { Ok(()) } else { Err(SearchError::OtherTree) }
    }

    fn add_leaf(&mut self, node: u32, depth: u32, items: &[Item]) {
        let level = node.ilog2();
        if level < depth {
            self.nodes[node as usize] = Some(Node::Leaf);
        }
        let begin = self.memory.len() as u32 / self.lanes;
        let beats = (items.len() as u32).div_ceil(self.lanes).max(1);
        self.memory.extend(items.iter().map(|item| item.point.map(|number| encode(self.format, number))));
        self.sources.extend(items.iter().map(|item| Some(item.index)));
        let end = ((begin + beats) * self.lanes) as usize;
        self.memory.resize(end, [self.format.quiet_nan() as u32; 3]);
        self.sources.resize(end, None);
        let number = (node << (depth - level)) - (1 << depth);
        self.leaves[number as usize] = Some(Bucket { begin, beats, points: items.len() as u32 });
    }

    /// The points of a beat.
    #[must_use]
    pub fn beat(&self, address: u32) -> &[Point] {
        let first = (address * self.lanes) as usize;
        &self.memory[first..first + self.lanes as usize]
    }

    /// The point memory: `lanes` places a beat, NaN where there is no point.
    #[must_use]
    pub fn memory(&self) -> &[Point] {
        &self.memory
    }

    /// The user's index of the point in a place of the point memory.
    #[must_use]
    pub fn source(&self, place: u32) -> Option<u32> {
        self.sources.get(place as usize).copied().flatten()
    }

    /// Bytes of a beat in the point memory.
    #[must_use]
    pub fn beat_bytes(&self) -> u32 {
        self.lanes * (3 * self.format.width()).div_ceil(u8::BITS)
    }

    /// What was built.
    #[must_use]
    pub fn statistics(&self) -> TreeStatistics {
        let buckets = || self.leaves.iter().flatten();
        let depth = self.leaves.len().ilog2();
        let leaves = buckets().count();
        let level = |(address, node): (usize, &Option<Node>)| (*node == Some(Node::Leaf)).then(|| address.ilog2());
        let internal: Vec<u32> = self.nodes.iter().enumerate().filter_map(level).collect();
        let deepest = if internal.len() < leaves { depth } else { internal.into_iter().max().unwrap_or(0) };
        TreeStatistics {
            points: buckets().map(|bucket| bucket.points as usize).sum(),
            nodes: self.nodes.iter().flatten().filter(|node| **node != Node::Leaf).count(),
            leaves,
            depth: deepest,
            mean_points: buckets().map(|bucket| f64::from(bucket.points)).sum::<f64>() / leaves as f64,
            beats: self.memory.len() / self.lanes as usize,
            memory_bytes: self.memory.len() / self.lanes as usize * self.beat_bytes() as usize,
        }
    }
}

/// The size and shape of a tree.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct TreeStatistics {
    /// Points in it.
    pub points: usize,
    /// Nodes with a plane.
    pub nodes: usize,
    /// Leaves.
    pub leaves: usize,
    /// Planes above the deepest leaf.
    pub depth: u32,
    /// Points a leaf, on average.
    pub mean_points: f64,
    /// Beats of the point memory.
    pub beats: usize,
    /// Bytes of the point memory.
    pub memory_bytes: usize,
}

impl fmt::Display for TreeStatistics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { points, leaves, depth, mean_points, memory_bytes, .. } = self;
        write!(
            f,
            "{points} points in {leaves} leaves of {mean_points:.1} on average, {depth} levels, {memory_bytes} bytes of points"
        )
    }
}

#[cfg(test)]
mod tests;
