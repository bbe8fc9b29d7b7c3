//! Neighbors against a search through all points.

use super::points::{PointSet, encode};
use super::query::{Neighbor, Query};
use pointcore_golden::core_b::leaf::squared_distance;
use pointcore_golden::reference::neighbors::BruteForce;
use rayon::prelude::*;
use std::fmt;

/// Distances that a check may compute: some ten seconds on two cores.
const DISTANCE_LIMIT: usize = 20_000_000_000;

/// A query that was answered wrongly.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Index of the query.
    pub query: usize,
    /// Squared distances found.
    pub found: Vec<f32>,
    /// Squared distances of the nearest of all points.
    pub expected: Vec<f32>,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { query, found, expected } = self;
        write!(f, "query {query}: squared distances {found:?}, but a search through all points finds {expected:?}")
    }
}

/// Compares squared distances bit for bit; of neighbors at equal distance any will do, but each must lie where it says. Where all
/// queries would take too long, evenly spaced ones are checked.
///
/// # Errors
/// The first difference.
pub fn check(points: &PointSet, queries: &[Query], neighbors: &[Vec<Neighbor>]) -> Result<usize, Difference> {
    let format = points.format();
    let encoded = points.encoded();
    let brute_force = BruteForce::new(format, &encoded);
    let step = (queries.len() * encoded.len()).div_ceil(DISTANCE_LIMIT).max(1);
    let wrong = |index: usize| {
        let Query { point, k, radius } = queries[index];
        let at = point.map(|number| encode(format, number));
        let radius2 = radius.map_or(format.infinity() as u32, |radius| encode(format, radius * radius));
        let expected = brute_force.nearest(at, k as usize, radius2);
        let found = &neighbors[index];
        let agree = |(found, expected): (&Neighbor, u32)| {
            let distance2 = encode(format, found.distance2);
            distance2 == expected && squared_distance(format, encoded[found.point as usize], at) == distance2
        };
        let pairs = || found.iter().zip(expected.iter().map(|neighbor| neighbor.distance2));
        let right = found.len() == expected.len() && pairs().all(agree) && all_differ(found);
        (!right).then(|| Difference {
            query: index,
            found: found.iter().map(|neighbor| neighbor.distance2).collect(),
            expected: expected.iter().map(|neighbor| super::decode(format, neighbor.distance2)).collect(),
        })
    };
    let checked: Vec<usize> = (0..queries.len()).step_by(step).collect();
    match checked.par_iter().find_map_first(|index| wrong(*index)) {
        Some(difference) => Err(difference),
        None => Ok(checked.len()),
    }
}

fn all_differ(neighbors: &[Neighbor]) -> bool {
    let mut points: Vec<_> = neighbors.iter().map(|neighbor| neighbor.point).collect();
    points.sort_unstable();
    points.windows(2).all(|pair| pair[0] != pair[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core_b::{Engine, MemorySettings, Order, Session, Source, Splitting, Tree, config_for};
    use crate::scene::model::tests::shared;
    use pointcore_spec::Format;

    #[test]
    fn only_right_answers_pass() {
        let points =
            PointSet::new(Format::F32, &[[0.0; 3], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]]).expect("points are finite");
        let query = Query { point: [0.0; 3], k: 2, radius: None };
        let check = |found: &[(u32, f32)]| {
            let found = found.iter().map(|(point, distance2)| Neighbor { point: *point, distance2: *distance2 });
            check(&points, &[query], &[found.collect()]).is_ok()
        };
        assert!(check(&[(0, 0.0), (1, 1.0)]) && check(&[(0, 0.0), (2, 1.0)]), "of two at equal distance any will do");
        assert!(!check(&[(0, 0.0)]), "one is missing");
        assert!(!check(&[(1, 0.0), (2, 1.0)]), "a point lies elsewhere");
        assert!(!check(&[(1, 1.0), (2, 1.0)]), "the nearest is missing");
        let doubled = PointSet::new(Format::F32, &[[1.0; 3], [1.0; 3]]).expect("points are finite");
        let twice = vec![Neighbor { point: 0, distance2: 3.0 }; 2];
        let difference = super::check(&doubled, &[query], &[twice]).expect_err("a neighbor is found twice");
        assert!(difference.to_string().starts_with("query 0"));
    }

    #[test]
    fn neighbors_in_a_scan_are_the_nearest() {
        let Some((path, model)) = shared("igea.ply") else { return };
        for (splitting, order) in
            [(Splitting::Packed, Order::Random), (Splitting::Midpoint, Order::Grid { columns: 3, rows: 3 })]
        {
            let config = config_for(model.points.len(), 10, splitting);
            let points = PointSet::load(config.geometry, &Source::File(path.clone())).expect("the scan is good");
            let tree = Tree::build(&config, &points, splitting).expect("the points fit");
            let session =
                Session::open(config, tree, MemorySettings::default(), Engine::Golden).expect("the core is valid");
            let query = |point: &[f32; 3]| Query { point: *point, k: 10, radius: None };
            let queries: Vec<_> = order.places(&points, Some(200), 1).iter().map(query).collect();
            let outcome = session.search(&queries).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(super::check(&points, &queries, &outcome.neighbors), Ok(200));
        }
    }
}
