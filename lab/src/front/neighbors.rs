//! Whether neighbors are right: by what the command says of itself, and beside all distances among the points that the file was made of.

use super::program::Program;
use super::shapes::Shape;
use serde_json::Value;

/// Neighbors of each point.
const NEIGHBORS: usize = 5;
/// Points whose neighbors are searched.
const QUERIES: usize = 60;
/// The share of a distance, and of the coordinates' span, by which rounding to single precision may change an order of distances.
const ROUNDING: f64 = 1e-5;

/// Searches a file's points; an error says what is wrong with their neighbors.
///
/// # Errors
/// They are not right. `grain` is how far the format of the file moves points.
pub fn judge(program: &Program, file: &str, shape: &Shape, grain: f64, arguments: &[&str]) -> Result<String, String> {
    let output = format!("out/{}-neighbors", file.replace('.', "-"));
    let [k, limit] = [NEIGHBORS, QUERIES].map(|number| number.to_string());
    let search =
        ["knn", "--points", file, "--model", "golden", "--order", "file", "--k", &k, "--limit", &limit, "--check"];
    let words = search.into_iter().chain(["--json", "-o", &output]).chain(arguments.iter().copied());
    let said = program.run(words)?;
    if said.code != Some(0) {
        return Err(format!("exit code {:?}: {}", said.code, said.error));
    }
    let report: Value = serde_json::from_str(&said.out).map_err(|error| format!("no report: {error}"))?;
    let queries: Vec<usize> = shape.valid().take(QUERIES).collect();
    if report["checked"]["exact"] != queries.len() || report["truth"]["others"] != 0 {
        return Err(format!(
            "{} of {} queries, beside the truth {}",
            report["checked"],
            queries.len(),
            report["truth"]
        ));
    }
    let path = program.file(format!("{output}/neighbors.json"));
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let found: Vec<Vec<Value>> = serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))?;
    if found.len() != queries.len() {
        return Err(format!("{} answers to {} queries", found.len(), queries.len()));
    }
    queries.iter().zip(&found).try_for_each(|(query, answer)| beside_all(shape, *query, answer, grain))?;
    Ok(format!("{} neighbors", report["neighbors"]))
}

/// Compares the distances of a query's neighbors, nearest first, with the least ones among all points.
fn beside_all(shape: &Shape, query: usize, answer: &[Value], grain: f64) -> Result<(), String> {
    let distance = |other: usize| shape.points.get(other).map(|point| point.distance(shape.points[query]));
    let mut all: Vec<f64> = shape.valid().filter_map(distance).collect();
    all.sort_by(f64::total_cmp);
    let [low, high] = shape.bounds();
    let wanted = &all[..NEIGHBORS.min(all.len())];
    let found: Option<Vec<f64>> =
        answer.iter().map(|neighbor| distance(neighbor["point"].as_u64()? as usize)).collect();
    let found = found.ok_or_else(|| format!("a neighbor of point {query} is none of the points"))?;
    let slack = |wanted: f64| 4.0 * grain + ROUNDING * wanted + ROUNDING * (high - low).length();
    let is_right = found.len() == wanted.len()
        && found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() <= slack(*wanted));
    if is_right { Ok(()) } else { Err(format!("neighbors of point {query} lie {found:?} away, expected {wanted:?}")) }
}
