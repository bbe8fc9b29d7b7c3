//! Hardware and golden model, stepped side by side and compared in every output of every cycle.
//!
//! [`Lockstep::run`] is the one driver for unit tests (a [`StreamTestbench`] with random stalls) and for whole cores
//! (a [`Stimulus`] that plays memory and scene). The first difference, broken stream protocol or failed assertion ends
//! the run with a [`LockstepFailure`] that says where, and replays the last cycles into a waveform.

mod comparison;
mod driver;
mod failure;
mod fault;
mod four_state;
mod interrupted;
mod protocol;
mod replay;
mod seed;
mod stall;
mod stimulus;
mod stream;
mod testbench;

pub use driver::{Lockstep, LockstepReport, Run};
pub use failure::{Cause, LockstepError, LockstepFailure, PortDifference, ProtocolViolation, Waveform};
pub use fault::inject;
pub use four_state::{FourStateError, Recorded};
pub use seed::{SEED_VARIABLE, seed, seeds};
pub use stall::{Stall, Stalls};
pub use stimulus::{Flow, Golden, RESET_CYCLES, Stimulus};
pub use stream::{StreamPorts, Streams};
pub use testbench::{StreamTestbench, TestbenchError};
