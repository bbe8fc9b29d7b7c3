//! What bounds a frame, on the scenes that matter, by the number of rasterizers; on the golden model.

use super::splat::Reported;
use super::{SCENES, load_shipped};
use crate::{Figures, LabError, note};
use pointcore::plan::Plan;
use pointcore::scene::Scene;
use pointcore::splat::{EncodedFrame, SplatCore, SplatReport, SplatRunner};
use rayon::prelude::*;
use serde_json::Value;
use std::path::Path;
use std::slice;

/// Scenes with the statistics of the thesis' table 5.3.
pub(super) const TABLE_SCENES: [&str; 3] = ["bench/table53_1", "bench/table53_2", "bench/table53_3"];
/// Numbers of rasterizers.
const RASTERIZERS: [u32; 4] = [1, 2, 4, 8];
/// Frames that follow each other.
const REPEATED_FRAMES: usize = 4;
/// The key of the configuration that counts them.
const RASTERIZERS_KEY: &str = "rasterizers";
/// Payloads in memory instead of on the chip.
const PAYLOAD_IN_MEMORY: (&str, &str) = ("payload", "memory");

/// Measures every shipped scene; `scan` is the model of scenes/igea.toml.
///
/// # Errors
/// A scene cannot be loaded, or its frame does not come to its end.
pub fn figures(scan: Option<&Path>, figures: &mut Figures) -> Result<(), LabError> {
    let names: Vec<_> = SCENES.into_iter().chain(TABLE_SCENES).collect();
    let measured: Vec<_> = names.par_iter().map(|name| scene_figures(name, scan)).collect::<Result<_, _>>()?;
    figures.extend(measured.into_iter().flatten());
    Ok(())
}

/// The frames of a scene.
fn scene_figures(path: &str, scan: Option<&Path>) -> Result<Figures, LabError> {
    let mut figures = Figures::new();
    let Some((scene, _)) = load_shipped(path, scan)? else { return Ok(figures) };
    let name = path.rsplit('/').next().unwrap_or(path);
    for count in RASTERIZERS {
        note!("{name}: golden model, {count} rasterizers");
        let rasterizers = (RASTERIZERS_KEY, i64::from(count).into());
        let (key, value) = PAYLOAD_IN_MEMORY;
        let on_chip = frame_figures(name, &scene, &plan_with(&scene, slice::from_ref(&rasterizers))?)?;
        let in_memory = payload_figures(name, &scene, &plan_with(&scene, &[rasterizers, (key, value.into())])?)?;
        for (key, value) in on_chip.into_iter().chain(in_memory) {
            figures.insert(format!("splat.{name}.n{count}.{key}"), value);
        }
    }
    Ok(figures)
}

/// A plan in which some keys have these values.
fn plan_with(scene: &Scene, values: &[(&str, toml::Value)]) -> Result<Plan, LabError> {
    let mut overrides = scene.overrides.clone();
    overrides.extend(values.iter().map(|(key, value)| ((*key).to_owned(), value.clone())));
    Ok(Plan::with_overrides(scene, &overrides)?)
}

/// Whole frames, until the last fragment has left; and the same one several times over, each drawn while the one before leaves.
fn frame_figures(name: &str, scene: &Scene, plan: &Plan) -> Result<[(&'static str, Value); 10], LabError> {
    let frame = EncodedFrame::new(scene, plan);
    let (core, report) = run(name, scene, plan, &frame)?;
    let repeated = EncodedFrame { records: frame.records.repeat(REPEATED_FRAMES), ..frame.clone() };
    let repeated = SplatRunner::new(&plan.config, &repeated).golden(&core)?.counters.cycles;
    let of_repeated = (report.bound.cycles * REPEATED_FRAMES as u64) as f64 / repeated as f64;
    Ok([
        ("cycles", report.cycles.into()),
        ("bound_fraction", report.bound_fraction.into()),
        ("bound_fraction_frames4", of_repeated.into()),
        ("visited_ratio", report.visited_ratio.into()),
        ("hazard_fraction", report.hazard_fraction.into()),
        ("buffer_bytes", (report.buffer_read_bytes + report.buffer_write_bytes).into()),
        ("cycles_per_copy", report.cycles_per_copy.into()),
        ("samples_per_splat", report.samples_per_splat.into()),
        ("coverage", report.coverage.into()),
        ("overdraw", report.overdraw.into()),
    ])
}

/// A whole frame whose payloads lie in memory.
fn payload_figures(name: &str, scene: &Scene, plan: &Plan) -> Result<[(&'static str, Value); 2], LabError> {
    let (_, report) = run(name, scene, plan, &EncodedFrame::new(scene, plan))?;
    Ok([
        ("payload_bytes", (report.payload_read_bytes + report.payload_write_bytes).into()),
        ("payload_cycles", report.cycles.into()),
    ])
}

/// A frame on the golden model, and what is to be said of it.
fn run(name: &str, scene: &Scene, plan: &Plan, frame: &EncodedFrame) -> Result<(SplatCore, SplatReport), LabError> {
    let core = SplatCore::generate(&plan.config)?;
    let runner = SplatRunner::new(&plan.config, frame);
    let outcome = runner.golden(&core)?;
    let report = Reported { name, scene, plan, engine: "golden", mismatches: None }.report(&runner, &outcome);
    Ok((core, report))
}
