//! Neighbors against a search through all points.

use super::points::PointSet;
use super::query::{Neighbor, Query};
use super::reuse::QueryKind;
use crate::number::{decode, encode};
use pointcore_contract::Format;
use pointcore_contract::search::records::Point;
use pointcore_golden::reference::neighbors::BruteForce;
use pointcore_golden::search::leaf::squared_distance;
use rayon::prelude::*;
use std::fmt;

/// Distances that a check may compute: some ten seconds on two cores.
const DISTANCE_LIMIT: usize = 20_000_000_000;

/// A query that was answered wrongly.
#[derive(Clone, Debug, PartialEq)]
pub struct WrongAnswer {
    /// Index of the query.
    pub query: usize,
    /// Squared distances found.
    pub found: Vec<f32>,
    /// Squared distances of the nearest of all points.
    pub expected: Vec<f32>,
}

impl fmt::Display for WrongAnswer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { query, found, expected } = self;
        write!(f, "query {query}: squared distances {found:?}, but a search through all points finds {expected:?}")
    }
}

/// What a check found.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Checked {
    /// Queries compared.
    pub queries: usize,
    /// Those whose distances equal the true ones bit for bit: all, where no approximation is allowed.
    pub exact: usize,
    /// The greatest ratio of the distance of the farthest neighbor to the true one's, 1 at least.
    pub worst_ratio: f32,
}

/// Compares squared distances bit for bit; of neighbors at equal distance any will do, but each must lie where it says. Where all
/// queries would take too long, evenly spaced ones are checked. With an `epsilon` (thesis 6.4.2) the k-th nearest neighbor may be
/// farther by the factor 1 + ε, and balls may lack neighbors.
///
/// # Errors
/// The first difference.
pub fn check(
    points: &PointSet,
    queries: &[Query],
    neighbors: &[Vec<Neighbor>],
    epsilon: f32,
) -> Result<Checked, WrongAnswer> {
    let encoded = points.encoded();
    let comparison = Comparison {
        format: points.format(),
        encoded: &encoded,
        brute_force: BruteForce::new(points.format(), &encoded),
        epsilon,
    };
    let step = (queries.len() * encoded.len()).div_ceil(DISTANCE_LIMIT).max(1);
    let compared: Vec<usize> = (0..queries.len()).step_by(step).collect();
    let ratios = compared.par_iter().map(|index| comparison.compare(*index, &queries[*index], &neighbors[*index]));
    let ratios: Vec<Option<f32>> = ratios.collect::<Result<_, WrongAnswer>>()?;
    let inexact = || ratios.iter().flatten();
    Ok(Checked {
        queries: ratios.len(),
        exact: ratios.len() - inexact().count(),
        worst_ratio: inexact().copied().fold(1.0, f32::max),
    })
}

struct Comparison<'a> {
    format: Format,
    encoded: &'a [Point],
    brute_force: BruteForce<'a>,
    epsilon: f32,
}

impl Comparison<'_> {
    /// `None` for an exact answer, else how much too far its farthest neighbor is.
    fn compare(&self, query: usize, asked: &Query, found: &[Neighbor]) -> Result<Option<f32>, WrongAnswer> {
        let format = self.format;
        let at = asked.point.map(|number| encode(format, number));
        let radius2 = asked.radius.map_or(format.infinity() as u32, |radius| encode(format, radius * radius));
        let nearest = self.brute_force.nearest(at, asked.k as usize, radius2);
        let expected: Vec<f32> = nearest.iter().map(|neighbor| decode(format, neighbor.distance2)).collect();
        let distances: Vec<f32> = found.iter().map(|neighbor| neighbor.distance2).collect();
        let lies_there = |neighbor: &Neighbor| {
            squared_distance(format, self.encoded[neighbor.point as usize], at) == encode(format, neighbor.distance2)
        };
        let sound = found.iter().all(lies_there) && all_differ(found) && distances.is_sorted();
        if sound && distances == expected {
            return Ok(None);
        }
        let farthest = |distances: &[f32]| distances.last().map_or(0.0, |distance2| distance2.sqrt());
        let ratio = farthest(&distances) / farthest(&expected);
        let allowed = match asked.kind() {
            QueryKind::Nearest => distances.len() == expected.len() && ratio <= 1.0 + self.epsilon,
            QueryKind::Ball => distances.len() < expected.len(),
        };
        if sound && self.epsilon > 0.0 && allowed {
            Ok(Some(ratio))
        } else {
            Err(WrongAnswer { query, found: distances, expected })
        }
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
    use crate::scene::model::tests::shared;
    use crate::search::{MemorySettings, Order, PointSource, SearchEngine, Session, Splitting, Tree, config_for};
    use glam::DVec3;

    #[test]
    fn only_right_answers_pass() {
        let points =
            PointSet::new(Format::F32, &[[0.0; 3], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]]).expect("points are finite");
        let query = Query { point: [0.0; 3], k: 2, radius: None };
        let check = |found: &[(u32, f32)]| {
            let found = found.iter().map(|(point, distance2)| Neighbor { point: *point, distance2: *distance2 });
            check(&points, &[query], &[found.collect()], 0.0).is_ok()
        };
        assert!(check(&[(0, 0.0), (1, 1.0)]) && check(&[(0, 0.0), (2, 1.0)]), "of two at equal distance any will do");
        assert!(!check(&[(0, 0.0)]), "one is missing");
        assert!(!check(&[(1, 0.0), (2, 1.0)]), "a point lies elsewhere");
        assert!(!check(&[(1, 1.0), (2, 1.0)]), "the nearest is missing");
        let doubled = PointSet::new(Format::F32, &[[1.0; 3], [1.0; 3]]).expect("points are finite");
        let twice = vec![Neighbor { point: 0, distance2: 3.0 }; 2];
        let difference = super::check(&doubled, &[query], &[twice], 0.0).expect_err("a neighbor is found twice");
        assert!(difference.to_string().starts_with("query 0"));
    }

    #[test]
    fn approximate_answers_are_measured() {
        let line: Vec<_> = (0..4_u8).map(|x| [f32::from(x), 0.0, 0.0]).collect();
        let points = PointSet::new(Format::F32, &line).expect("points are finite");
        let check = |query, found: &[u32], epsilon| {
            let found = found.iter().map(|x| Neighbor { point: *x, distance2: (*x as f32).powi(2) }).collect();
            super::check(&points, &[query], &[found], epsilon)
        };
        let query = Query { point: [0.0; 3], k: 3, radius: None };
        let inexact = |worst_ratio| Ok(Checked { queries: 1, exact: 0, worst_ratio });
        assert_eq!(check(query, &[0, 1, 3], 0.5), inexact(1.5));
        assert!(check(query, &[0, 1, 3], 0.49).is_err() && check(query, &[0, 1], 0.5).is_err());
        let ball = Query { radius: Some(2.5), ..query };
        assert_eq!(check(ball, &[0, 1], 0.1), inexact(1.0), "a ball may lack neighbors");
        assert!(check(ball, &[0, 1], 0.0).is_err() && check(ball, &[0, 1, 3], 0.1).is_err());
    }

    #[test]
    fn neighbors_in_a_scan_are_the_nearest() {
        let Some((path, model)) = shared("igea.ply") else { return };
        for (splitting, order) in
            [(Splitting::Packed, Order::Random), (Splitting::Midpoint, Order::Grid { columns: 3, rows: 3 })]
        {
            let config = config_for(model.points.len(), 10, splitting);
            let points = PointSet::load(config.geometry, &PointSource::File(path.clone())).expect("the scan is good");
            let tree = Tree::build(&config, &points, splitting).expect("the points fit");
            let session = Session::open(config, tree, MemorySettings::default(), SearchEngine::Golden)
                .expect("the core is valid");
            let query = |place: &DVec3| Query { point: points.rounded(*place), k: 10, radius: None };
            let queries: Vec<_> = order.places(&points, Some(200), 1).iter().map(query).collect();
            let outcome = session.search(&queries).unwrap_or_else(|error| panic!("{error}"));
            let checked = super::check(&points, &queries, &outcome.neighbors, 0.0);
            assert_eq!(checked, Ok(Checked { queries: 200, exact: 200, worst_ratio: 1.0 }));
        }
    }
}
