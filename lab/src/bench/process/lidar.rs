//! Normals of a frame as a spinning scanner on a car's roof has it.

use super::{Asked, FORMAT, ITERATIONS, own_timings, speedup};
use crate::note;
use crate::{Figures, LabError};
use fastrand::Rng;
use glam::DVec3;
use pointcore::area::recorded::Clock;
use pointcore::process::{Cloud, Operation, Queries, Simulation};
use pointcore::search::{SearchEngine, Splitting, Tree, config_for};
use std::collections::BTreeMap;
use std::time::Instant;

/// Beams, and measurements of each in a turn.
const BEAMS: usize = 64;
const TURN: usize = 1_600;
/// Lowest and highest beam, in degrees above the horizon.
const ELEVATIONS: [f64; 2] = [-24.0, 10.0];
/// Height of the scanner above the street, and the farthest it sees, in meters.
const HEIGHT: f64 = 1.8;
const RANGE: f64 = 80.0;
/// Noise of a distance, in meters.
const NOISE: f64 = 0.02;
/// Neighbors of a point.
const NEIGHBORS: u32 = 10;
const TREES: usize = 5;

/// A street between houses with cars along it: the nearest hit of a ray from the scanner.
fn distance(direction: DVec3) -> Option<f64> {
    let street = (direction.z < 0.0).then(|| -HEIGHT / direction.z);
    let wall = |side: f64| (direction.y * side > 0.0).then(|| 9.0 / direction.y.abs());
    let car = |place: usize| {
        let middle = DVec3::new(place as f64 * 7.0 - 38.0, if place.is_multiple_of(2) { 4.5 } else { -4.5 }, -1.05);
        let half = DVec3::new(2.2, 0.9, 0.75);
        let (a, b) = ((middle - half) / direction, (middle + half) / direction);
        let (near, far) = (a.min(b).max_element(), a.max(b).min_element());
        (near < far && near > 0.0).then_some(near)
    };
    let hits = [street, wall(1.0), wall(-1.0)].into_iter().chain((0..12).map(car));
    hits.flatten().filter(|distance| *distance < RANGE).min_by(f64::total_cmp)
}

/// The points of a turn, beam after beam as the scanner turns.
fn frame() -> Vec<DVec3> {
    let mut random = Rng::with_seed(1);
    let mut points = vec![];
    for turn in 0..TURN {
        let azimuth = std::f64::consts::TAU * turn as f64 / TURN as f64;
        for beam in 0..BEAMS {
            let share = beam as f64 / (BEAMS - 1) as f64;
            let elevation = (ELEVATIONS[0] + share * (ELEVATIONS[1] - ELEVATIONS[0])).to_radians();
            let (sine, cosine) = elevation.sin_cos();
            let direction = DVec3::new(cosine * azimuth.cos(), cosine * azimuth.sin(), sine);
            let noise = NOISE * (random.f64() + random.f64() - 1.0);
            points.extend(distance(direction).map(|distance| direction * (distance + noise)));
        }
    }
    points
}

/// Frames a second: the tree is built by this machine, then all points are asked.
pub(super) fn figures(clock: &Clock, figures: &mut Figures) -> Result<(), LabError> {
    let points = frame();
    note!("normals of a frame of {} points", points.len());
    let cloud = Cloud::of(FORMAT, "the frame".to_owned(), points, BTreeMap::new())?;
    let config = config_for(cloud.len(), NEIGHBORS, Splitting::Packed);
    let build = |_| {
        let started = Instant::now();
        Tree::build(&config, cloud.points(), Splitting::Packed).map(|_| started.elapsed().as_secs_f64())
    };
    let tree_seconds = crate::bench::median((0..TREES).map(build).collect::<Result<_, _>>()?);
    let operation = Operation::named("normals")?;
    let asked = Asked { operation: &operation, k: NEIGHBORS, radius: None, iterations: ITERATIONS };
    // In the order of the scanner: neighbors in a turn are neighbors in space.
    let all = Queries::Points((0..cloud.len()).collect());
    let processed = asked.run(&cloud, &all, Simulation::of(SearchEngine::Golden))?;
    let timings = own_timings(&processed);
    let seconds = timings[0].cycles as f64 / (clock.mhz * 1e6);
    let mut insert = |key: &str, value: f64| figures.insert(format!("process.lidar.{key}"), value.into());
    insert("points", cloud.len() as f64);
    insert("k", NEIGHBORS.into());
    insert("cycles_per_query", timings[0].cycles_per_query());
    insert("tree_ms", tree_seconds * 1e3);
    insert("hardware_ms", seconds * 1e3);
    insert("frames_per_s", 1.0 / (tree_seconds + seconds));
    insert("frames_per_s_pipelined", 1.0 / tree_seconds.max(seconds));
    insert("speedup_cpu", speedup(clock, &processed.stages, &timings, 1));
    Ok(())
}
