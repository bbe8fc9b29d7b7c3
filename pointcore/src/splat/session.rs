//! Rendering as a library: a scene in, frames of typed fragments out, one or a sequence.

use super::encode::EncodedFrame;
use super::fates::Fates;
use super::frame::assemble;
use super::generate::SplatCore;
use super::machine::Machine;
use super::run::SplatOutcome;
use crate::generated::{GenerateError, Progress};
use crate::memory::{MemoryError, MemorySettings};
use crate::picture::Picture;
use crate::plan::{Plan, PlanError};
use crate::scene::Scene;
use crate::shading;
use crate::triangles::Layer;
use crate::waveform::Waveform;
use pointcore_contract::surface::{COLOR, NORMAL};
use pointcore_golden::reference::{self, Fragment, Frame, Mapping};
use pointcore_tb::lockstep::{LockstepError, Stall};
use pointcore_tb::verilated::{Trace, VerilatedError};

/// What renders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RenderEngine {
    /// The bit-exact, cycle-accurate golden model.
    Golden,
    /// The generated Verilog under Verilator.
    Hardware,
    /// Both, every output compared in every cycle.
    Lockstep,
}

/// Why nothing was rendered.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// The hardware that the scene asks for.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// A fault of the generator.
    #[error("the hardware could not be generated: {0}")]
    Generate(#[from] GenerateError),
    /// Verilator, the compiler, or an assertion in the hardware.
    #[error(transparent)]
    Verilated(#[from] VerilatedError),
    /// Hardware and model differ, or a frame did not end.
    #[error(transparent)]
    Lockstep(#[from] LockstepError),
    /// A memory that there is not.
    #[error(transparent)]
    Memory(#[from] MemoryError),
    /// A frame beyond the end of the sequence.
    #[error("frame {index} is not among the {frames} of the sequence, which count from 0")]
    Frame {
        /// The frame asked for.
        index: usize,
        /// The frames of the sequence.
        frames: usize,
    },
}

/// A reconstructed sample of the surface, as the hardware puts it out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameFragment {
    /// Column of the sample, from the left.
    pub column: usize,
    /// Row of the sample, from the top.
    pub row: usize,
    /// Distance from the eye's plane along the viewing direction, in the scene's units.
    pub depth: f64,
    /// World-space normal, of a length up to one: opposite ones cancel. Zero in a scene without directed light, which carries none.
    pub normal: [f32; 3],
    /// Linear RGB.
    pub color: [f32; 3],
    /// Index of the material.
    pub material: u16,
}

/// A frame.
pub struct RenderedFrame {
    /// Its fragments, row by row, none where there is no splat, or where a triangle hides it.
    pub fragments: Vec<FrameFragment>,
    /// The fragments shaded, on the scene's background.
    pub picture: Picture,
    /// What became of the splats.
    pub fates: Fates,
    /// What the run counted, and the fragments as the hardware encodes them.
    pub outcome: SplatOutcome,
    /// The fragments by sample, as the f64 reference has them.
    pub samples: Frame,
}

/// A scene and the core that renders it, kept from frame to frame.
///
/// ```
/// use pointcore::scene::{Disc, Scene};
/// use pointcore::splat::{RenderEngine, RenderSession};
///
/// let red = |x: u8| Disc::new([f64::from(x), 0.0, 0.0].into(), [0.0, 0.0, 1.0].into(), 0.8).colored([1.0, 0.0, 0.0]);
/// let scene = Scene::of((0..5).map(red).collect()).image(48, 16).camera([2.0, 0.0, 9.0], [2.0, 0.0, 0.0], 14.0).turntable(2);
/// let mut session = RenderSession::open(scene.build()?, RenderEngine::Golden)?;
/// let frames = session.sequence().collect::<Result<Vec<_>, _>>()?;
/// let middle = frames[0].fragments.iter().find(|fragment| (fragment.column, fragment.row) == (24, 8)).expect("a disc lies there");
/// assert!((middle.depth - 9.0).abs() < 0.01 && middle.normal[2] > 0.99 && middle.color[0] > 0.99);
/// assert_eq!((frames.len(), frames[1].fates.facing), (2, 5), "from behind all discs face away");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct RenderSession {
    scene: Scene,
    plan: Plan,
    machine: Machine,
}

impl RenderSession {
    /// Derives the hardware that a scene calls for in all its frames, generates it, and verilates it if it is to run.
    ///
    /// # Errors
    /// The scene's overrides do not go with it, or tools are missing or fail.
    pub fn open(scene: Scene, engine: RenderEngine) -> Result<Self, RenderError> {
        let plan = Plan::of(&scene)?;
        Self::on(scene, plan, engine, Trace::Off)
    }

    /// As [`RenderSession::open`], on the hardware of a plan for this scene; with a trace, the hardware can write waveforms.
    ///
    /// # Errors
    /// Tools are missing or fail.
    pub fn on(scene: Scene, plan: Plan, engine: RenderEngine, trace: Trace) -> Result<Self, RenderError> {
        let machine = Machine::new(&plan.config, engine, trace)?;
        Ok(Self { scene, plan, machine })
    }

    /// Holds streams back at random, and chooses the hardware's uninitialized values.
    #[must_use]
    pub fn randomized(self, stall: Stall, seed: u64) -> Self {
        Self { machine: self.machine.randomized(stall, seed), ..self }
    }

    /// Has the reconstruction buffer answer otherwise.
    ///
    /// # Errors
    /// No memory answers so.
    pub fn behind(self, memory: MemorySettings) -> Result<Self, RenderError> {
        Ok(Self { machine: self.machine.behind(memory)?, ..self })
    }

    /// The memory that holds the reconstruction buffer.
    #[must_use]
    pub const fn memory(&self) -> &MemorySettings {
        &self.machine.memory
    }

    /// The scene, as of the frame rendered last.
    #[must_use]
    pub const fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The hardware's plan.
    #[must_use]
    pub const fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The core.
    #[must_use]
    pub const fn core(&self) -> &SplatCore {
        &self.machine.core
    }

    /// Frames of the sequence.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.scene.views.len()
    }

    /// Renders a frame of the sequence.
    ///
    /// # Errors
    /// There is no such frame; hardware and model differ; the core is stuck.
    pub fn frame(&mut self, index: usize) -> Result<RenderedFrame, RenderError> {
        self.frame_with(index, &|_, _| {}, None)
    }

    /// As [`RenderSession::frame`], and tells of the progress; hardware alone writes a waveform of the run to a path.
    ///
    /// # Errors
    /// As [`RenderSession::frame`].
    pub fn frame_with(
        &mut self,
        index: usize,
        progress: Progress,
        waveform: Option<&Waveform>,
    ) -> Result<RenderedFrame, RenderError> {
        let view = self.scene.views.get(index).cloned();
        self.scene.look(&view.ok_or(RenderError::Frame { index, frames: self.frames() })?);
        let (scene, plan) = (&self.scene, &self.plan);
        let frame = EncodedFrame::new(scene, plan);
        let outcome = self.machine.run(&frame, progress, waveform)?;
        let samples = assemble(plan, &outcome.fragments);
        let (fragments, picture) = (fragments(scene, &samples), shading::picture(&samples, scene));
        Ok(RenderedFrame { fragments, picture, fates: Fates::of(&plan.config, &frame), outcome, samples })
    }

    /// Renders all frames, one after the other.
    pub fn sequence(&mut self) -> impl Iterator<Item = Result<RenderedFrame, RenderError>> + '_ {
        (0..self.frames()).map(|index| self.frame(index))
    }

    /// The frame rendered last, by the f64 reference.
    #[must_use]
    pub fn reference(&self) -> Frame {
        reference(&self.scene, Mapping::Backward)
    }
}

/// The splats of a still scene by the f64 reference, as far as neither triangles nor nearer surfaces hide them.
#[must_use]
pub fn reference(scene: &Scene, mapping: Mapping) -> Frame {
    let Scene { splats, camera, rendering, surfaces, .. } = scene;
    let mut frame = match &surfaces[..] {
        [] => reference::render(splats, camera, rendering, mapping),
        surfaces => {
            let frames =
                surfaces.iter().map(|span| reference::render(&splats[span.clone()], camera, rendering, mapping));
            frames.reduce(nearer).expect("there is a surface")
        }
    };
    if let Some(triangles) = Layer::of(scene) {
        triangles.hide(&mut frame);
    }
    frame
}

/// Of each sample the nearer of two surfaces, the first if they are as near; how far they are apart is a margin of its depth test.
fn nearer(mut first: Frame, second: Frame) -> Frame {
    let Frame { pixels, decisions, margins, statistics, .. } = second;
    for (place, new) in pixels.into_iter().enumerate() {
        let Some(new) = new else { continue };
        let apart = first.pixels[place].as_ref().map_or(f64::INFINITY, |old| old.depth - new.depth);
        if apart > 0.0 {
            first.pixels[place] = Some(new);
            (first.decisions[place], first.margins[place]) = (decisions[place], margins[place]);
        }
        let margin = &mut first.margins[place].depth;
        *margin = margin.min(apart.abs());
    }
    first.statistics = first.statistics + statistics;
    first
}

fn fragments(scene: &Scene, samples: &Frame) -> Vec<FrameFragment> {
    let camera = &scene.camera;
    let three = |values: &[f64]| [0, 1, 2].map(|i| values[i] as f32);
    let placed = samples.pixels.iter().enumerate().filter_map(|(index, fragment)| Some((index, fragment.as_ref()?)));
    let fragment = |(index, fragment): (usize, &Fragment)| FrameFragment {
        column: index % samples.width,
        row: index / samples.width,
        depth: scene.placement.unit * camera.depth_b / (fragment.depth - camera.depth_a),
        normal: three(&fragment.attributes[NORMAL]),
        color: three(&fragment.attributes[COLOR]),
        material: fragment.material,
    };
    placed.map(fragment).collect()
}
