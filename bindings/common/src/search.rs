//! Neighbor search: points and queries in, indices and squared distances out.

use crate::{BackEnd, BindingError};
use glam::DVec3;
use pointcore::configuration;
use pointcore::search::kdtree::depth_for;
use pointcore::search::{MemorySettings, PointSet, Query, Rounding, SearchError, Session, Splitting, Tree, config_for};
use pointcore_contract::search::Config;
use std::path::Path;

/// What stands in the place of the index of a neighbor that there is none of.
pub const NONE: i64 = -1;

/// What errors call a configuration in memory.
pub(crate) const CONFIGURATION: &str = "configuration";

/// How a search is set up.
#[derive(Clone, Copy, Debug)]
pub struct SearchSettings<'a> {
    /// The most neighbors that a query may ask for.
    pub k: u32,
    /// The hardware's configuration as TOML; without one it follows from the points.
    pub configuration: Option<&'a str>,
    /// What answers.
    pub back_end: BackEnd,
}

/// Points in a tree, and a core that searches it.
pub struct Search {
    points: PointSet,
    config: Config,
    session: Session,
}

/// Neighbors of some queries.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Neighbors of the queries, nearest first, k of each: indices of points, [`NONE`] where there are fewer.
    pub indices: Vec<i64>,
    /// Their squared distances, as the core rounds them; infinite where there is no neighbor.
    pub distances2: Vec<f32>,
    /// How many each query has.
    pub counts: Vec<u32>,
    /// Cycles from the first query to the last neighbor.
    pub cycles: u64,
}

/// The hardware that points call for.
pub(crate) fn derived(points: usize, k: u32) -> Config {
    config_for(points, k, Splitting::Packed)
}

impl Search {
    /// Sorts points into a tree, generates the core, and builds it if it is to run.
    ///
    /// # Errors
    /// There is no point, or one that is nowhere; the configuration does not hold them; rounding to its format would
    /// make other neighbors; tools are missing or fail.
    pub fn open(points: Vec<[f64; 3]>, settings: SearchSettings) -> Result<Self, BindingError> {
        let config = match settings.configuration {
            Some(text) => configuration::parse_search(Path::new(CONFIGURATION), text)?,
            None => derived(points.len(), settings.k),
        };
        check_k(settings.k, &config)?;
        let points = points.into_iter().map(DVec3::from_array).collect();
        let points = PointSet::recentered(config.geometry, points)?;
        Rounding::of(&points, settings.k).check()?;
        let tree = Tree::build(&config, &points, Splitting::Packed)?;
        let session = Session::open(config.clone(), tree, MemorySettings::default(), settings.back_end.search()?)?;
        Ok(Self { points, config, session })
    }

    /// The nearest `k` neighbors of each query, or those of them within a radius.
    ///
    /// # Errors
    /// A query has no meaning; hardware and model differ.
    pub fn search(&self, queries: &[[f64; 3]], k: u32, radius: Option<f64>) -> Result<Found, BindingError> {
        check_k(k, &self.config)?;
        let radius = radius.map(|radius| radius as f32);
        let query = |place: &[f64; 3]| Query { point: self.points.rounded(DVec3::from_array(*place)), k, radius };
        let queries: Vec<Query> = queries.iter().map(query).collect();
        let width = k as usize;
        let mut found = Found {
            indices: vec![NONE; width * queries.len()],
            distances2: vec![f32::INFINITY; width * queries.len()],
            counts: Vec::with_capacity(queries.len()),
            cycles: 0,
        };
        // Without a query nothing is left to be simulated.
        if queries.is_empty() {
            return Ok(found);
        }
        let outcome = self.session.search(&queries)?;
        for (query, neighbors) in outcome.neighbors.iter().enumerate() {
            for (place, neighbor) in (query * width..).zip(neighbors) {
                found.indices[place] = neighbor.point.into();
                found.distances2[place] = neighbor.distance2;
            }
            found.counts.push(neighbors.len() as u32);
        }
        found.cycles = outcome.counters.cycles;
        Ok(found)
    }
}

pub(crate) fn check_k(k: u32, config: &Config) -> Result<(), BindingError> {
    Ok(Query { point: [0.0; 3], k, radius: None }.check(config, 0)?)
}

/// Whether a tree holds so many points.
pub(crate) fn check_points(points: usize, config: &Config) -> Result<(), BindingError> {
    let Config { tree_depth: depth, bucket, .. } = *config;
    let capacity = (bucket as usize) << depth;
    match points {
        0 => Err(SearchError::NoPoint.into()),
        _ if points > capacity => {
            let needed = depth_for(points, bucket);
            Err(SearchError::Capacity { points, depth, bucket, capacity, needed }.into())
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ErrorKind;

    fn grid() -> Vec<[f64; 3]> {
        (0..125_u8).map(|i| [i % 5, i / 5 % 5, i / 25].map(f64::from)).collect()
    }

    const GOLDEN: SearchSettings = SearchSettings { k: 8, configuration: None, back_end: BackEnd::Golden };

    #[test]
    fn neighbors_come_nearest_first_and_what_is_missing_is_marked() {
        let search = Search::open(grid(), GOLDEN).expect("the points are sound");
        let found =
            search.search(&[[0.1, 0.0, 0.0], [2.0; 3], [50.0; 3]], 3, Some(1.2)).expect("the queries are sound");
        assert_eq!(found.indices[..2], [0, 1]);
        assert_eq!(found.counts, [3, 3, 0]);
        assert_eq!(found.indices[3], 2 + 2 * 5 + 2 * 25);
        assert_eq!(found.indices[6..], [NONE; 3]);
        assert_eq!((found.distances2[3], &found.distances2[6..]), (0.0, &[f32::INFINITY; 3][..]));
        assert!(found.cycles > 0);
    }

    #[test]
    fn far_coordinates_keep_their_neighbors() {
        let map = [412_345.67, 5_654_321.09, 120.0];
        let place = |i: u32| [map[0] + 0.1 * f64::from(i), map[1], map[2]];
        let search = Search::open((0..200).map(place).collect(), GOLDEN).expect("the points are sound");
        let found = search.search(&[place(77)], 1, None).expect("the query is sound");
        assert_eq!((found.indices, found.distances2), (vec![77], vec![0.0]));
    }

    #[test]
    fn no_query_is_no_run() {
        let found =
            Search::open(grid(), GOLDEN).and_then(|search| search.search(&[], 2, None)).expect("nothing is asked");
        assert_eq!(found, Found { indices: vec![], distances2: vec![], counts: vec![], cycles: 0 });
    }

    #[test]
    fn faults_of_the_input_are_named() {
        let message = |result: Result<Found, BindingError>| {
            let error = result.expect_err("something is wrong");
            assert_eq!(error.kind, ErrorKind::Input);
            error.message
        };
        let at = |k, radius| Search::open(grid(), GOLDEN).and_then(|search| search.search(&[[0.0; 3]], k, radius));
        assert!(message(at(0, None)).contains("k is 0"));
        assert!(message(at(99, None)).contains("k is 99"));
        assert!(message(at(1, Some(-1.0))).contains("radius is -1"));
        let nothing = Search::open(grid(), GOLDEN).and_then(|search| search.search(&[[0.0, f64::NAN, 0.0]], 1, None));
        assert!(message(nothing).contains("query 0"));
        let configured = |configuration| {
            let settings = SearchSettings { configuration: Some(configuration), ..GOLDEN };
            Search::open(grid(), settings).and_then(|search| search.search(&[], 1, None))
        };
        assert!(message(configured("kind = \"splat\"")).contains("is for the renderer"));
        let small = "kind = \"search\"\nfeatures.tree_depth = 2\nfeatures.bucket = 4";
        assert!(message(configured(small)).contains("raise `tree_depth`"));
        assert!(message(Search::open(vec![], GOLDEN).and_then(|search| search.search(&[], 1, None))).contains("empty"));
    }
}
