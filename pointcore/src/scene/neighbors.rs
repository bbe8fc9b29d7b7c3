//! Nearest neighbors of every point, and the spacing they give.

use glam::DVec3;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;
use std::collections::HashMap;

/// Neighbors whose mean distance is a point's spacing: on a regular surface sampling, two rings of six less one.
pub const SPACING_NEIGHBORS: usize = 11;

/// A point's neighbor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearPoint {
    /// Its index.
    pub index: u32,
    /// Its distance.
    pub distance: f64,
}

/// Finds the `count` nearest other points of each point (fewer if there are no more), nearest first.
#[must_use]
pub fn nearest(points: &[DVec3], count: usize) -> Vec<Vec<NearPoint>> {
    nearest_of(points, &(0..points.len()).collect::<Vec<_>>(), count)
}

/// As [`nearest`], of some of the points, by their indices.
#[must_use]
pub fn nearest_of(points: &[DVec3], indices: &[usize], count: usize) -> Vec<Vec<NearPoint>> {
    let coordinates: Vec<[f64; 3]> = points.iter().map(DVec3::to_array).collect();
    let tree = ImmutableKdTree::<f64, 3>::new_from_slice(&coordinates);
    let wanted = std::num::NonZero::<usize>::MIN.saturating_add(count);
    let neighbors_of = |&index: &usize| {
        let found = tree.nearest_n::<SquaredEuclidean>(&coordinates[index], wanted);
        // Among coincident points the tree may leave out the point itself.
        let others = found.iter().filter(|neighbor| neighbor.item != index as u64).take(count);
        others.map(|neighbor| NearPoint { index: neighbor.item as u32, distance: neighbor.distance.sqrt() }).collect()
    };
    indices.par_iter().map(neighbors_of).collect()
}

/// The mean distance of each point to its [`SPACING_NEIGHBORS`] nearest neighbors.
///
/// # Errors
/// A point has no neighbor at any distance but zero.
pub fn spacing(points: &[DVec3]) -> Result<Vec<f64>, String> {
    if points.len() < 2 {
        return Err("holds a single point, which has no spacing: give the radius as a number".to_owned());
    }
    let mean = |neighbors: &Vec<NearPoint>| {
        neighbors.iter().map(|neighbor| neighbor.distance).sum::<f64>() / neighbors.len() as f64
    };
    let spacing: Vec<f64> = nearest(points, SPACING_NEIGHBORS).par_iter().map(mean).collect();
    match spacing.iter().position(|distance| *distance == 0.0) {
        Some(index) => Err(format!(
            "vertex {index} coincides with all its neighbors, so it has no spacing: remove duplicate vertices or give \
             the radius as a number"
        )),
        None => Ok(spacing),
    }
}

/// Points without those that lie exactly where another one does, which are no neighbors to measure by.
#[derive(Clone, Debug, PartialEq)]
pub struct Distinct {
    /// The points, each place once.
    pub points: Vec<DVec3>,
    /// The place of each of the points that were given.
    pub places: Vec<u32>,
}

impl Distinct {
    /// Finds them.
    #[must_use]
    pub fn of(points: &[DVec3]) -> Self {
        let (mut known, mut distinct) = (HashMap::with_capacity(points.len()), Vec::new());
        let mut place = |point: &DVec3| {
            // Of the two zeros each is where the other is.
            let key = (*point + DVec3::ZERO).to_array().map(f64::to_bits);
            *known.entry(key).or_insert_with(|| {
                distinct.push(*point);
                distinct.len() as u32 - 1
            })
        };
        let places = points.iter().map(&mut place).collect();
        Self { points: distinct, places }
    }

    /// What was found of the places, for each of the points that were given.
    #[must_use]
    pub fn spread<T: Clone>(&self, found: &[T]) -> Vec<T> {
        self.places.iter().map(|&place| found[place as usize].clone()).collect()
    }
}
