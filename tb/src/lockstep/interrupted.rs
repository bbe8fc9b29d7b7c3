//! Hardware in the middle of something, for a reset to end.

use std::sync::Arc;

use super::stimulus::{Flow, RESET_CYCLES, Stimulus};
use crate::verilated::{Library, Port, RESET, VerilatedError, VerilatedModel};

/// Cycles of the run that the reset ends, at most.
const LONGEST: u64 = 300;

/// Inputs of a reset cycle: `rst` high, everything else as good as any, for the reset not to care.
pub fn noisy_reset(library: &Library, seed: u64) -> Vec<u64> {
    let mut random = fastrand::Rng::with_seed(seed);
    let input = |port: &Port| if port.name == RESET { 1 } else { random.u64(..) >> (u64::BITS - port.width) };
    library.inputs().iter().map(input).collect()
}

/// Hardware in the middle of a run of `stimulus`, the same for the same `seed`; nothing of this run is compared.
pub fn interrupted(
    library: &Arc<Library>,
    seed: u64,
    mut stimulus: impl Stimulus,
) -> Result<VerilatedModel, VerilatedError> {
    let mut model = library.instantiate(seed);
    model.reset(RESET_CYCLES)?;
    let mut inputs = vec![0; library.inputs().len()];
    let mut outputs = vec![0; library.outputs().len()];
    for cycle in 0..fastrand::Rng::with_seed(seed).u64(1..=LONGEST) {
        if stimulus.drive(cycle, &outputs, &mut inputs) == Flow::Done {
            break;
        }
        match model.step(&inputs, &mut outputs) {
            Ok(()) => {}
            // The run proper comes to it, too, and says so.
            Err(VerilatedError::Stopped(_)) => return Ok(library.instantiate(seed)),
            Err(error) => return Err(error),
        }
    }
    Ok(model)
}
