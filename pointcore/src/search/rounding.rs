//! What rounding to the core's format does to points and to their neighbors.

use super::{Neighbor, PointSet, Query, SearchError};
use glam::DVec3;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use pointcore_contract::Format;
use rayon::prelude::*;
use std::fmt;
use std::num::NonZero;

/// Points whose neighbors are compared.
const SAMPLES: usize = 1000;
/// Neighbors among which the nearest one elsewhere is looked for: a point may lie there several times.
const SPACING_NEIGHBORS: usize = 8;
/// The share of neighbors that may be others before a search is refused.
const OTHERS_LIMIT: f64 = 0.01;
/// Distances that differ by less, as a share, are taken for equal: of neighbors at equal distance any will do.
const TIE_SHARE: f64 = 1e-9;
/// The same in units of the last place of the coordinates, in which the input itself is rounded.
const TIE_ULPS: f64 = 8.0;

/// Neighbors of given points, in f64.
pub struct Truth {
    tree: ImmutableKdTree<f64, 3>,
    /// A distance that is lost in the rounding of the given coordinates.
    tie: f64,
}

impl Truth {
    /// Prepares for searches among points.
    #[must_use]
    pub fn new(points: &[DVec3]) -> Self {
        let coordinates: Vec<[f64; 3]> = points.iter().map(DVec3::to_array).collect();
        let largest = points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
        Self { tree: ImmutableKdTree::new_from_slice(&coordinates), tie: TIE_ULPS * f64::EPSILON * largest }
    }

    /// Indices and distances of the `count` nearest points, nearest first.
    fn nearest(&self, place: DVec3, count: usize) -> impl Iterator<Item = (u32, f64)> {
        let count = NonZero::new(count).unwrap_or(NonZero::<usize>::MIN);
        let found = self.tree.nearest_n::<SquaredEuclidean>(&place.to_array(), count);
        found.into_iter().map(|neighbor| (neighbor.item as u32, neighbor.distance.sqrt()))
    }

    /// How many of the neighbors found at these distances are none of the `count` nearest within `radius`, or are missing, and how
    /// many there are.
    fn others(&self, place: DVec3, count: usize, radius: f64, found: &[f64]) -> (usize, usize) {
        let nearest: Vec<f64> = self.nearest(place, count).map(|(_, distance)| distance).collect();
        let reach =
            if nearest.len() == count { nearest.last().map_or(radius, |last| last.min(radius)) } else { radius };
        let slack = TIE_SHARE * if reach.is_finite() { reach } else { 0.0 } + self.tie;
        // What lies at the radius itself may be taken or left.
        let wanted = nearest.iter().filter(|distance| **distance < radius - slack).count();
        let right = found.iter().filter(|distance| **distance <= reach + slack).count();
        (wanted.saturating_sub(right).max(found.len() - right), wanted.max(found.len()))
    }
}

/// How far rounding moves points, beside how near they lie, and what that does to their neighbors.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Rounding {
    /// What the core's coordinates are relative to.
    pub origin: [f64; 3],
    /// The farthest that a point is moved.
    pub greatest: f64,
    /// The median distance of a point to the nearest one elsewhere; 0 if there is none.
    pub spacing: f64,
    /// Points whose neighbors among the rounded points were compared with those among the given ones.
    pub sampled: usize,
    /// Their neighbors.
    pub neighbors: usize,
    /// Those of them that are others, farther than the true ones.
    pub others: usize,
    /// Points that were elsewhere than another one and no longer are, among those sampled.
    pub merged: usize,
    #[serde(skip)]
    format: Format,
}

impl Rounding {
    /// Measures what rounding did to a point set in which so many neighbors are searched.
    #[must_use]
    pub fn of(points: &PointSet, neighbors: u32) -> Self {
        let (given, origin) = (points.given(), points.origin());
        let seen: Vec<DVec3> =
            points.points().par_iter().map(|point| DVec3::from_array(point.map(f64::from)) + origin).collect();
        let moved = given.par_iter().zip(&seen).map(|(given, seen)| given.distance(*seen));
        let greatest = moved.reduce(|| 0.0, f64::max);

        let count = neighbors as usize;
        let truth = Truth::new(given);
        let rounded = (greatest > 0.0).then(|| Truth::new(&seen));
        let sample = |index: usize| {
            let place = given[index];
            let apart =
                truth.nearest(place, SPACING_NEIGHBORS).map(|(_, distance)| distance).find(|distance| *distance > 0.0);
            let Some(rounded) = &rounded else { return (apart, 0, count.min(given.len()), false) };
            let found = rounded.nearest(seen[index], count);
            let found: Vec<f64> = found.map(|(other, _)| given[other as usize].distance(place)).collect();
            let (others, of) = truth.others(place, count, f64::INFINITY, &found);
            let merged = rounded
                .nearest(seen[index], count)
                .any(|(other, distance)| distance == 0.0 && given[other as usize] != place);
            (apart, others, of, merged)
        };
        let step = given.len().div_ceil(SAMPLES).max(1);
        let samples: Vec<_> = (0..given.len()).into_par_iter().step_by(step).map(sample).collect();
        let mut spacings: Vec<f64> = samples.iter().filter_map(|(apart, ..)| *apart).collect();
        spacings.sort_by(f64::total_cmp);
        Self {
            origin: origin.to_array(),
            greatest,
            spacing: spacings.get(spacings.len() / 2).copied().unwrap_or(0.0),
            sampled: samples.len(),
            neighbors: samples.iter().map(|(_, _, of, _)| of).sum(),
            others: samples.iter().map(|(_, others, ..)| others).sum(),
            merged: samples.iter().filter(|(.., merged)| *merged).count(),
            format: points.format(),
        }
    }

    /// Refuses points that are too near for the format.
    ///
    /// # Errors
    /// More than a hundredth of the neighbors would be others.
    pub fn check(self) -> Result<Self, SearchError> {
        if self.others as f64 > OTHERS_LIMIT * self.neighbors as f64 {
            Err(SearchError::Rounding(self))
        } else {
            Ok(self)
        }
    }

    /// What would help.
    pub(super) fn remedy(&self) -> &'static str {
        if self.format.mantissa < Format::F32.mantissa {
            "set `geometry` = \"f32-ftz\""
        } else {
            "cut the cloud into tiles and search each for itself, or thin it out"
        }
    }
}

impl fmt::Display for Rounding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { origin, greatest, spacing, sampled, neighbors, others, merged, format } = self;
        if *origin != [0.0; 3] {
            let [x, y, z] = origin;
            write!(f, "relative to ({x}, {y}, {z}), ")?;
        }
        if *greatest == 0.0 {
            return write!(f, "none: all coordinates are numbers of {format}");
        }
        write!(f, "points are moved by up to {greatest:.1e} in {format}")?;
        if *spacing > 0.0 {
            write!(f, ", {:.1e} of their spacing of {spacing:.1e}", greatest / spacing)?;
        }
        write!(f, "; {others} of the {neighbors} neighbors of {sampled} points become others")?;
        if *merged > 0 { write!(f, ", {merged} of these points coincide with another one") } else { Ok(()) }
    }
}

/// Answers beside the truth of the input.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct TruthComparison {
    /// Queries compared.
    pub queries: usize,
    /// Neighbors that they have.
    pub neighbors: usize,
    /// Neighbors that are none of the nearest of the given points in f64, or are missing.
    pub others: usize,
}

/// Compares answers with those that the points as they were given have in f64; `places` are where the queries were given.
#[must_use]
pub fn compare_with_truth(
    points: &PointSet,
    places: &[DVec3],
    queries: &[Query],
    answers: &[Vec<Neighbor>],
) -> TruthComparison {
    let truth = Truth::new(points.given());
    let compare = |((place, query), answer): ((&DVec3, &Query), &Vec<Neighbor>)| {
        let found = answer.iter().map(|neighbor| points.given()[neighbor.point as usize].distance(*place));
        let radius = query.radius.map_or(f64::INFINITY, f64::from);
        truth.others(*place, query.k as usize, radius, &found.collect::<Vec<_>>())
    };
    let compared: Vec<_> = places.par_iter().zip(queries).zip(answers).map(compare).collect();
    TruthComparison {
        queries: compared.len(),
        neighbors: compared.iter().map(|(_, of)| of).sum(),
        others: compared.iter().map(|(others, _)| others).sum(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a surface, so many apart, around a place.
    fn cloud(place: DVec3, spacing: f64) -> Vec<DVec3> {
        let mut random = fastrand::Rng::with_seed(1);
        let mut jitter = || random.f64() - 0.5;
        let at = |index: i32| {
            let [column, row] = [index % 60, index / 60].map(f64::from);
            place + spacing * DVec3::new(column + jitter(), row + jitter(), 0.1 * jitter())
        };
        (0..3600).map(at).collect()
    }

    const MAP: DVec3 = DVec3::new(412_345.6, 5_654_321.0, 120.0);

    #[test]
    fn a_map_is_searched_right_once_it_is_recentered() {
        let given = cloud(MAP, 0.05);
        let recentered = Rounding::of(&PointSet::recentered(Format::F32, given.clone()).expect("points"), 10);
        assert!(recentered.check().is_ok(), "{recentered}");
        assert!(recentered.greatest < 1e-6 && recentered.others < 10, "{recentered}");
        assert!((0.02..0.06).contains(&recentered.spacing), "{recentered}");
        let lost = Rounding::of(&PointSet::about(Format::F32, DVec3::ZERO, given).expect("points"), 10);
        assert!(lost.others * 4 > lost.neighbors && lost.merged > 0, "{lost}");
        let message = lost.check().expect_err("too near").to_string();
        assert!(message.contains("cut the cloud into tiles"), "{message}");
    }

    #[test]
    fn a_format_too_coarse_is_refused_with_the_one_that_does() {
        let far = [cloud(DVec3::ZERO, 0.001), vec![DVec3::splat(100.0)]].concat();
        let rounding = |format| Rounding::of(&PointSet::recentered(format, far.clone()).expect("points"), 8);
        assert!(rounding(Format::F32).check().is_ok(), "{}", rounding(Format::F32));
        let fine = [cloud(DVec3::new(0.0, 50.0, 0.0), 0.001), vec![DVec3::splat(100.0)]].concat();
        let refused = Rounding::of(&PointSet::recentered(Format::F24, fine).expect("points"), 8).check();
        assert!(refused.expect_err("too near").to_string().contains("`geometry` = \"f32-ftz\""));
    }

    #[test]
    fn what_is_exact_costs_nothing_and_ties_are_no_others() {
        let lattice: Vec<_> = (0..1000)
            .map(|i| DVec3::new((i % 10).into(), (i / 10 % 10).into(), (i / 100).into()) * 0.1 + MAP)
            .collect();
        let tied = Rounding::of(&PointSet::recentered(Format::F32, lattice).expect("points"), 9);
        assert!(tied.greatest > 0.0 && tied.others == 0, "{tied}");
        let exact = PointSet::new(Format::F32, &[[0.0; 3], [1.0, 0.0, 0.0]]).expect("points");
        let exact = Rounding::of(&exact, 9);
        assert_eq!((exact.greatest, exact.others, exact.spacing), (0.0, 0, 1.0));
        assert!(exact.to_string().starts_with("none"));
    }

    #[test]
    fn answers_are_counted_beside_the_truth() {
        let points = PointSet::new(Format::F32, &[[0.0; 3], [1.0, 0.0, 0.0], [3.0, 0.0, 0.0]]).expect("points");
        let others = |query: Query, found: &[u32]| {
            let answer = found.iter().map(|point| Neighbor { point: *point, distance2: 0.0 }).collect();
            let truth = compare_with_truth(&points, &[DVec3::ZERO], &[query], &[answer]);
            (truth.others, truth.neighbors)
        };
        let two = Query { point: [0.0; 3], k: 2, radius: None };
        assert_eq!((others(two, &[0, 1]), others(two, &[0, 2]), others(two, &[0])), ((0, 2), (1, 2), (1, 2)));
        let ball = Query { k: 3, radius: Some(2.0), ..two };
        assert_eq!((others(ball, &[0, 1]), others(ball, &[0, 1, 2]), others(ball, &[])), ((0, 2), (1, 3), (2, 2)));
        let edge = Query { radius: Some(1.0), ..ball };
        assert_eq!((others(edge, &[0]), others(edge, &[0, 1])), ((0, 1), (0, 2)), "at the radius either will do");
    }
}
