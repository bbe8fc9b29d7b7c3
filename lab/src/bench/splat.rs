//! Figures of the renderer: frames, simulation speed, what planned hardware saves.

use super::{SCAN_SCENE, load, load_shipped, median};
use crate::note;
use crate::{Figures, LabError};
use pointcore::area::count;
use pointcore::generated::verilate;
use pointcore::plan::Plan;
use pointcore::scene::Scene;
use pointcore::shading::shade;
use pointcore::splat::{
    Drawn, EncodedFrame, Fates, SplatCore, SplatOutcome, SplatReport, SplatRun, SplatRunner, assemble,
};
use pointcore_golden::reference::Mapping;
use pointcore_tb::lockstep::Stall;
use pointcore_tb::verilated::{Library, Trace};
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// Timed runs of each kind; the median ratio is reported.
const REPETITIONS: usize = 5;
/// Cycles of a timed run.
const TIMED_CYCLES: u64 = 60_000;
/// Seeds of stalls with which a frame must come out the same.
const STALL_SEEDS: std::ops::RangeInclusive<u64> = 1..=5;
/// Share of the cycles in which a stalled run holds each stream back.
const STALL_SHARE: f64 = 0.3;

/// Measures the shipped scenes; `scan` is the model of scenes/igea.toml.
///
/// # Errors
/// A scene cannot be loaded, or hardware and model differ.
pub fn figures(scan: Option<&Path>, figures: &mut Figures) -> Result<(), LabError> {
    let knot = Prepared::new(Path::new("scenes/knot.toml"))?;
    speed_figures(&knot, figures)?;
    frame_figures(&knot, figures)?;
    if let Some((scene, plan)) = load_shipped(SCAN_SCENE, scan)? {
        frame_figures(&Prepared::on(SCAN_SCENE.to_owned(), scene, plan)?, figures)?;
    }
    saving_figures(&Prepared::new(Path::new("scenes/plane.toml"))?, figures)
}

/// A scene with its hardware, ready to run.
struct Prepared {
    name: String,
    scene: Scene,
    plan: Plan,
    core: SplatCore,
    library: Arc<Library>,
    frame: EncodedFrame,
}

impl Prepared {
    fn new(path: &Path) -> Result<Self, LabError> {
        let (scene, plan) = load(path, &[])?;
        let name = path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        Self::on(name, scene, plan)
    }

    fn on(name: String, scene: Scene, plan: Plan) -> Result<Self, LabError> {
        let core = SplatCore::generate(&plan.config)?;
        let library = verilate(&core.design, Trace::Off)?;
        let frame = EncodedFrame::new(&scene, &plan);
        Ok(Self { name, scene, plan, core, library, frame })
    }

    /// The same frame on hardware with everything in.
    fn with_everything(&self) -> Result<Self, LabError> {
        Self::on(self.name.clone(), self.scene.clone(), self.plan.with_everything())
    }

    fn runner(&self, stall: Stall, seed: u64) -> SplatRunner<'_> {
        SplatRunner { stall, seed, ..SplatRunner::new(&self.plan.config, &self.frame) }
    }
}

/// A frame of which a report is wanted.
pub(super) struct Reported<'a> {
    pub name: &'a str,
    pub scene: &'a Scene,
    pub plan: &'a Plan,
    pub engine: &'static str,
    pub mismatches: Option<u64>,
}

impl Reported<'_> {
    /// What is said of it.
    pub fn report(&self, runner: &SplatRunner, outcome: &SplatOutcome) -> SplatReport {
        let Self { name, scene, plan, engine, mismatches } = *self;
        let reference = pointcore::splat::reference(scene, Mapping::Backward);
        let rendered = assemble(plan, &outcome.fragments);
        SplatReport::new(&SplatRun {
            scene: name,
            engine,
            config: &plan.config,
            memory: runner.memory,
            fates: Fates::of(&plan.config, runner.frame),
            outcome,
            drawn: Drawn::Frame { frame: &rendered, reference: &reference },
            psnr_db: shade(&rendered, scene).psnr_db(&shade(&reference, scene)),
            mismatches,
        })
    }
}

/// The frame of a scene: lockstep, golden and stalled hardware must give the same fragments.
fn frame_figures(prepared: &Prepared, figures: &mut Figures) -> Result<(), LabError> {
    let Prepared { name, scene, plan, core, library, frame } = prepared;
    let free = prepared.runner(Stall::Never, 1);
    note!("{name}: lockstep");
    let outcome = free.lockstep(core, library)?;
    let golden = free.golden(core)?;
    let mut mismatches = u64::from(golden.fragments != outcome.fragments);
    for seed in STALL_SEEDS {
        note!("{name}: hardware with stalls, seed {seed}");
        let stalled = prepared.runner(Stall::Random(STALL_SHARE), seed).hardware(library, None)?;
        mismatches += u64::from(stalled.fragments != outcome.fragments);
    }

    let reported = Reported { name, scene, plan, engine: "rtl in lockstep with golden", mismatches: Some(mismatches) };
    let report = reported.report(&free, &outcome);
    let mut insert = |key: &str, value: Value| figures.insert(format!("splat.{name}.{key}"), value);
    insert("splats", (frame.records.len() - 1).into());
    insert("mismatches", mismatches.into());
    insert("psnr_db", report.psnr_db.into());
    insert("cycles", report.cycles.into());
    insert("cycles_per_splat", report.cycles_per_splat.into());
    insert("cycles_per_sample", report.cycles_per_sample.into());
    insert("rasterizer_utilisation", report.rasterizer_utilisation.into());
    insert("accumulator_utilisation", report.accumulator_utilisation.into());
    insert("hazard_fraction", report.hazard_fraction.into());
    insert("slot_wait_fraction", report.slot_wait_fraction.into());
    insert("buffer_bytes", (report.buffer_read_bytes + report.buffer_write_bytes).into());
    let differences = report.differences.unwrap_or_default();
    insert("coverage_differences", differences.coverage.into());
    insert("outcome_differences", differences.outcome.into());
    insert("depth_test_differences", differences.depth_test.into());
    insert("edge_differences", differences.edge.into());
    insert("sum_differences", differences.sum.into());
    Ok(())
}

fn speed(outcome: &SplatOutcome) -> f64 {
    outcome.simulated_cycles as f64 / outcome.elapsed.as_secs_f64()
}

/// Simulation speed beside a bare loop in C++ over the same model and the same inputs, alternating.
fn speed_figures(prepared: &Prepared, figures: &mut Figures) -> Result<(), LabError> {
    let runner = SplatRunner { stop_after: Some(TIMED_CYCLES), ..prepared.runner(Stall::Never, 1) };
    let rows = runner.record(&prepared.library)?;
    let (mut bare_ratios, mut lockstep_ratios, mut speeds) = (Vec::new(), Vec::new(), Vec::new());
    for repetition in 1..=REPETITIONS {
        note!("simulation speed: {repetition} of {REPETITIONS}");
        let mut model = prepared.library.instantiate(1);
        let started = Instant::now();
        model.run_bare(&rows, TIMED_CYCLES)?;
        let bare = TIMED_CYCLES as f64 / started.elapsed().as_secs_f64();
        let alone = speed(&runner.hardware(&prepared.library, None)?);
        let lockstep = speed(&runner.lockstep(&prepared.core, &prepared.library)?);
        bare_ratios.push(alone / bare);
        lockstep_ratios.push(lockstep / bare);
        speeds.push(alone);
    }
    for (key, values) in [("bare_ratio", bare_ratios), ("lockstep_ratio", lockstep_ratios), ("cycles_per_s", speeds)] {
        figures.insert(format!("sim.{key}"), median(values).into());
    }
    Ok(())
}

/// What leaving out what a scene does not call for saves: simulation time, alternating with hardware that has everything in.
fn saving_figures(planned: &Prepared, figures: &mut Figures) -> Result<(), LabError> {
    let everything = planned.with_everything()?;
    let mut ratios = Vec::new();
    for repetition in 1..=REPETITIONS {
        note!("{}: planned hardware beside everything, {repetition} of {REPETITIONS}", planned.name);
        let [small, large] = [planned, &everything].map(|prepared| {
            prepared
                .runner(Stall::Never, 1)
                .hardware(&prepared.library, None)
                .map(|outcome| outcome.elapsed.as_secs_f64())
        });
        ratios.push(small? / large?);
    }
    figures.insert(format!("plan.{}.time_ratio", planned.name), median(ratios).into());
    for (name, small, large) in count::rows(&planned.core.design, &everything.core.design) {
        let key = format!("plan.{}.{}_ratio", planned.name, name.replace(' ', "_"));
        figures.insert(key, (small as f64 / large as f64).into());
    }
    Ok(())
}
