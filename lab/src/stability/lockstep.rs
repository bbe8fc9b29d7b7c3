//! Hard cases through the generated hardware, in lockstep with its model.

use super::frames::{FRAME_SPLATS, config, frame};
use crate::note;
use crate::{Figures, LabError};
use pointcore::generated::verilate;
use pointcore::splat::{SplatCore, SplatRunner};
use pointcore_contract::splat::Config;
use pointcore_tb::lockstep::Stall;
use pointcore_tb::verilated::{Library, Trace};
use std::sync::Arc;

/// Share of the cycles in which streams are held back.
const STALL_SHARE: f64 = 0.2;

/// The hardware that such frames are sent through.
pub struct FrameCheck {
    config: Config,
    core: SplatCore,
    library: Arc<Library>,
}

impl FrameCheck {
    /// Generates and verilates it.
    ///
    /// # Errors
    /// A fault of the generator, or a tool is missing or fails.
    pub fn build() -> Result<Self, LabError> {
        let config = config();
        let core = SplatCore::generate(&config)?;
        let library = verilate(&core.design, Trace::Off)?;
        Ok(Self { config, core, library })
    }

    /// Runs so many splats, frame by frame, every output compared in every cycle under stalls, and fragments with those of the model
    /// without.
    ///
    /// # Errors
    /// Hardware and model differ.
    pub fn figures(&self, splats: u64, seed: u64, figures: &mut Figures) -> Result<(), LabError> {
        let Self { config, core, library } = self;
        let (mut cycles, mut timing_differences) = (0, 0_u64);
        let frames = splats.div_ceil(FRAME_SPLATS);
        for index in 0..frames {
            note!("hardware: frame {} of {frames}", index + 1);
            let first = index * FRAME_SPLATS;
            let frame = frame(config, first, FRAME_SPLATS.min(splats - first), seed);
            let (stall, seed) = (Stall::Random(STALL_SHARE), seed + index);
            let stalled = SplatRunner { stall, seed, ..SplatRunner::new(config, &frame) };
            // A difference ends the run.
            let outcome = stalled.lockstep(core, library)?;
            let free = SplatRunner { stall: Stall::Never, ..stalled }.golden(core)?;
            cycles += outcome.simulated_cycles;
            timing_differences += u64::from(free.fragments != outcome.fragments);
        }
        figures.insert("stability.rtl_cases".to_owned(), splats.into());
        figures.insert("stability.rtl_cycles".to_owned(), cycles.into());
        figures.insert("stability.timing_differences".to_owned(), timing_differences.into());
        Ok(())
    }
}
