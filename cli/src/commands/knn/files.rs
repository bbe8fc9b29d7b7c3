//! What a search leaves besides its report.

use crate::commands::search::Questions;
use crate::commands::{Failure, Output, write};
use pointcore::search::{Neighbor, PointSet, SearchOutcome};
use std::fmt::Write as _;
use std::path::Path;

/// A number in no more digits than it has: most files hold single precision.
fn shortest(number: f64) -> String {
    let single = number as f32;
    if f64::from(single) == number { format!("{single:e}") } else { format!("{number:e}") }
}

/// Writes the queries, and the neighbors of each.
pub fn write_neighbors(
    questions: &Questions,
    points: &PointSet,
    outcome: &SearchOutcome,
    output: Output,
    folder: &Path,
) -> Result<(), Failure> {
    let mut places = "query,x,y,z\n".to_owned();
    for (query, place) in questions.places.iter().enumerate() {
        let [x, y, z] = place.to_array().map(shortest);
        _ = writeln!(places, "{query},{x},{y},{z}");
    }
    write(&folder.join("queries.csv"), &places)?;
    let in_file = points.places();
    let named = |neighbor: &Neighbor| Neighbor { point: in_file[neighbor.point as usize], ..*neighbor };
    let answers: Vec<Vec<_>> = outcome.neighbors.iter().map(|found| found.iter().map(named).collect()).collect();
    if output == Output::Json {
        let text = serde_json::to_string(&answers).expect("neighbors are lists");
        return write(&folder.join("neighbors.json"), &text);
    }
    let mut text = "query,rank,point,distance2\n".to_owned();
    for (query, neighbors) in answers.iter().enumerate() {
        for (rank, neighbor) in neighbors.iter().enumerate() {
            _ = writeln!(text, "{query},{rank},{},{:e}", neighbor.point, neighbor.distance2);
        }
    }
    write(&folder.join("neighbors.csv"), &text)
}
