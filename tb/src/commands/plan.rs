//! `pointcore plan SCENE`.

use super::{Failure, Output, load};
use pointcore::core_a::{Core, area};
use serde_json::json;
use std::fmt::Write as _;
use std::path::PathBuf;

/// Arguments of `plan`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The scene file.
    scene: PathBuf,
    /// Replaces a value of the scene file, e.g. `--set object.0.path=/scans/face.ply`; paths are relative to the scene file.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    settings: Vec<String>,
}

/// Explains the hardware for a scene.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let (scene, plan) = load(&arguments.scene, &arguments.settings)?;
    let planned = Core::generate(&plan.config)?;
    let full = Core::generate(&plan.with_everything().config)?;

    let mut text = format!("{}: {} splats\n\n", arguments.scene.display(), scene.splats.len());
    for choice in &plan.choices {
        _ = writeln!(text, "  {:22} {:14} {}", choice.part, choice.chosen, choice.reason);
    }
    _ = writeln!(text, "\n  {:22} {:>12} {:>12} {:>8}", "area proxy", "this scene", "everything", "saved");
    for (name, planned, full) in area::rows(&planned.design, &full.design) {
        let saved = 100.0 * (1.0 - planned as f64 / full.max(1) as f64);
        _ = writeln!(text, "  {name:22} {planned:>12} {full:>12} {saved:>7.1}%");
    }
    _ = writeln!(text, "\n  {:22} {:>9} {:>9}", "datapath", "latency", "interval");
    for (unit, manifest) in &planned.manifests {
        _ = writeln!(text, "  {unit:22} {:>9} {:>9}", manifest.latency, manifest.initiation_interval);
    }
    let document = json!({
        "scene": arguments.scene,
        "splats": scene.splats.len(),
        "config": plan.config,
        "choices": plan.choices,
        "area": area::document(&planned.design),
        "area_with_everything": area::document(&full.design),
        "datapaths": planned.manifests,
    });
    output.print(&document, &text);
    Ok(())
}
