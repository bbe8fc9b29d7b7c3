//! The point processor beside the interpreter, on clouds in which no two neighbors are equally far.

use crate::process::{Cloud, Interpreted, Operation, Process, Processed, Queries, Simulation, Timed, process};
use crate::search::{MemorySettings, Reuse, SearchEngine};
use fastrand::Rng;
use glam::DVec3;
use pointcore_contract::Format;
use pointcore_tb::lockstep::Stall;
use std::collections::BTreeMap;

/// Points near a sphere.
fn cloud(count: usize) -> Cloud {
    let mut random = Rng::with_seed(3);
    let mut coordinate = || 2.0 * random.f64() - 1.0;
    let mut point = || DVec3::new(coordinate(), coordinate(), coordinate()).normalize() * (1.0 + 0.01 * coordinate());
    let points = (0..count).map(|_| point()).collect();
    Cloud::of(Format::F32.flushed(), "test".to_owned(), points, BTreeMap::new())
        .unwrap_or_else(|error| panic!("{error}"))
}

fn run(name: &str, cloud: &Cloud, radius: Option<f64>, simulation: Option<Simulation>) -> Processed {
    let operation = Operation::named(name).unwrap_or_else(|error| panic!("{error}"));
    let (settings, attributes) = (BTreeMap::new(), BTreeMap::new());
    let passes = if operation.moves() && !operation.has_pattern() { 2 } else { 1 };
    let asked = Process {
        operation: &operation,
        k: 12,
        radius,
        iterations: 4,
        passes,
        settings: &settings,
        attributes: &attributes,
    };
    let points: Vec<usize> = (0..cloud.len()).collect();
    let queries =
        if operation.has_pattern() { Queries::Pattern { points, sides: [2, 1] } } else { Queries::Points(points) };
    let done = match simulation {
        None => process(cloud, &queries, &asked, &Interpreted, &|_| ()),
        Some(simulation) => process(cloud, &queries, &asked, &Timed::new(simulation), &|_| ()),
    };
    done.unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Outputs, iterations and caps are the interpreter's, bit for bit.
fn agree(timed: &Processed, interpreted: &Processed, name: &str) {
    for (timed, interpreted) in timed.stages.iter().zip(&interpreted.stages) {
        let answers = timed.answers.iter().zip(&interpreted.answers).enumerate();
        for (query, (ours, theirs)) in answers {
            let same = (&ours.outputs, ours.iterations, ours.capped);
            assert_eq!(same, (&theirs.outputs, theirs.iterations, theirs.capped), "{name}, query {query}");
        }
    }
}

#[test]
fn every_operation_leaves_what_the_interpreter_says() {
    let cloud = cloud(700);
    for (number, name) in Operation::names().into_iter().enumerate() {
        let radius = number.is_multiple_of(2).then_some(0.2);
        let memory = MemorySettings { reorder_window: 1 + 7 * (number % 2), ..MemorySettings::default() };
        let simulation = Simulation { memory, rate: 1 + number as u32 % 2, ..Simulation::of(SearchEngine::Golden) };
        let timed = run(name, &cloud, radius, Some(simulation));
        agree(&timed, &run(name, &cloud, radius, None), name);
        let timings = &timed.summary.timings;
        assert!(timings.len() >= timed.stages.len(), "{name}: {timings:?}");
        for timing in timings {
            assert!(timing.cycles > timing.neighbors && timing.neighbors > 700, "{name}: {timing:?}");
            assert!(timing.kernel_busy() > 0.1 && timing.line_hits > 0, "{name}: {timing:?}");
        }
    }
}

#[test]
fn hardware_is_compared_in_every_cycle() {
    let cloud = cloud(300);
    let simulation = Simulation { stall: Stall::Random(0.2), seed: 5, ..Simulation::of(SearchEngine::Lockstep) };
    let timed = run("mls", &cloud, None, Some(simulation));
    agree(&timed, &run("mls", &cloud, None, None), "mls");
}

/// Queries that ask for the place of a point before answer with its neighbors, in another order: sums round otherwise.
#[test]
fn a_neighbor_cache_spares_searches_and_leaves_almost_the_same() {
    let points = cloud(40).points().given().to_vec();
    let thrice = points.iter().flat_map(|point| (0..3).map(|turn| *point * (1.0 + 1e-5 * f64::from(turn)))).collect();
    let cloud = Cloud::of(Format::F32.flushed(), "thrice".to_owned(), thrice, BTreeMap::new())
        .unwrap_or_else(|error| panic!("{error}"));
    let reuse = Reuse { epsilon: 0.0, ..Reuse::default() };
    let simulation = Simulation { neighbor_cache: 8, reuse, ..Simulation::of(SearchEngine::Golden) };
    let (cached, plain) = (run("apss", &cloud, None, Some(simulation)), run("apss", &cloud, None, None));
    assert!(cached.summary.timings.iter().any(|timing| timing.reused > 0 && timing.searched > 0));
    assert!(cached.places.iter().zip(&plain.places).all(|(ours, theirs)| ours.distance(*theirs) < 1e-3));
}
