//! One point: rendered, compared, timed.

use super::figures::{Compared, Hardware, PointEngine, PointFigures, surface_differences};
use super::point::RenderMethod;
use crate::LabError;
use pointcore::area::proxy::Proxy;
use pointcore::exposure::{Exposure, by_method, by_samples};
use pointcore::generated::verilate;
use pointcore::picture::Picture;
use pointcore::plan::{MovingPlan, Plan};
use pointcore::scene::Scene;
use pointcore::shading::{exposed, picture};
use pointcore::splat::{
    DEPTH_ROUNDING, EncodedFrame, MovingSession, RenderEngine, SplatCore, SplatRunner, assemble, reference,
};
use pointcore_golden::reference::motion::Method;
use pointcore_golden::reference::{Frame, Mapping};
use pointcore_tb::lockstep::Stall;
use pointcore_tb::verilated::Trace;

/// Seed of the hardware's uninitialized values.
const SEED: u64 = 1;
/// Still frames whose mean is the truth about what moves.
const TRUE_SAMPLES: usize = 64;

/// A point that was rendered.
pub(super) struct Rendered {
    /// What it came to.
    pub figures: PointFigures,
    /// What it looks like.
    pub picture: Picture,
}

/// The hardware of a point: of a scene that moves both cores.
pub(super) enum PointPlan {
    Still(Box<Plan>),
    Moving(Box<MovingPlan>),
}

impl PointPlan {
    /// Every core of it.
    pub fn cores(&self) -> Vec<&Plan> {
        match self {
            Self::Still(plan) => vec![plan],
            Self::Moving(plan) => std::iter::once(&plan.moving).chain(&plan.still).collect(),
        }
    }
}

/// A scene's picture in f64, with whatever else is there exact: a still frame, or the mean of many.
pub(super) fn truth(scene: &Scene) -> Picture {
    match scene.motion {
        Some(_) => exposed(&by_samples(scene, TRUE_SAMPLES, &|| ()), scene),
        None => picture(&reference(scene, Mapping::Backward), scene),
    }
}

/// The frame on hardware, and what that took.
fn hardware(scene: &Scene, plan: &Plan, engine: PointEngine) -> Result<(Frame, Hardware), LabError> {
    let config = &plan.config;
    let core = SplatCore::generate(config)?;
    let frame = EncodedFrame::new(scene, plan);
    let runner = SplatRunner { seed: SEED, ..SplatRunner::new(config, &frame) };
    let outcome = match engine {
        PointEngine::Lockstep => runner.lockstep(&core, &verilate(&core.design, Trace::Off)?)?,
        PointEngine::Golden | PointEngine::F64 => runner.golden(&core)?,
    };
    let rendered = assemble(plan, &outcome.fragments);
    let taken = Hardware { cycles: outcome.counters.cycles, proxy: Proxy::of(&core.design), config: config.clone() };
    Ok((rendered, taken))
}

/// The exposure on hardware, and what that took: both cores, one after the other.
fn moving_hardware(scene: &Scene, plan: &MovingPlan, engine: PointEngine) -> Result<(Exposure, Hardware), LabError> {
    let engine = match engine {
        PointEngine::Lockstep => RenderEngine::Lockstep,
        PointEngine::Golden | PointEngine::F64 => RenderEngine::Golden,
    };
    let session = MovingSession::on(scene.clone(), plan.clone(), engine, Trace::Off)?;
    let mut session = session.randomized(Stall::Never, SEED);
    let frame = session.frame()?;
    let mut taken = Hardware {
        cycles: frame.outcome.counters.cycles,
        proxy: Proxy::of(&session.core().design),
        config: plan.moving.config.clone(),
    };
    if let (Some(still), Some(drawn)) = (session.still(), &frame.still) {
        taken.cycles += drawn.outcome.counters.cycles;
        taken.proxy = taken.proxy.sum(Proxy::of(&still.core().design));
    }
    Ok((frame.exposure, taken))
}

/// Renders a scene as a point says.
pub(super) fn measure(
    scene: &Scene,
    plan: &PointPlan,
    method: RenderMethod,
    engine: PointEngine,
    truth: &Picture,
) -> Result<Rendered, LabError> {
    let (picture, compared, taken) = match plan {
        PointPlan::Still(plan) => measure_still(scene, plan, method, engine)?,
        PointPlan::Moving(plan) => measure_moving(scene, plan, method, engine)?,
    };
    let figures = PointFigures::new(engine, &picture, truth, &compared, taken);
    Ok(Rendered { figures, picture })
}

fn measure_still(
    scene: &Scene,
    plan: &Plan,
    method: RenderMethod,
    engine: PointEngine,
) -> Result<(Picture, Compared, Option<Hardware>), LabError> {
    let reference_frame = reference(scene, Mapping::Backward);
    let (frame, taken) = match method {
        RenderMethod::Hardware => {
            let (frame, taken) = hardware(scene, plan, engine)?;
            (frame, Some(taken))
        }
        RenderMethod::Backward => (reference_frame.clone(), None),
        RenderMethod::Forward => (reference(scene, Mapping::Forward), None),
    };
    let picture_of_it = picture(&frame, scene);
    let tolerance = scene.rendering.epsilon_bias.max(DEPTH_ROUNDING);
    let compared = Compared {
        psnr_db: picture_of_it.psnr_db(&picture(&reference_frame, scene)),
        surface_differences: Some(surface_differences(&frame, &reference_frame, tolerance)),
        samples: frame.pixels.len() as u64,
    };
    Ok((picture_of_it, compared, taken))
}

fn measure_moving(
    scene: &Scene,
    plan: &MovingPlan,
    method: RenderMethod,
    engine: PointEngine,
) -> Result<(Picture, Compared, Option<Hardware>), LabError> {
    let in_bins =
        || by_method(scene, &scene.moving_splats(), Method::Bins(plan.moving.config.time_bins as usize), &|| ());
    let reference = exposed(&in_bins(), scene);
    let (exposure, taken) = match method {
        RenderMethod::Hardware => {
            let (exposure, taken) = moving_hardware(scene, plan, engine)?;
            (exposure, Some(taken))
        }
        RenderMethod::Backward | RenderMethod::Forward => (in_bins(), None),
    };
    let picture = exposed(&exposure, scene);
    let samples = exposure.samples.len() as u64;
    let compared = Compared { psnr_db: picture.psnr_db(&reference), surface_differences: None, samples };
    Ok((picture, compared, taken))
}
