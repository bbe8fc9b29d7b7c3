//! The same run once more, hardware only, with a waveform of its last cycles.

use std::path::PathBuf;
use std::sync::Arc;

use super::comparison::Comparison;
use super::failure::Waveform;
use super::interrupted::{interrupted, noisy_reset};
use super::stimulus::{Flow, RESET_CYCLES, Stimulus};
use crate::cache::kept;
use crate::verilated::{Library, VerilatedError, substitute};

/// Where and how a run failed.
pub struct Replay<'a> {
    pub library: &'a Arc<Library>,
    pub seed: u64,
    /// The cycle that failed.
    pub cycle: u64,
    /// The hardware's outputs in that cycle.
    pub outputs: &'a [u64],
    /// Which of them matter.
    pub comparison: &'a mut Comparison,
    /// Cycles to record, up to and with the failing one.
    pub recorded: u64,
}

impl Replay<'_> {
    /// Runs `stimulus` from its beginning up to the failing cycle.
    pub fn run(mut self, stimulus: impl Stimulus + Clone) -> Waveform {
        self.record(stimulus).unwrap_or_else(Waveform::Unavailable)
    }

    fn record(&mut self, mut stimulus: impl Stimulus + Clone) -> Result<Waveform, VerilatedError> {
        let path = self.path()?;
        if substitute::are_asked_for() {
            return Err(VerilatedError::Waveform { path, reason: "substitutes are run without" });
        }
        let mut model = interrupted(&self.library.traced()?, self.seed, stimulus.clone())?;
        let mut inputs = noisy_reset(self.library, self.seed);
        let mut outputs = vec![0; self.library.outputs().len()];
        let first = (RESET_CYCLES + self.cycle + 1).saturating_sub(self.recorded);
        for step in 0..=RESET_CYCLES + self.cycle {
            if step == first {
                model.open_trace(&path)?;
            }
            if step == RESET_CYCLES {
                inputs.fill(0);
            }
            if step >= RESET_CYCLES && stimulus.drive(step - RESET_CYCLES, &outputs, &mut inputs) == Flow::Done {
                return Ok(Waveform::Diverged(path));
            }
            match model.step(&inputs, &mut outputs) {
                // The failure may be that the hardware stopped, so that is no reason not to have a waveform.
                Ok(()) | Err(VerilatedError::Stopped(_)) => {}
                Err(error) => return Err(error),
            }
        }
        let is_same = self.comparison.agree(&outputs, self.outputs);
        Ok(if is_same { Waveform::Written(path) } else { Waveform::Diverged(path) })
    }

    /// A file beside the cached builds; its name says which run it is of.
    fn path(&self) -> Result<PathBuf, VerilatedError> {
        let folder = self.library.cache().join("waveforms");
        std::fs::create_dir_all(&folder).map_err(kept("create", &folder))?;
        let name = format!(
            "{}_{}_seed{}_cycle{}.fst",
            self.library.source().top,
            self.library.digest(),
            self.seed,
            self.cycle
        );
        Ok(folder.join(name))
    }
}
