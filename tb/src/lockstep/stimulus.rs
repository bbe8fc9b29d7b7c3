//! What drives the inputs, and what says how the outputs must be.

/// Cycles of reset before a run: one edge is enough. Their outputs are not compared.
pub const RESET_CYCLES: u64 = 1;

/// A bit-exact model of a unit. Words are in the order of the hardware's ports, the clock left out.
pub trait Golden {
    /// One cycle: writes the outputs of the present state, then takes the rising edge with `inputs`.
    fn step(&mut self, inputs: &[u64], outputs: &mut [u64]);
}

impl<F: FnMut(&[u64], &mut [u64])> Golden for F {
    fn step(&mut self, inputs: &[u64], outputs: &mut [u64]) {
        self(inputs, outputs);
    }
}

/// Whether a stimulus has more to say.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flow {
    /// The inputs are set; run the cycle.
    Continue,
    /// The run is over; do not run this cycle.
    Done,
}

/// Everything around the hardware: sources, sinks, memories. It reacts to the hardware and must do so the same way each
/// time: a failing run is replayed from a clone of its initial state.
pub trait Stimulus {
    /// Sets the inputs of `cycle` (counted from the end of the reset). On entry `inputs` holds the inputs and `outputs`
    /// the outputs of the cycle before: a transfer took place there where both `valid` and `ready` are high.
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow;
}

impl<F: FnMut(u64, &[u64], &mut [u64]) -> Flow> Stimulus for F {
    fn drive(&mut self, cycle: u64, outputs: &[u64], inputs: &mut [u64]) -> Flow {
        self(cycle, outputs, inputs)
    }
}
