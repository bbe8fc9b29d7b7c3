//! Why a unit could not be measured.

use super::convergence::Divergence;
use pointcore::generated::GenerateError;
use pointcore_tb::cache::FileError;
use std::path::PathBuf;

/// Why a unit could not be measured.
#[derive(Debug, thiserror::Error)]
pub enum SynthesisError {
    /// A tool is not there or too old.
    #[error(
        "`{tool}` {needed} or newer is neither on the search path nor in target/tools; install it with `make setup-fpga`"
    )]
    Missing {
        /// Its name.
        tool: &'static str,
        /// The oldest version that will do.
        needed: &'static str,
    },
    /// A tool stopped.
    #[error("{} failed on `{unit}`; its last lines:\n{output}", tool.display())]
    Tool {
        /// The program.
        tool: PathBuf,
        /// What it worked on.
        unit: String,
        /// What it said last.
        output: String,
    },
    /// No router comes to its end.
    #[error("`{unit}` cannot be routed with seed {seed}: {divergence}; choose a smaller configuration or another seed")]
    Unroutable {
        /// What was to be routed.
        unit: String,
        /// The seed.
        seed: u32,
        /// What the last router said.
        divergence: Divergence,
    },
    /// A target for which nothing is placed.
    #[error("nothing is placed for `{target}`: late paths are those of `ecp5` or `ice40`")]
    NotPlaced {
        /// The target.
        target: &'static str,
    },
    /// A tool's report could not be read.
    #[error("the tools' report on `{unit}` is not as expected: {problem}")]
    Report {
        /// What was measured.
        unit: String,
        /// What is wrong.
        problem: String,
    },
    /// The device has not enough of something.
    #[error(
        "`{unit}` takes {needed} {resource}, the {device} has {available}; choose a smaller configuration or another target"
    )]
    TooLarge {
        /// What was measured.
        unit: String,
        /// What there is not enough of.
        resource: &'static str,
        /// The device.
        device: &'static str,
        /// How many the unit takes.
        needed: u64,
        /// How many the device has.
        available: u64,
    },
    /// The hardware could not be generated.
    #[error("the hardware of `{unit}` could not be generated: {source}")]
    Generate {
        /// What was to be measured.
        unit: String,
        /// The generator's fault.
        source: GenerateError,
    },
    /// A file of the cache.
    #[error(transparent)]
    File(#[from] FileError),
}
