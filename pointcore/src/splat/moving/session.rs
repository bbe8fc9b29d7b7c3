//! Exposing as a library: a scene that moves in, a picture out.

use super::exposure::expose;
use crate::exposure::by_method;
use crate::generated::Progress;
use crate::memory::MemorySettings;
use crate::picture::Picture;
use crate::plan::{MovingPlan, Plan};
use crate::scene::Scene;
use crate::shading;
use crate::splat::depth_memory::Depths;
use crate::splat::encode::EncodedFrame;
use crate::splat::machine::Machine;
use crate::splat::{Fates, RenderEngine, RenderError, RenderSession, RenderedFrame, SplatCore, SplatOutcome};
use crate::waveform::Waveform;
use pointcore_golden::reference::motion::{Exposure, Method};
use pointcore_tb::lockstep::Stall;
use pointcore_tb::verilated::Trace;

/// What a scene exposes.
pub struct ExposedFrame {
    /// Light and coverage, sample by sample.
    pub exposure: Exposure,
    /// The same over the scene's background.
    pub picture: Picture,
    /// What became of the splats that move, or parts of their ways.
    pub fates: Fates,
    /// Their run: what it counted, and the fragments as the hardware encodes them.
    pub outcome: SplatOutcome,
    /// What stands still, if anything does.
    pub still: Option<RenderedFrame>,
}

/// A scene that moves while the shutter is open, and the cores that draw it: one with bins of the exposure for what moves, and one without for what
/// stands still.
pub struct MovingSession {
    scene: Scene,
    plan: Plan,
    machine: Machine,
    still: Option<RenderSession>,
}

impl MovingSession {
    /// Derives the hardware that a scene calls for, generates it, and verilates it if it is to run.
    ///
    /// # Errors
    /// The scene's overrides do not go with it, there is no such hardware, or tools are missing or fail.
    pub fn open(scene: Scene, engine: RenderEngine) -> Result<Self, RenderError> {
        let plan = MovingPlan::of(&scene)?;
        Self::on(scene, plan, engine, Trace::Off)
    }

    /// As [`MovingSession::open`], on the hardware of a plan for this scene; with a trace, that of what moves can write waveforms.
    ///
    /// # Errors
    /// Tools are missing or fail.
    pub fn on(scene: Scene, plan: MovingPlan, engine: RenderEngine, trace: Trace) -> Result<Self, RenderError> {
        let MovingPlan { moving: plan, still } = plan;
        let machine = Machine::new(&plan.config, engine, trace)?;
        let parts = scene.still_part().zip(still);
        let still = parts.map(|(scene, plan)| RenderSession::on(scene, plan, engine, Trace::Off)).transpose()?;
        Ok(Self { scene, plan, machine, still })
    }

    /// Holds streams back at random, and chooses the hardware's uninitialized values.
    #[must_use]
    pub fn randomized(self, stall: Stall, seed: u64) -> Self {
        let still = self.still.map(|still| still.randomized(stall, seed));
        Self { machine: self.machine.randomized(stall, seed), still, ..self }
    }

    /// Has the reconstruction buffers answer otherwise.
    ///
    /// # Errors
    /// No memory answers so.
    pub fn behind(self, memory: MemorySettings) -> Result<Self, RenderError> {
        let still = self.still.map(|still| still.behind(memory)).transpose()?;
        Ok(Self { machine: self.machine.behind(memory)?, still, ..self })
    }

    /// The memory that holds a reconstruction buffer.
    #[must_use]
    pub const fn memory(&self) -> &MemorySettings {
        &self.machine.memory
    }

    /// The scene.
    #[must_use]
    pub const fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The plan of what moves.
    #[must_use]
    pub const fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The core for what moves.
    #[must_use]
    pub const fn core(&self) -> &SplatCore {
        &self.machine.core
    }

    /// What stands still, with its hardware.
    #[must_use]
    pub const fn still(&self) -> Option<&RenderSession> {
        self.still.as_ref()
    }

    /// Exposes the scene.
    ///
    /// # Errors
    /// Hardware and model differ; a core is stuck.
    pub fn frame(&mut self) -> Result<ExposedFrame, RenderError> {
        self.frame_with(&|_, _| {}, None)
    }

    /// As [`MovingSession::frame`], and tells of the progress of what moves; hardware alone writes a waveform of that to a path.
    ///
    /// # Errors
    /// As [`MovingSession::frame`].
    pub fn frame_with(&mut self, progress: Progress, waveform: Option<&Waveform>) -> Result<ExposedFrame, RenderError> {
        let still = self.still.as_mut().map(|still| still.frame(0)).transpose()?;
        let (scene, plan) = (&self.scene, &self.plan);
        let depths =
            |still: &RenderedFrame| Depths::of_fragments(&plan.config, still.samples.width, &still.samples.pixels);
        let depths = still.as_ref().map(depths);
        let frame = EncodedFrame { depths, ..EncodedFrame::new(scene, plan) };
        let outcome = self.machine.run(&frame, progress, waveform)?;
        let exposure = expose(scene, plan, &outcome.fragments, still.as_ref().map(|still| &still.samples));
        let picture = shading::exposed(&exposure, scene);
        Ok(ExposedFrame { exposure, picture, fates: Fates::of(&plan.config, &frame), outcome, still })
    }

    /// The scene exposed in f64, by as many bins as the hardware has.
    #[must_use]
    pub fn reference(&self) -> Exposure {
        let bins = Method::Bins(self.plan.config.time_bins as usize);
        by_method(&self.scene, &self.scene.moving_splats(), bins, &|| ())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::{Effect, EffectExtent};
    use crate::splat::SplatRunner;
    use std::path::Path;

    /// Hardware sums in fewer bits, takes the depth of a bin from its ends, and counts the filter's weight beside the splat's where both lie.
    const PSNR_DB: f64 = 45.0;

    fn scene(name: &str) -> Scene {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/motion")).join(name);
        let changes = ["image.width=64", "image.height=64"].map(str::to_owned);
        Scene::load(&path.with_extension("toml"), &changes).unwrap_or_else(|error| panic!("{error}"))
    }

    #[test]
    fn hardware_exposes_what_bins_in_f64_do() {
        for name in ["translation", "rotation", "uncover"] {
            let session = MovingSession::open(scene(name), RenderEngine::Golden);
            let mut session = session.unwrap_or_else(|error| panic!("{error}"));
            let frame = session.frame().unwrap_or_else(|error| panic!("{error}"));
            let psnr_db = frame.picture.psnr_db(&shading::exposed(&session.reference(), session.scene()));
            println!(
                "{name}: {psnr_db:.1} dB, {} splats, {} cycles",
                frame.fates.total(),
                frame.outcome.simulated_cycles
            );
            assert!(psnr_db > PSNR_DB, "{name}: {psnr_db} dB");
            assert_eq!(frame.still.is_some(), name == "uncover");
        }
    }

    #[test]
    fn no_bit_hangs_on_planes_that_are_left_out() {
        let scene = scene("uncover");
        let plan = MovingPlan::of(&scene).unwrap_or_else(|error| panic!("{error}")).moving;
        assert!(!plan.config.eye_plane.is_on());
        let fragments = [EffectExtent::Least, EffectExtent::Most].map(|extent| {
            let plan = plan.at(Effect::EyePlane, extent);
            let core = SplatCore::generate(&plan.config).unwrap_or_else(|error| panic!("{error}"));
            let frame = EncodedFrame::new(&scene, &plan);
            let outcome = SplatRunner::new(&plan.config, &frame).golden(&core);
            let mut fragments = outcome.unwrap_or_else(|error| panic!("{error}")).fragments;
            // Tiles leave in any order.
            fragments.sort_by_key(|fragment| (fragment.row, fragment.column, fragment.seen.bin));
            fragments
        });
        assert!(!fragments[0].is_empty() && fragments[0] == fragments[1]);
    }
}
