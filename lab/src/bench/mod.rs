//! The project's figures: frames, searches, programs on neighborhoods, operators, and what leaving out saves that a scene does not call for.

pub mod configurations;
pub mod effects;
pub mod front;
pub mod knn;
pub mod operators;
mod page;
pub mod process;
pub mod splat;

use crate::LabError;
use pointcore::plan::Plan;
use pointcore::scene::Scene;
use std::path::Path;

/// A scene and its hardware.
fn load(path: &Path, settings: &[String]) -> Result<(Scene, Plan), LabError> {
    let scene = Scene::load(path, settings)?;
    let plan = Plan::of(&scene)?;
    Ok((scene, plan))
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
