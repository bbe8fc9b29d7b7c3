//! Why mutants could not be tried.

use crate::synthesis::SynthesisError;
use pointcore::configuration::ConfigurationError;
use pointcore::generated::GenerateError;
use pointcore_tb::cache::FileError;

/// Why mutants could not be tried.
#[derive(Debug, thiserror::Error)]
pub enum MutationError {
    /// yosys is missing, or refused a design.
    #[error(transparent)]
    Synthesis(#[from] SynthesisError),
    /// A file could not be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A record or a package that is none of ours.
    #[error(transparent)]
    Configuration(#[from] ConfigurationError),
    /// A package's hardware cannot be generated anew.
    #[error(transparent)]
    Generate(#[from] GenerateError),
    /// A program that could not be started, or failed where it must not.
    #[error("{program} failed:\n{output}")]
    Program {
        /// The program.
        program: String,
        /// What it printed last.
        output: String,
    },
    /// No such unit.
    #[error("no test of hardware is called `{name}`: expected one of {known}")]
    Unknown {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// The record has no score of these mutants.
    #[error(
        "the record has no score of these mutants of {name}: expected one of the same Verilog, `--mutants` and `--seed`"
    )]
    NotRecorded {
        /// The unit or configuration.
        name: String,
    },
    /// A test that fails without a mutant tells nothing.
    #[error("{name}: the test fails on the Verilog as it is:\n{output}")]
    Baseline {
        /// The unit or configuration.
        name: String,
        /// What it said.
        output: String,
    },
}
