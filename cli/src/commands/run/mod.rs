//! `pointcore run SCENE|MODEL`.

mod results;

use super::progress::{with_progress, with_spinner};
use super::results::Results;
use super::{Failure, Output, generate, load_on, scene_name, waveform};
use pointcore::package::Package;
use pointcore::plan::Plan;
use pointcore::scene::Scene;
use pointcore::shading;
use pointcore::splat::{Fates, RenderEngine, RenderSession};
use pointcore::waveform::{Waveform, Window, splat_view};
use pointcore_golden::reference::{self, Mapping};
use pointcore_tb::lockstep::Stall;
use pointcore_tb::verilated::Trace;
use results::{FrameResults, Summary};
use serde_json::json;
use std::path::{Path, PathBuf};

/// The waveform of a run.
const WAVEFORM: &str = "frame.fst";
/// What not every run leaves behind.
const OPTIONAL: [&str; 6] = [WAVEFORM, "frame.gtkw", "animation.png", "frames", "depth.pfm", "normals.pfm"];

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
    /// A scene file; or a model (PLY, OBJ, glTF, PCD, LAS, LAZ, XYZ, CSV), seen by a camera that fits it.
    #[arg(value_name = "SCENE|MODEL")]
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
    /// Write a waveform of the whole run (frame.fst, and frame.gtkw for GTKWave); implies --no-lockstep, slow and large.
    #[arg(long)]
    trace: bool,
    /// Write a waveform of these cycles of the run alone, A up to, but not, B; implies --trace.
    #[arg(long, value_name = "A..B")]
    trace_window: Option<Window>,
    /// Render a full turn around the scene in N frames, each on the hardware: frames/ and animation.png; as `--set camera.turntable=N`.
    #[arg(long, value_name = "N")]
    turntable: Option<usize>,
    /// Write the fragments' distance from the eye, too, in the scene's units: depth.pfm, infinite where there is none.
    #[arg(long)]
    depth: bool,
    /// Write the fragments' world-space normals, too: normals.pfm, zero where there is none.
    #[arg(long)]
    normals: bool,
    /// The folder for the results; by default out/<scene>.
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Hold every stream back in this share of the cycles, at random.
    #[arg(long, value_name = "SHARE", default_value_t = 0.0)]
    stalls: f64,
    /// Seed of the stalls and of the hardware's uninitialized values.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Replaces a value of the scene file, or of the one that a model is drawn in, e.g. `--set object.0.path=/scans/face.ply`,
    /// `--set camera.from=[1,0,0]`; paths are relative to the scene file.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    settings: Vec<String>,
}

impl Arguments {
    fn check(&self) -> Result<(), Failure> {
        let usage = |message: &str| Err(Failure::Usage(message.to_owned()));
        if !(0.0..1.0).contains(&self.stalls) {
            return Err(Failure::Usage(format!("--stalls {}: expected a share from 0 up to, but not, 1", self.stalls)));
        }
        if self.model != RunEngine::Rtl && (self.is_traced() || self.no_lockstep) {
            return usage("--trace, --trace-window and --no-lockstep go with --model rtl");
        }
        if self.model == RunEngine::Reference && (self.depth || self.normals || self.turntable.is_some()) {
            return usage("--depth, --normals and --turntable go with --model rtl or golden");
        }
        Ok(())
    }

    const fn is_traced(&self) -> bool {
        self.trace || self.trace_window.is_some()
    }

    fn settings(&self) -> Vec<String> {
        let turntable = self.turntable.map(|frames| format!("camera.turntable={frames}"));
        self.settings.iter().cloned().chain(turntable).collect()
    }

    /// The engine, its name, and how many outputs differed where they are compared: a difference ends the run.
    const fn engine(&self) -> (RenderEngine, &'static str, Option<u64>) {
        match self.model {
            RunEngine::Rtl if self.is_traced() || self.no_lockstep => (RenderEngine::Hardware, "rtl", None),
            RunEngine::Rtl => (RenderEngine::Lockstep, "rtl in lockstep with golden", Some(0)),
            RunEngine::Golden | RunEngine::Reference => (RenderEngine::Golden, "golden", None),
        }
    }

    fn open(&self, scene: Scene, plan: Plan) -> Result<RenderSession, Failure> {
        if self.is_traced() && scene.views.len() > 1 {
            return Err(Failure::Usage(format!("--trace goes with one frame, but there are {}", scene.views.len())));
        }
        let trace = if self.is_traced() { Trace::On } else { Trace::Off };
        let stall = if self.stalls > 0.0 { Stall::Random(self.stalls) } else { Stall::Never };
        let session = with_spinner("generating, verilating and compiling (cached for the next time)", || {
            RenderSession::on(scene, plan, self.engine().0, trace)
        });
        Ok(session?.randomized(stall, self.seed))
    }
}

/// Renders a scene.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    arguments.check()?;
    let (scene, plan) = load_on(&arguments.scene, &arguments.settings(), arguments.config.as_deref())?;
    let name = scene_name(&arguments.scene);
    let place = arguments.output.clone().unwrap_or_else(|| Path::new("out").join(&name));
    let results = Results::begin(&place)?;
    if arguments.model == RunEngine::Reference {
        return run_reference(&scene, &name, results, &place, output);
    }
    let folder = results.folder();

    let mut session = arguments.open(scene, plan)?;
    let package = Package::splat(&name, session.core(), &session.plan().config)?;
    generate::write_package(&package, &folder.join("verilog"))?;
    let (_, engine, mismatches) = arguments.engine();
    let mut frames = FrameResults::new(&session, &name, (folder, &place), engine, mismatches)?;
    let mut fates = Fates::default();
    for index in 0..session.frames() {
        let (path, window) = (folder.join(WAVEFORM), arguments.trace_window.clone());
        let waveform = arguments.is_traced().then_some(Waveform { path, window });
        let render = |progress: &(dyn Fn(u64, f64) + Sync)| session.frame_with(index, progress, waveform.as_ref());
        let frame = with_progress(engine, render)?;
        if index == 0 {
            fates = frame.fates;
            frames.write_numbers(&session, &frame, arguments.depth, arguments.normals)?;
        }
        if arguments.is_traced() {
            waveform::finish(arguments.trace_window.as_ref(), frame.outcome.simulated_cycles)?;
            waveform::write_view(&splat_view(&session.plan().config), WAVEFORM, folder, &place)?;
        }
        frames.add(&session, &frame)?;
    }
    let Summary { fragments, document, text } = frames.finish(&session)?;
    results.finish(&OPTIONAL)?;
    output.print(&document, &text)?;
    if fragments == 0 {
        return Err(Failure::Blank { path: arguments.scene.clone(), fates });
    }
    Ok(())
}

/// Renders a scene's first frame by the f64 reference alone.
fn run_reference(scene: &Scene, name: &str, results: Results, place: &Path, output: Output) -> Result<(), Failure> {
    const PICTURE: &str = "reference.png";
    let reference = reference::render(&scene.splats, &scene.camera, &scene.rendering, Mapping::Backward);
    shading::picture(&reference, scene).save_png(&results.folder().join(PICTURE))?;
    results.finish(&[])?;
    let path = place.join(PICTURE);
    output.print(&json!({ "scene": name, "reference": path }), &path.display().to_string())
}
