//! One point: rendered, compared, timed.

use super::figures::{Compared, Hardware, PointEngine, PointFigures};
use super::point::RenderMethod;
use crate::LabError;
use pointcore::area::proxy::Proxy;
use pointcore::generated::verilate;
use pointcore::picture::Picture;
use pointcore::plan::Plan;
use pointcore::scene::Scene;
use pointcore::shading::picture;
use pointcore::splat::{DEPTH_ROUNDING, EncodedFrame, SplatCore, SplatRunner, assemble};
use pointcore_golden::reference::{Frame, Mapping, render};
use pointcore_tb::verilated::Trace;

/// Seed of the hardware's uninitialized values.
const SEED: u64 = 1;

/// A point that was rendered.
pub(super) struct Rendered {
    /// What it came to.
    pub figures: PointFigures,
    /// What it looks like.
    pub picture: Picture,
}

/// The scene in f64.
pub(super) fn reference(scene: &Scene, mapping: Mapping) -> Frame {
    render(&scene.splats, &scene.camera, &scene.rendering, mapping)
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
    let rendered = assemble(plan, &scene.splats, &outcome.fragments);
    let taken = Hardware { cycles: outcome.counters.cycles, proxy: Proxy::of(&core.design), config: config.clone() };
    Ok((rendered, taken))
}

/// Renders a scene as a point says.
pub(super) fn measure(
    scene: &Scene,
    plan: &Plan,
    method: RenderMethod,
    engine: PointEngine,
    truth: &Picture,
) -> Result<Rendered, LabError> {
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
    let compared = Compared {
        psnr_db: picture_of_it.psnr_db(&picture(&reference_frame, scene)),
        frame: &frame,
        reference: &reference_frame,
        depth_tolerance: scene.rendering.epsilon_bias.max(DEPTH_ROUNDING),
    };
    let figures = PointFigures::new(engine, &picture_of_it, truth, &compared, taken);
    Ok(Rendered { figures, picture: picture_of_it })
}
