//! A generated core on an engine, and how its surroundings answer.

use super::encode::EncodedFrame;
use super::generate::SplatCore;
use super::memory::ReconstructionBuffer;
use super::run::{SplatOutcome, SplatRunner};
use super::session::{RenderEngine, RenderError};
use crate::generated::{Progress, verilate};
use crate::memory::MemorySettings;
use crate::waveform::Waveform;
use pointcore_contract::splat::Config;
use pointcore_tb::lockstep::{LockstepError, Stall};
use pointcore_tb::verilated::{Library, Trace};
use std::sync::Arc;

/// A core that frames are run on.
pub(super) struct Machine {
    pub core: SplatCore,
    config: Config,
    /// The verilated core, unless the golden model renders alone.
    library: Option<Arc<Library>>,
    engine: RenderEngine,
    pub memory: MemorySettings,
    stall: Stall,
    seed: u64,
}

impl Machine {
    pub fn new(config: &Config, engine: RenderEngine, trace: Trace) -> Result<Self, RenderError> {
        let core = SplatCore::generate(config)?;
        let library = if engine == RenderEngine::Golden { None } else { Some(verilate(&core.design, trace)?) };
        let (config, memory) = (config.clone(), ReconstructionBuffer::SETTINGS);
        Ok(Self { core, config, library, engine, memory, stall: Stall::Never, seed: 1 })
    }

    /// Holds streams back at random, and chooses the hardware's uninitialized values.
    pub fn randomized(self, stall: Stall, seed: u64) -> Self {
        Self { stall, seed, ..self }
    }

    /// Has its memories answer otherwise.
    pub fn behind(self, memory: MemorySettings) -> Result<Self, RenderError> {
        memory.validate()?;
        Ok(Self { memory, ..self })
    }

    /// Runs a frame; hardware alone writes a waveform of it to a path.
    pub fn run(
        &self,
        frame: &EncodedFrame,
        progress: Progress,
        waveform: Option<&Waveform>,
    ) -> Result<SplatOutcome, LockstepError> {
        let Self { memory, stall, seed, .. } = *self;
        let runner = SplatRunner { memory, stall, seed, progress, ..SplatRunner::new(&self.config, frame) };
        match (self.engine, &self.library) {
            (RenderEngine::Hardware, Some(library)) => runner.hardware(library, waveform),
            (RenderEngine::Lockstep, Some(library)) => runner.lockstep(&self.core, library),
            _ => runner.golden(&self.core),
        }
    }
}
