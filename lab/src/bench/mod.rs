//! The project's figures: frames, motion blur, searches, programs on neighborhoods, operators, and what leaving out saves that a scene does not call for.

pub mod bounds;
pub mod configurations;
pub mod effects;
pub mod front;
pub mod knn;
pub mod motion;
pub mod motion_units;
pub mod operators;
mod page;
pub mod process;
pub mod splat;
pub mod traffic;

use crate::{LabError, note};
use pointcore::plan::Plan;
use pointcore::scene::Scene;
use std::path::Path;

/// The shipped scenes, in `scenes/`.
const SCENES: [&str; 7] = ["dense", "igea", "inside", "knot", "minified", "plane", "shapes"];
/// The one that needs a scan.
const SCAN_SCENE: &str = "igea";

/// A scene and its hardware.
fn load(path: &Path, settings: &[String]) -> Result<(Scene, Plan), LabError> {
    let scene = Scene::load(path, settings)?;
    let plan = Plan::of(&scene)?;
    Ok((scene, plan))
}

/// A scene of `scenes/` and its hardware; none if it is the one that needs a scan, and there is none.
fn load_shipped(name: &str, scan: Option<&Path>) -> Result<Option<(Scene, Plan)>, LabError> {
    let path = Path::new("scenes").join(name).with_extension("toml");
    let scan = scan.filter(|_| name == SCAN_SCENE);
    let setting = scan.map(|path| format!("object.0.path={}", path.display()));
    match load(&path, setting.as_slice()) {
        Err(LabError::Scene(error)) if name == SCAN_SCENE && scan.is_none() => {
            note!("{} is left out: {error}", path.display());
            Ok(None)
        }
        loaded => loaded.map(Some),
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
