//! Figures of programs on neighborhoods: every operation on the point processor, what it adds to a search, the processor of this
//! machine beside it.

mod cpu;
mod fluid;
mod lidar;
mod reuse;

use crate::bench::page::FigurePage;
use crate::note;
use crate::{Figures, LabError};
use glam::DVec3;
use pointcore::area::recorded::Clock;
use pointcore::configuration::{Configuration, points};
use pointcore::process::{
    Cloud, Cost, Operation, Process, Processed, Queries, Simulation, Stage, Timed, Timing, check, process,
};
use pointcore::scene::{InvalidPoints, NormalSource};
use pointcore::search::{
    MemorySettings, Order, PointSource, Query, SearchEngine, Session, Splitting, Tree, config_for,
};
use pointcore_contract::Format;
use std::collections::BTreeMap;
use std::path::Path;

const FORMAT: Format = Format::F32.flushed();
/// Neighbors of a query.
const NEIGHBORS: u32 = 16;
/// Queries that are asked of an operation, and of its hardware in lockstep.
const SAMPLE: usize = 20_000;
const LOCKSTEP_SAMPLE: usize = 500;
/// Iterations of a query at most.
const ITERATIONS: u32 = 16;
/// Neighbors at which programs are held against the search alone.
const COUNTS: [u32; 3] = [10, 16, 32];
/// Passes of the smoothing.
const PASSES: usize = 8;
/// Rates at which the kernel is the bound.
const RATES: [u32; 2] = [4, 8];
/// Seed of shuffles.
const SEED: u64 = 1;

/// What is asked of an operation on points.
#[derive(Clone, Copy)]
struct Asked<'a> {
    operation: &'a Operation,
    k: u32,
    radius: Option<f64>,
    iterations: u32,
}

impl Asked<'_> {
    fn run(&self, cloud: &Cloud, queries: &Queries, simulation: Simulation) -> Result<Processed, LabError> {
        let (settings, attributes) = (BTreeMap::new(), BTreeMap::new());
        let Self { operation, k, radius, iterations } = *self;
        let asked =
            Process { operation, k, radius, iterations, passes: 1, settings: &settings, attributes: &attributes };
        Ok(process(cloud, queries, &asked, &Timed::new(simulation), &|_| ())?)
    }
}

/// The points in the order of a curve, so that queries come near each other.
fn coherent(cloud: &Cloud, limit: usize) -> Vec<usize> {
    Order::Morton.indices(cloud.points(), Some(limit), SEED)
}

fn queries(cloud: &Cloud, operation: &Operation, limit: usize) -> Queries {
    if operation.stages().len() > 1 {
        return Queries::Points((0..cloud.len()).collect());
    }
    let sides = [2, 2];
    let has_pattern = operation.has_pattern();
    let points = coherent(cloud, if has_pattern { limit / 4 } else { limit });
    if has_pattern { Queries::Pattern { points, sides } } else { Queries::Points(points) }
}

/// Times of the programs that an operation consists of, without the estimate of normals before them.
fn own_timings(processed: &Processed) -> Vec<&Timing> {
    let names: Vec<&str> = processed.stages.iter().map(|stage| stage.program.name()).collect();
    let mut own: Vec<&Timing> = processed.summary.timings.iter().rev().take(names.len()).collect();
    own.reverse();
    assert!(own.iter().zip(&names).all(|(timing, name)| timing.program == *name), "{own:?}");
    own
}

/// How many times faster than the processor of this machine the hardware is, at its clock.
fn speedup(clock: &Clock, stages: &[Stage], timings: &[&Timing], iterations: u32) -> f64 {
    let seconds: f64 = stages.iter().map(|stage| cpu::seconds(stage, iterations)).sum();
    let cycles: u64 = timings.iter().map(|timing| timing.cycles).sum();
    seconds / (cycles as f64 / (clock.mhz * 1e6))
}

/// Every operation: cycles, operators, hardware in lockstep, f64 and the processor beside it.
fn operation_figures(cloud: &Cloud, clock: &Clock, figures: &mut Figures) -> Result<(), LabError> {
    for name in Operation::names() {
        note!("{}: {name}", cloud.name());
        let operation = Operation::named(name)?;
        let asked = Asked { operation: &operation, k: NEIGHBORS, radius: None, iterations: ITERATIONS };
        // Particles fill a volume; all of them are asked.
        let cloud = if operation.stages().len() > 1 { fluid::particles()? } else { cloud.clone() };
        let golden = Simulation::of(SearchEngine::Golden);
        let processed = asked.run(&cloud, &queries(&cloud, &operation, SAMPLE), golden.clone())?;
        let timings = own_timings(&processed);
        let mut insert = |key: &str, value: serde_json::Value| figures.insert(format!("process.{name}.{key}"), value);
        let sum = |of: fn(&Timing) -> u64| timings.iter().map(|timing| of(timing)).sum::<u64>() as f64;
        let (cycles, answers) = (sum(|timing| timing.cycles), processed.answers().len() as f64);
        insert("cycles_per_query", (cycles / answers).into());
        insert("iterations_per_query", (processed.summary.iterations as f64 / answers).into());
        insert("kernel_busy", (sum(|timing| timing.neighbors * u64::from(timing.rate)) / cycles).into());
        let costs =
            operation.stages().iter().map(|program| Cost::of(program, FORMAT, 1)).collect::<Result<Vec<_>, _>>()?;
        for (key, of) in [
            ("adds", (|cost| cost.operators.add) as fn(&Cost) -> u32),
            ("muls", |cost| cost.operators.mul),
            ("divs", |cost| cost.operators.div),
            ("sqrts", |cost| cost.operators.sqrt),
        ] {
            insert(key, costs.iter().map(of).sum::<u32>().into());
        }
        let compared = check::compare(&processed.stages);
        if let Some(first) = compared.as_ref().ok().and_then(|compared| compared.first()) {
            insert("max_error", first.error.into());
            insert("max_error_share_of_bound", first.share.into());
            let violations: usize = compared.iter().flatten().map(|comparison| comparison.violations).sum();
            insert("bound_violations", violations.into());
        }
        insert("speedup_cpu", speedup(clock, &processed.stages, &timings, ITERATIONS).into());
        insert("mismatches", mismatches(&cloud, &asked, golden)?.into());
    }
    Ok(())
}

/// Outputs of the hardware that are not its model's, of a few queries in lockstep: the first one ends the run.
fn mismatches(cloud: &Cloud, asked: &Asked<'_>, simulation: Simulation) -> Result<u32, LabError> {
    let queries = queries(cloud, asked.operation, LOCKSTEP_SAMPLE);
    match asked.run(cloud, &queries, Simulation { engine: SearchEngine::Lockstep, ..simulation }) {
        Ok(_) => Ok(0),
        Err(LabError::Process(pointcore::process::ProcessError::Points(pointcore::search::SearchError::Lockstep(
            difference,
        )))) => {
            note!("{difference}");
            Ok(1)
        }
        Err(other) => Err(other),
    }
}

/// Cycles of a search alone, on the same hardware.
fn search_cycles(cloud: &Cloud, k: u32, order: Order) -> Result<f64, LabError> {
    let config = config_for(cloud.len(), k, Splitting::Packed);
    let places = order.places(cloud.points(), Some(SAMPLE), SEED);
    let query = |place: DVec3| Query { point: cloud.points().rounded(place), k, radius: None };
    let queries: Vec<Query> = places.into_iter().map(query).collect();
    let tree = Tree::build(&config, cloud.points(), Splitting::Packed)?;
    let session = Session::open(config, tree, MemorySettings::default(), SearchEngine::Golden)?;
    Ok(session.search(&queries)?.counters.cycles as f64)
}

/// What moving least squares adds to a search (thesis figure 6.12), and the kernel where it is the bound.
fn overhead_figures(cloud: &Cloud, figures: &mut Figures) -> Result<(), LabError> {
    let operation = Operation::named("mls")?;
    for k in COUNTS {
        for (order, key) in [(Order::Morton, String::new()), (Order::Random, "random.".to_owned())] {
            note!("{}: mls beside the search alone, k = {k}, {order} order", cloud.name());
            let queries = Queries::Points(order.indices(cloud.points(), Some(SAMPLE), SEED));
            let asked = Asked { operation: &operation, k, radius: None, iterations: 1 };
            let processed = asked.run(cloud, &queries, Simulation::of(SearchEngine::Golden))?;
            let cycles: u64 = own_timings(&processed).iter().map(|timing| timing.cycles).sum();
            let share = cycles as f64 / search_cycles(cloud, k, order)? - 1.0;
            figures.insert(format!("process.search_overhead.{key}k{k}"), share.into());
        }
    }
    for rate in RATES {
        let asked = Asked { operation: &operation, k: NEIGHBORS, radius: None, iterations: 1 };
        let simulation = Simulation { rate, ..Simulation::of(SearchEngine::Golden) };
        let processed = asked.run(cloud, &Queries::Points(coherent(cloud, SAMPLE)), simulation)?;
        let busy = own_timings(&processed)[0].kernel_busy();
        figures.insert(format!("process.mls.rate{rate}.kernel_busy"), busy.into());
    }
    Ok(())
}

/// Smoothing, pass after pass, each from where the last one left the points.
fn smoothing_figures(cloud: &Cloud, clock: &Clock, figures: &mut Figures) -> Result<(), LabError> {
    let operation = Operation::named("smooth")?;
    let asked = Asked { operation: &operation, k: NEIGHBORS, radius: None, iterations: 1 };
    let (mut cloud, mut cycles, mut seconds) = (cloud.clone(), 0, 0.0);
    let all = Queries::Points(coherent(&cloud, usize::MAX));
    for pass in 0..PASSES {
        note!("{}: smoothing, pass {}", cloud.name(), pass + 1);
        let processed = asked.run(&cloud, &all, Simulation::of(SearchEngine::Golden))?;
        cycles += own_timings(&processed).iter().map(|timing| timing.cycles).sum::<u64>();
        seconds += cpu::seconds(&processed.stages[0], 1);
        // What left is in the order of the queries.
        let mut places = cloud.points().given().to_vec();
        let Queries::Points(order) = &all else { unreachable!("all points are asked") };
        order.iter().zip(&processed.places).for_each(|(&index, place)| places[index] = *place);
        cloud = cloud.moved(places)?;
    }
    let hardware = cycles as f64 / (clock.mhz * 1e6);
    let mut insert = |key: &str, value: f64| figures.insert(format!("process.smoothing.{key}"), value.into());
    insert("passes", PASSES as f64);
    insert("cycles", cycles as f64);
    insert("seconds", hardware);
    insert("cpu_seconds", seconds);
    insert("speedup_cpu", seconds / hardware);
    Ok(())
}

/// Measures programs on the points of a scan, or of a procedural surface; charts and tables go to `folder`.
///
/// # Errors
/// The points cannot be loaded, a run fails, or the folder cannot be written.
pub fn figures(scan: Option<&Path>, folder: &Path, figures: &mut Figures) -> Result<(), LabError> {
    let source = scan.map_or(PointSource::Surface(100_000), |path| PointSource::File(path.to_owned()));
    let cloud = Cloud::load(FORMAT, &source, InvalidPoints::Refuse, NormalSource::Auto)?;
    let clock = Clock::of(&Configuration::Points(points()), None);
    figures.insert("process.clock_mhz".to_owned(), clock.mhz.into());
    let mut page = FigurePage::new(folder, "Programs on neighborhoods", &source.to_string());
    overhead_figures(&cloud, figures)?;
    reuse::figures(&cloud, figures, &mut page)?;
    operation_figures(&cloud, &clock, figures)?;
    lidar::figures(&clock, figures)?;
    fluid::figures(&clock, figures)?;
    smoothing_figures(&cloud, &clock, figures)?;
    page.save()
}
