//! The recursion that sorts points into leaves.

use super::splitting::{Item, Splitting};

/// Points below which dividing is not worth another thread.
const PARALLEL_POINTS: usize = 4096;

/// A part of the tree; leaves come from left to right, as their points lie.
#[derive(Clone, Copy, Debug)]
pub enum Part {
    Split { node: u32, dimension: u8, split: f32 },
    Leaf { node: u32, points: usize },
}

/// What the tree must fit.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    pub depth: u32,
    pub bucket: usize,
    pub splitting: Splitting,
}

/// Reorders `items`, of which there are no more than fit, leaf by leaf.
pub fn divide(items: &mut [Item], limits: Limits) -> Vec<Part> {
    let mut parts = Vec::new();
    divide_node(items, 1, limits, &mut parts);
    parts
}

fn divide_node(items: &mut [Item], node: u32, limits: Limits, parts: &mut Vec<Part>) {
    let count = items.len();
    if count <= limits.bucket {
        parts.push(Part::Leaf { node, points: count });
        return;
    }
    let child_capacity = limits.bucket << (limits.depth - node.ilog2() - 1);
    let allowed = count.saturating_sub(child_capacity).max(1)..=child_capacity.min(count - 1);
    let (axis, low, high) = widest(items);
    let left = limits.splitting.count_left(items, (axis, low, high), limits.bucket, allowed);
    // Indices decide among equal coordinates, so that a tree is a function of its points.
    let order = |a: &Item, b: &Item| a.point[axis].total_cmp(&b.point[axis]).then(a.index.cmp(&b.index));
    // A point on the plane goes right first, where the plane's own points are.
    let split = items.select_nth_unstable_by(left, order).1.point[axis];
    parts.push(Part::Split { node, dimension: axis as u8, split });
    let (left, right) = items.split_at_mut(left);
    if count < PARALLEL_POINTS {
        divide_node(left, 2 * node, limits, parts);
        divide_node(right, 2 * node + 1, limits, parts);
    } else {
        let mut right_parts = Vec::new();
        rayon::join(
            || divide_node(left, 2 * node, limits, parts),
            || divide_node(right, 2 * node + 1, limits, &mut right_parts),
        );
        parts.append(&mut right_parts);
    }
}

/// The dimension in which the points spread most, with the least and the greatest coordinate there.
fn widest(items: &[Item]) -> (usize, f32, f32) {
    let bounds = [0, 1, 2].map(|axis| {
        let coordinates = items.iter().map(|item| item.point[axis]);
        coordinates.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    });
    let extent = |axis: &usize| f64::from(bounds[*axis].1) - f64::from(bounds[*axis].0);
    let axis = (0..bounds.len()).max_by(|a, b| extent(a).total_cmp(&extent(b))).expect("space has dimensions");
    (axis, bounds[axis].0, bounds[axis].1)
}
