//! `pointcore run SCENE|MODEL`.

mod moving;
mod reference;
mod results;

use super::memory::BusArguments;
use super::progress::{with_progress, with_spinner};
use super::results::Results;
use super::simulation::{Engine, Simulated, SimulationArguments};
use super::{Failure, Output, Renderer, generate, moving_plan_on, numbers, plan_on, scene_name, waveform};
use pointcore::package::Package;
use pointcore::plan::Plan;
use pointcore::scene::{FRAMES_LIMIT, Scene};
use pointcore::splat::memory::ReconstructionBuffer;
use pointcore::splat::{Fates, RenderSession};
use pointcore::waveform::splat_view;
use pointcore_tb::verilated::Trace;
use results::{FrameResults, Summary};
use std::path::{Path, PathBuf};

/// The waveform of a run.
const WAVEFORM: &str = "frame.fst";
/// What not every run leaves behind.
const OPTIONAL: [&str; 6] = [WAVEFORM, "frame.gtkw", "animation.png", "frames", "depth.pfm", "normals.pfm"];

/// What is said of the first steps.
const GENERATING: &str = "generating, verilating and compiling (cached for the next time)";

/// Frames beyond which the mean of more is the same.
const SAMPLES_IN_TIME_LIMIT: usize = 65536;

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
    #[command(flatten)]
    simulation: SimulationArguments,
    /// How the reconstruction buffer's memory answers.
    #[command(flatten)]
    memory: BusArguments,
    /// Render a full turn around the scene in N frames, each on the hardware: frames/ and animation.png; as `--set camera.turntable=N`.
    #[arg(long, value_name = "N", value_parser = numbers::within(1..=FRAMES_LIMIT, "1 to 2000 frames"))]
    turntable: Option<usize>,
    /// With --model reference, render a scene that moves as the mean of N still frames: the truth that motion blur approximates, where N is large.
    #[arg(long, value_name = "N", value_parser = numbers::within(1..=SAMPLES_IN_TIME_LIMIT, "1 to 65536 samples in time"))]
    samples_in_time: Option<usize>,
    /// Write the fragments' distance from the eye, too, in the scene's units: depth.pfm, infinite where there is none.
    #[arg(long)]
    depth: bool,
    /// Write the fragments' world-space normals, too: normals.pfm, zero where there is none.
    #[arg(long)]
    normals: bool,
    /// The folder for the results; by default out/<scene>.
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Seed of the stalls and of the hardware's uninitialized values.
    #[arg(long, default_value_t = 1, value_parser = numbers::whole())]
    seed: u64,
    /// Replaces a value of the scene file, or of the one that a model is drawn in, e.g. `--set object.0.path=/scans/face.ply`,
    /// `--set camera.from=[1,0,0]`; paths are relative to the scene file.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    settings: Vec<String>,
}

impl Arguments {
    fn check(&self) -> Result<(), Failure> {
        self.simulation.check(self.simulated())?;
        let needs_fragments = self.depth || self.normals || self.turntable.is_some();
        let needs_cycles = self.simulation.is_stalled() || self.memory.is_given();
        if self.model == RunEngine::Reference && (needs_fragments || needs_cycles) {
            let message = "--depth, --normals, --turntable, --stalls, --latency, --bandwidth and --burst go with --model rtl or golden";
            return Err(Failure::Usage(message.to_owned()));
        }
        if self.samples_in_time.is_some() && self.model != RunEngine::Reference {
            return Err(Failure::Usage("--samples-in-time goes with --model reference".to_owned()));
        }
        Ok(())
    }

    const fn simulated(&self) -> Simulated {
        match self.model {
            RunEngine::Rtl => Simulated::Verilog,
            RunEngine::Golden | RunEngine::Reference => Simulated::Model,
        }
    }

    const fn engine(&self) -> Engine {
        self.simulation.engine(self.simulated())
    }

    fn settings(&self) -> Vec<String> {
        let turntable = self.turntable.map(|frames| format!("camera.turntable={frames}"));
        self.settings.iter().cloned().chain(turntable).collect()
    }

    fn place(&self, name: &str) -> PathBuf {
        self.output.clone().unwrap_or_else(|| Path::new("out").join(name))
    }

    const fn trace(&self) -> Trace {
        if self.simulation.is_traced() { Trace::On } else { Trace::Off }
    }

    fn open(&self, scene: Scene, plan: Plan) -> Result<RenderSession, Failure> {
        if self.simulation.is_traced() && scene.views.len() > 1 {
            return Err(Failure::Usage(format!("--trace goes with one frame, but there are {}", scene.views.len())));
        }
        let session = with_spinner(GENERATING, || RenderSession::on(scene, plan, self.engine().into(), self.trace()));
        let memory = self.memory.settings(ReconstructionBuffer::SETTINGS);
        Ok(session?.behind(memory)?.randomized(self.simulation.stall(), self.seed))
    }
}

/// Renders a scene.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    arguments.check()?;
    if arguments.model == RunEngine::Reference {
        return reference::run(arguments, output);
    }
    let renderer = arguments.config.as_deref().map(Renderer::read).transpose()?;
    let scene = Scene::load(&arguments.scene, &arguments.settings())?;
    if scene.motion.is_some() {
        let plan = moving_plan_on(&arguments.scene, &scene, renderer.as_ref())?;
        return moving::run(arguments, scene, plan, output);
    }
    let plan = plan_on(&arguments.scene, &scene, renderer.as_ref())?;
    let name = scene_name(&arguments.scene);
    let place = arguments.place(&name);
    let results = Results::begin(&place)?;
    let folder = results.folder();

    let mut session = arguments.open(scene, plan)?;
    let package = Package::splat(&name, session.core(), &session.plan().config)?;
    generate::write_package(&package, &folder.join("verilog"))?;
    let engine = arguments.engine();
    let mut frames = FrameResults::new(&session, &name, (folder, &place), engine)?;
    let mut fates = Fates::default();
    for index in 0..session.frames() {
        let waveform = arguments.simulation.waveform(folder.join(WAVEFORM));
        let render = |progress: &(dyn Fn(u64, f64) + Sync)| session.frame_with(index, progress, waveform.as_ref());
        let frame = with_progress(engine.name(), render)?;
        if index == 0 {
            fates = frame.fates;
            frames.write_numbers(&session, &frame, arguments.depth, arguments.normals)?;
        }
        if arguments.simulation.is_traced() {
            waveform::finish(arguments.simulation.trace_window.as_ref(), frame.outcome.simulated_cycles)?;
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
