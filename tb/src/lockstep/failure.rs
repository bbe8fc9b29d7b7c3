//! What a failed run says.

use std::fmt;
use std::path::PathBuf;

use super::testbench::TestbenchError;
use crate::verilated::VerilatedError;

/// Why a run did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum LockstepError {
    /// The hardware is wrong, or its model is.
    #[error("{0}")]
    Failed(Box<LockstepFailure>),
    /// Nothing was transferred, so nothing was tested.
    #[error("no transaction in {cycles} cycles on {streams}: nothing was compared (seed {seed})")]
    NoTransaction {
        /// Cycles run.
        cycles: u64,
        /// The streams that should have moved.
        streams: String,
        /// Seed of the run.
        seed: u64,
    },
    /// The stimulus had not finished after so many cycles of a run on one side alone.
    #[error("not finished after {cycles} cycles (seed {seed})")]
    Unfinished {
        /// Cycles run.
        cycles: u64,
        /// Seed of the run.
        seed: u64,
    },
    /// The model could not be built or loaded.
    #[error(transparent)]
    Verilated(#[from] VerilatedError),
    /// The testbench does not fit the hardware.
    #[error(transparent)]
    Testbench(#[from] TestbenchError),
    /// The environment's seed is not a number.
    #[error("POINTCORE_SEED is `{text}`; give a number such as 17 or 0x11")]
    Seed {
        /// What it is.
        text: String,
    },
    /// A fault cannot be injected because the text is not as expected.
    #[error("cannot replace `{from}` in the line of `{line}`: {reason}")]
    Fault {
        /// What names the line.
        line: String,
        /// What was to be replaced.
        from: String,
        /// Why not.
        reason: &'static str,
    },
}

/// The first thing that went wrong, and how to see it again.
#[derive(Debug)]
pub struct LockstepFailure {
    /// Top module.
    pub top: String,
    /// Cycle, counted from the end of the reset.
    pub cycle: u64,
    /// What went wrong.
    pub cause: Cause,
    /// The inputs of that cycle by port.
    pub inputs: Vec<(String, u64)>,
    /// Seed of the run.
    pub seed: u64,
    /// The command that runs it again.
    pub reproduce: String,
    /// The signals of the last cycles.
    pub waveform: Waveform,
}

/// What went wrong.
#[derive(Debug)]
pub enum Cause {
    /// Outputs differ.
    Mismatch(Vec<PortDifference>),
    /// A stream broke its protocol.
    Protocol(ProtocolViolation),
    /// The hardware stopped itself; what it said.
    Stopped(String),
    /// The stimulus had not finished after so many cycles.
    Unfinished,
}

/// An output on which hardware and model disagree.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PortDifference {
    /// The port.
    pub port: String,
    /// What the hardware says.
    pub hardware: u64,
    /// What the model says.
    pub golden: u64,
}

/// A broken promise of a stream.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ProtocolViolation {
    /// `valid` fell before the transfer.
    Withdrawn {
        /// The stream.
        stream: String,
    },
    /// Data changed before the transfer.
    Changed {
        /// The stream.
        stream: String,
    },
}

/// The waveform of a failure.
#[derive(Debug)]
pub enum Waveform {
    /// It shows the failure in its last cycle.
    Written(PathBuf),
    /// The replay came to other outputs: the hardware depends on values that nothing initialized.
    Diverged(PathBuf),
    /// It could not be written.
    Unavailable(VerilatedError),
}

impl fmt::Display for LockstepFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} in cycle {}: {}", self.top, self.cycle, self.cause)?;
        write!(f, "  inputs:")?;
        for (port, value) in &self.inputs {
            write!(f, " {port}={value:#x}")?;
        }
        writeln!(f, "\n  waveform: {}", self.waveform)?;
        writeln!(f, "  seed: {}", self.seed)?;
        write!(f, "  reproduce: {}", self.reproduce)
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mismatch(differences) => {
                write!(f, "hardware and model differ")?;
                for PortDifference { port, hardware, golden } in differences {
                    write!(f, "\n  {port}: hardware {hardware:#x}, model {golden:#x}")?;
                }
                Ok(())
            }
            Self::Protocol(ProtocolViolation::Withdrawn { stream }) => {
                write!(f, "{stream}_valid fell before {stream}_ready took the item")
            }
            Self::Protocol(ProtocolViolation::Changed { stream }) => {
                write!(f, "the fields of {stream} changed before {stream}_ready took the item")
            }
            Self::Stopped(text) => write!(f, "the hardware stopped: {text}"),
            Self::Unfinished => write!(f, "the stimulus is still waiting; raise the limit or look for a deadlock"),
        }
    }
}

impl fmt::Display for Waveform {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Written(path) => write!(f, "{}", path.display()),
            Self::Diverged(path) => {
                write!(f, "{} (differs from the run: the hardware depends on uninitialized values)", path.display())
            }
            Self::Unavailable(error) => write!(f, "none: {error}"),
        }
    }
}
