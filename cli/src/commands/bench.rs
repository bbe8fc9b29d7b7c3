//! `pointcore bench`: the project's figures, merged into one flat JSON object.

use super::{Failure, Output, existing, merge};
use pointcore_lab::Figures;
use pointcore_lab::bench::{
    bounds, configurations, effects, front, knn, motion, motion_units, operators, process, splat, traffic,
};
use std::path::{Path, PathBuf};

/// Arguments of `bench`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The scan for scenes/igea.toml and for neighbor search; without it that scene is measured only if its own path exists, and
    /// neighbors are searched on a procedural surface.
    #[arg(long, value_name = "FILE")]
    scan: Option<PathBuf>,
    /// More models in which neighbors are compared with brute force.
    #[arg(long, value_name = "FILE", num_args = 1..)]
    models: Vec<PathBuf>,
    /// What to measure; by default everything.
    #[arg(long, value_enum, value_name = "PART", num_args = 1.., default_values = ["splat", "bounds", "traffic", "effects", "motion", "knn", "process", "operators", "configurations", "front"])]
    only: Vec<Part>,
    /// The file to merge the figures into.
    #[arg(short, long, default_value = "out/bench.json")]
    output: PathBuf,
}

/// A part of the benchmark.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Part {
    /// The renderer: frames and simulation speed.
    Splat,
    /// The renderer: what bounds a frame, on all shipped scenes.
    Bounds,
    /// The renderer: bytes to and from memory, reorder stage or tile cache; its charts and tables go to a folder `traffic-bench` beside the output.
    Traffic,
    /// The renderer: what leaving out saves that a scene does not call for.
    Effects,
    /// Motion blur: what its units make of random splats, beside f64 and in lockstep; how far each method in f64, and the
    /// golden models of hardware, are from many samples in time, with tables and strips of pictures in a folder `motion-bench` beside the output.
    Motion,
    /// The search core: neighbor search; its charts and tables go to a folder `knn-bench` beside the output.
    Knn,
    /// The point processor: programs on neighborhoods; its charts and tables go to a folder `process-bench` beside the output.
    Process,
    /// Floating-point operators.
    Operators,
    /// Cycles of the named configurations.
    Configurations,
    /// Models of one's own and mistakes, through this very command.
    Front,
}

/// Measures everything.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    // A file that is none is found before hours of measuring.
    existing(&arguments.output)?;
    let mut figures = Figures::new();
    let scan = arguments.scan.as_deref();
    let measures = |part| arguments.only.contains(&part);
    if measures(Part::Splat) {
        splat::figures(scan, &mut figures)?;
    }
    if measures(Part::Bounds) {
        bounds::figures(scan, &mut figures)?;
    }
    if measures(Part::Traffic) {
        traffic::figures(scan, &arguments.output.with_file_name("traffic-bench"), &mut figures)?;
    }
    if measures(Part::Effects) {
        effects::figures(scan, &mut figures)?;
    }
    if measures(Part::Motion) {
        motion_units::figures(&mut figures)?;
        motion::figures(&arguments.output.with_file_name("motion-bench"), &mut figures)?;
    }
    if measures(Part::Knn) {
        let folder = arguments.output.with_file_name("knn-bench");
        knn::figures(scan, &arguments.models, &folder, &mut figures)?;
    }
    if measures(Part::Process) {
        process::figures(scan, &arguments.output.with_file_name("process-bench"), &mut figures)?;
    }
    if measures(Part::Operators) {
        operators::figures(&mut figures)?;
    }
    if measures(Part::Configurations) {
        configurations::figures(Path::new("."), &mut figures)?;
    }
    if measures(Part::Front) {
        let program = std::env::current_exe();
        let program = program.map_err(|source| Failure::Write { path: "pointcore".into(), source })?;
        let scans: Vec<_> = arguments.scan.iter().chain(&arguments.models).cloned().collect();
        front::figures(&program, &scans, &mut figures)?;
    }

    let merged = merge(&arguments.output, figures)?;
    let text = serde_json::to_string_pretty(&merged).expect("figures have string keys");
    output.print(&merged, &text)
}
