//! What leaving out effects saves, on every shipped scene.

use super::{SCENES, load_shipped};
use crate::accuracy::estimator;
use crate::note;
use crate::{Figures, LabError};
use pointcore::cost::{Costs, Cycles};
use pointcore_tb::cache::Cache;
use std::path::Path;

/// What look-up tables are estimated from.
const RECORD: &str = "docs/area.json";

/// Shares of cycles and look-up tables that planned hardware saves of hardware with everything in, both on the golden model.
///
/// # Errors
/// A scene cannot be loaded, but that which needs a scan if none is given; or its frame does not come to its end.
pub fn figures(scan: Option<&Path>, figures: &mut Figures) -> Result<(), LabError> {
    let estimator = estimator(Path::new(RECORD), &Cache::new(Cache::default_folder("accuracy")))?;
    for name in SCENES {
        let Some((scene, plan)) = load_shipped(name, scan)? else { continue };
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
