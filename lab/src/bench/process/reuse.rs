//! Moving least squares over neighborhoods that are reused (thesis 6.7, figures 6.15 and 6.16).

use super::{Asked, own_timings};
use crate::bench::page::{FigurePage, PageLine};
use crate::note;
use crate::{Figures, LabError};
use glam::DVec3;
use pointcore::process::{Cloud, Operation, Processed, Queries, Simulation};
use pointcore::search::{Order, Reuse, SearchEngine};

/// Neighbors of a query, and queries of a pattern's side, as in the thesis.
const NEIGHBORS: u32 = 30;
const SIDE: u32 = 8;
/// Points that are sampled up.
const PATCHES: usize = 200;
/// Neighborhoods of the cache.
const ENTRIES: u32 = 8;
const ITERATIONS: u32 = 4;
const SEED: u64 = 1;
/// Tolerances with their names in keys.
const EPSILONS: [(f32, &str); 5] = [(0.0, "e0"), (0.1, "e0_1"), (0.2, "e0_2"), (0.5, "e0_5"), (1.0, "e1")];

/// How far the places of two runs are apart, on average.
fn deviation(one: &Processed, other: &Processed) -> f64 {
    let apart = one.places.iter().zip(&other.places).map(|(one, other)| one.distance(*other));
    apart.sum::<f64>() / one.places.len() as f64
}

/// How far queries are moved, on average.
fn way(processed: &Processed, places: &[DVec3]) -> f64 {
    let moved = processed.places.iter().zip(places).map(|(place, start)| place.distance(*start));
    moved.sum::<f64>() / places.len() as f64
}

/// Projection of an up-sampled surface, with searches spared at rising tolerance.
pub(super) fn figures(cloud: &Cloud, figures: &mut Figures, page: &mut FigurePage) -> Result<(), LabError> {
    let operation = Operation::named("mls")?;
    let grid = Order::Grid { columns: SIDE, rows: SIDE };
    let places = grid.places(cloud.points(), Some(PATCHES * (SIDE * SIDE) as usize), SEED);
    let queries = Queries::Places(places.clone());
    let asked = Asked { operation: &operation, k: NEIGHBORS, radius: None, iterations: ITERATIONS };
    let run = |neighbor_cache, epsilon| {
        note!("{}: mls of {SIDE}×{SIDE}, {neighbor_cache} neighborhoods kept, ε = {epsilon}", cloud.name());
        let reuse = Reuse { epsilon, ..Reuse::default() };
        asked.run(cloud, &queries, Simulation { neighbor_cache, reuse, ..Simulation::of(SearchEngine::Golden) })
    };
    let exact = run(0, 0.0)?;
    let cycles = |processed: &Processed| own_timings(processed)[0].cycles_per_query();
    figures.insert("process.reuse.none.cycles_per_query".to_owned(), cycles(&exact).into());
    let scale = way(&exact, &places);
    let mut errors = PageLine::new("mean error of the projection");
    let (mut with, mut without) = (PageLine::new("with the cache"), PageLine::new("without"));
    for (epsilon, key) in EPSILONS {
        let processed = run(ENTRIES, epsilon)?;
        let timing = own_timings(&processed)[0];
        let error = deviation(&processed, &exact) / scale;
        let mut insert = |what: &str, value: f64| figures.insert(format!("process.reuse.{key}.{what}"), value.into());
        insert("error", error);
        insert("cycles_per_query", timing.cycles_per_query());
        insert("saved", timing.saved().unwrap_or_default());
        errors.push(100.0 * error);
        with.push(timing.cycles_per_query());
        without.push(cycles(&exact));
    }
    let categories = EPSILONS.map(|(epsilon, _)| epsilon.to_string());
    page.lines(
        "mls_error",
        "Error of moving least squares on reused neighborhoods",
        "ε",
        "% of the way to the surface",
        &categories,
        vec![errors],
    )?;
    page.paragraph(
        "Thesis figure 6.15: distances of neighbors may be off by a share of ε; the surface is far less off.",
    );
    page.lines(
        "mls_time",
        "Time of moving least squares, 8×8, k = 30",
        "ε",
        "cycles a query",
        &categories,
        vec![with, without],
    )?;
    page.paragraph("Thesis figure 6.16: 54 s without the cache, 34 s exact, 12 s at ε = 0.2, 10 s at 0.5.");
    Ok(())
}
