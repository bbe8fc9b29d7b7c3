//! Point sets of all kinds against brute force, hardware in lockstep with its model.

use super::{Cloud, FOUR_LANES, NEIGHBORS, SEED, Setting, search};
use crate::note;
use crate::{Figures, LabError};
use pointcore::search::samples::{point_sets, queries_near};
use pointcore::search::{PointSet, PointSource, SearchEngine, check};
use std::path::PathBuf;

/// Points of a procedural set.
const POINTS: usize = 20_000;
/// Queries in a set: neighbors within a radius and without.
const QUERIES: usize = 1000;

/// Compares every distance; `files` are searched besides the procedural sets. The hardware is that of `scan`.
pub fn figures(scan: &Cloud, files: &[PathBuf], figures: &mut Figures) -> Result<(), LabError> {
    let config = FOUR_LANES.config(scan.points.points().len().max(POINTS), NEIGHBORS);
    let mut random = fastrand::Rng::with_seed(SEED);
    let mut clouds = vec![(scan.name.clone(), scan.points.clone())];
    for path in files {
        clouds.push((path.display().to_string(), PointSet::load(config.geometry, &PointSource::File(path.clone()))?));
    }
    for (name, points) in point_sets(POINTS, &mut random) {
        clouds.push((name.to_owned(), PointSet::new(config.geometry, &points)?));
    }
    let (mut cases, mut mismatches) = (0, 0);
    for (name, points) in clouds {
        note!("brute force: {name}");
        let queries = queries_near(points.points(), NEIGHBORS, QUERIES, &mut random);
        let cloud = Cloud { source: PointSource::File(name.clone().into()), name, points };
        let run = search(&cloud, Setting::new(&config, FOUR_LANES.splitting, SearchEngine::Lockstep), &queries)?;
        cases += queries.len();
        if let Err(difference) = check(&cloud.points, &queries, &run.outcome.neighbors, 0.0) {
            note!("{}: {difference}", cloud.name);
            mismatches += 1;
        }
    }
    figures.insert("knn.brute.cases".to_owned(), cases.into());
    figures.insert("knn.brute.mismatches".to_owned(), mismatches.into());
    Ok(())
}
