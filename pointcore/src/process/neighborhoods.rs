//! The neighbors of positions: the k nearest, or all within a radius, at most k of them; nearest first.

use super::ProcessError;
use super::words::encode_word;
use crate::number::{decode, encode};
use crate::search::{PointSet, SearchError};
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use pointcore_contract::Format;
use pointcore_contract::process::Scalar;
use pointcore_contract::search::records::Point;
use pointcore_golden::search::leaf::squared_distance;
use std::num::NonZero;

/// The most neighbors that a query has.
pub const NEIGHBORS_LIMIT: u32 = 64;

/// How many points more are looked at, since the core's rounding may order others at nearly the same distance.
const TIED: usize = 8;

/// A search among points. Distances are those of the search core, bit for bit; points at one distance come in the order
/// of the set.
#[derive(Clone, Debug)]
pub struct Neighborhoods {
    format: Format,
    encoded: Vec<Point>,
    tree: ImmutableKdTree<f64, 3>,
    k: usize,
    radius: Option<f32>,
    radius2: u32,
}

impl Neighborhoods {
    /// Prepares for searches.
    ///
    /// # Errors
    /// A number of neighbors or a radius without meaning.
    pub fn new(points: &PointSet, k: u32, radius: Option<f64>) -> Result<Self, ProcessError> {
        let format = points.format();
        if !(1..=NEIGHBORS_LIMIT).contains(&k) {
            return Err(ProcessError::Neighbors(k));
        }
        let problem = |radius: f32, problem: &str| SearchError::Query {
            index: 0,
            problem: format!("the radius is {radius:e}: {problem}"),
        };
        let radius2 = match radius {
            None => format.infinity() as u32,
            Some(radius) if radius > 0.0 => {
                let radius = radius as f32;
                let radius2 = encode(format, radius * radius);
                encode_word(format, Scalar::Float, (radius * radius).into())
                    .map_err(|_| problem(radius, &format!("its square is not finite in {format}")))?;
                if radius2 == 0 {
                    return Err(problem(radius, &format!("its square vanishes in {format}")).into());
                }
                radius2
            }
            Some(radius) => return Err(problem(radius as f32, "expected a positive number").into()),
        };
        let coordinates: Vec<[f64; 3]> = points.points().iter().map(|point| point.map(f64::from)).collect();
        let tree = ImmutableKdTree::new_from_slice(&coordinates);
        let radius = radius.map(|radius| radius as f32);
        Ok(Self { format, encoded: points.encoded(), tree, k: k as usize, radius, radius2 })
    }

    /// Neighbors of a position at most.
    #[must_use]
    pub const fn k(&self) -> u32 {
        self.k as u32
    }

    /// Only points nearer than this are neighbors.
    #[must_use]
    pub const fn radius(&self) -> Option<f32> {
        self.radius
    }

    /// The points near a position given by its words, nearest first; none where it is no position.
    #[must_use]
    pub fn of(&self, position: Point) -> Vec<u32> {
        let place = position.map(|word| f64::from(decode(self.format, word)));
        if !place.iter().all(|number| number.is_finite()) {
            return vec![];
        }
        let measure =
            |index: u64| (squared_distance(self.format, self.encoded[index as usize], position), index as u32);
        let mut wanted = self.k + TIED;
        let mut near: Vec<(u32, u32)> = loop {
            let count = NonZero::<usize>::MIN.saturating_add(wanted - 1);
            let found = self.tree.nearest_n::<SquaredEuclidean>(&place, count);
            let near: Vec<(u32, u32)> = found.iter().map(|near| measure(near.item)).collect();
            // More may be as near as the last one that counts.
            let farthest = near.iter().map(|(distance2, _)| *distance2).max();
            let nearer = near.iter().filter(|(distance2, _)| Some(*distance2) < farthest).count();
            if nearer >= self.k || near.len() < wanted {
                break near;
            }
            wanted *= 2;
        };
        near.retain(|(distance2, _)| *distance2 < self.radius2);
        // Encodings of positive numbers are in the order of the numbers.
        near.sort_unstable();
        near.truncate(self.k);
        near.into_iter().map(|(_, index)| index).collect()
    }
}
