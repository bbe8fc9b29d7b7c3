//! What leaving out effects saves, on every shipped scene.

use super::load;
use crate::accuracy::estimator;
use crate::note;
use crate::{Figures, LabError};
use pointcore::cost::{Costs, Cycles};
use pointcore_tb::cache::Cache;
use std::path::Path;

/// The shipped scenes, in `scenes/`.
const SCENES: [&str; 5] = ["igea", "knot", "minified", "plane", "shapes"];
/// The one that needs a scan.
const SCAN_SCENE: &str = "igea";
/// What look-up tables are estimated from.
const RECORD: &str = "docs/area.json";

/// Shares of cycles and look-up tables that planned hardware saves of hardware with everything in, both on the golden model.
///
/// # Errors
/// A scene cannot be loaded, but that which needs a scan if none is given; or its frame does not come to its end.
pub fn figures(scan: Option<&Path>, figures: &mut Figures) -> Result<(), LabError> {
    let estimator = estimator(Path::new(RECORD), &Cache::new(Cache::default_folder("accuracy")))?;
    for name in SCENES {
        let path = Path::new("scenes").join(name).with_extension("toml");
        let scan = scan.filter(|_| name == SCAN_SCENE);
        let setting = scan.map(|path| format!("object.0.path={}", path.display()));
        let (scene, plan) = match load(&path, setting.as_slice()) {
            Err(LabError::Scene(error)) if name == SCAN_SCENE && scan.is_none() => {
                note!("{} is left out: {error}", path.display());
                continue;
            }
            loaded => loaded?,
        };
        note!("{name}: planned hardware beside everything");
        let costs = Costs::whole(&scene, &plan, Cycles::Measured, Some(&estimator))?;
        let shares = [("cycles_saved", costs.cycles_saved()), ("area_saved", costs.area_saved())];
        for (key, share) in shares.into_iter().chain([("memory_saved", Some(costs.memory_saved()))]) {
            match share {
                Some(share) => _ = figures.insert(format!("effects.{name}.{key}"), share.into()),
                None => note!("effects.{name}.{key} is left out: {RECORD} has too few units to estimate from"),
            }
        }
    }
    Ok(())
}
