//! `pointcore run SCENE`.

use super::progress::{with_progress, with_spinner};
use super::{Failure, Output, generate, load_on, scene_name, write};
use pointcore::generated::verilate;
use pointcore::package::Package;
use pointcore::shading;
use pointcore::splat::{EncodedFrame, SplatCore, SplatOutcome, SplatReport, SplatRun, SplatRunner, assemble};
use pointcore_golden::reference::{self, Mapping};
use pointcore_tb::lockstep::Stall;
use pointcore_tb::verilated::Trace;
use serde_json::json;
use std::path::{Path, PathBuf};

/// How much difference.png magnifies.
const MAGNIFICATION: f64 = 16.0;

/// What renders the scene.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum RunEngine {
    /// The generated Verilog under Verilator, in lockstep with the golden model.
    Rtl,
    /// The bit-exact, cycle-accurate golden model alone.
    Golden,
    /// The f64 reference renderer alone.
    Reference,
}

/// Arguments of `run`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The scene file.
    scene: PathBuf,
    /// A hardware configuration of the renderer, such as configs/fpga.toml, to render on as it is, in the place of the hardware that the scene calls
    /// for; the scene's [overrides] are ignored. A scene that asks for an effect the configuration excludes is an error.
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// What renders the scene.
    #[arg(long, value_enum, default_value = "rtl")]
    model: RunEngine,
    /// Do not compare the Verilog with the golden model: faster, but trusts it.
    #[arg(long)]
    no_lockstep: bool,
    /// Write a waveform of the whole run (frame.fst); implies --no-lockstep, slow and large.
    #[arg(long)]
    trace: bool,
    /// The folder for the results; by default out/<scene>.
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Hold every stream back in this share of the cycles, at random.
    #[arg(long, value_name = "SHARE", default_value_t = 0.0)]
    stalls: f64,
    /// Seed of the stalls and of the hardware's uninitialized values.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Replaces a value of the scene file, e.g. `--set object.0.path=/scans/face.ply`; paths are relative to the scene file.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    settings: Vec<String>,
}

impl Arguments {
    fn check(&self) -> Result<(), Failure> {
        if !(0.0..1.0).contains(&self.stalls) {
            return Err(Failure::Usage(format!("--stalls {}: expected a share from 0 up to, but not, 1", self.stalls)));
        }
        if self.model != RunEngine::Rtl && (self.trace || self.no_lockstep) {
            return Err(Failure::Usage("--trace and --no-lockstep go with --model rtl".to_owned()));
        }
        Ok(())
    }

    /// Runs on what was chosen; says which, and how many outputs differed where they were compared.
    fn simulate(
        &self,
        core: &SplatCore,
        runner: &SplatRunner,
        folder: &Path,
    ) -> Result<(SplatOutcome, &'static str, Option<u64>), Failure> {
        if self.model == RunEngine::Golden {
            let outcome = with_progress("golden", |progress| SplatRunner { progress, ..*runner }.golden(core))?;
            return Ok((outcome, "golden", None));
        }
        let trace = if self.trace { Trace::On } else { Trace::Off };
        let library =
            with_spinner("verilating and compiling (cached for the next time)", || verilate(&core.design, trace))?;
        if self.trace || self.no_lockstep {
            let waveform = self.trace.then(|| folder.join("frame.fst"));
            let run = |progress: &(dyn Fn(u64, f64) + Sync)| {
                SplatRunner { progress, ..*runner }.hardware(&library, waveform.as_deref())
            };
            return Ok((with_progress("hardware", run)?, "rtl", None));
        }
        let run = |progress: &(dyn Fn(u64, f64) + Sync)| SplatRunner { progress, ..*runner }.lockstep(core, &library);
        // A difference would have ended the run.
        Ok((with_progress("lockstep", run)?, "rtl in lockstep with golden", Some(0)))
    }
}

/// Renders a scene.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    arguments.check()?;
    let (scene, plan) = load_on(&arguments.scene, &arguments.settings, arguments.config.as_deref())?;
    let name = scene_name(&arguments.scene);
    let folder = arguments.output.clone().unwrap_or_else(|| Path::new("out").join(&name));
    std::fs::create_dir_all(&folder).map_err(|source| Failure::Write { path: folder.clone(), source })?;

    let reference = reference::render(&scene.splats, &scene.camera, &scene.rendering, Mapping::Backward);
    let reference_picture = shading::picture(&reference, &scene);
    reference_picture.save_png(&folder.join("reference.png"))?;
    if arguments.model == RunEngine::Reference {
        let path = folder.join("reference.png");
        output.print(&json!({ "scene": name, "reference": path }), &path.display().to_string());
        return Ok(());
    }

    let core = SplatCore::generate(&plan.config)?;
    generate::write_package(&Package::splat(&name, &core, &plan.config)?, &folder.join("verilog"))?;
    let frame = EncodedFrame::new(&scene, &plan);
    let stall = if arguments.stalls > 0.0 { Stall::Random(arguments.stalls) } else { Stall::Never };
    let runner = SplatRunner {
        config: &plan.config,
        frame: &frame,
        stall,
        seed: arguments.seed,
        progress: &|_, _| {},
        stop_after: None,
    };
    let (outcome, engine, mismatches) = arguments.simulate(&core, &runner, &folder)?;

    let rendered = assemble(&plan, &scene.splats, &outcome.fragments);
    let picture = shading::picture(&rendered, &scene);
    picture.save_png(&folder.join("frame.png"))?;
    picture.difference(&reference_picture, MAGNIFICATION).save_png(&folder.join("difference.png"))?;
    let report = SplatReport::new(&SplatRun {
        scene: &name,
        engine,
        config: &plan.config,
        splats: scene.splats.len(),
        counters: &outcome.counters,
        frame: &rendered,
        reference: &reference,
        psnr_db: picture.psnr_db(&reference_picture),
        mismatches,
        simulated_cycles_per_second: outcome.simulated_cycles as f64 / outcome.elapsed.as_secs_f64(),
    });
    let markdown = report.markdown();
    write(&folder.join("report.md"), &markdown)?;
    write(&folder.join("report.json"), &serde_json::to_string_pretty(&report).expect("reports have string keys"))?;
    output.print(&report, &format!("{markdown}\nWritten to {}.", folder.display()));
    Ok(())
}
