//! What generated hardware of either core goes through: faults of the generator, a build for speed, and
//! news of a run.

use pointcore_hdl::compiler::CompileError;
use pointcore_tb::verilated::{Builder, Library, Optimization, Options, Source, Trace, VerilatedError};
use rtl::{Design, ElaborationError};
use std::sync::Arc;

/// The hardware could not be built: a fault of the generator, not of its input.
#[derive(Debug, thiserror::Error)]
pub enum GenerateError {
    /// A datapath.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// The module hierarchy.
    #[error(transparent)]
    Elaborate(#[from] ElaborationError),
}

/// Verilates a core, for speed.
///
/// # Errors
/// The tools are missing or fail.
pub fn verilate(design: &Design, trace: Trace) -> Result<Arc<Library>, VerilatedError> {
    Builder::new()?.build(&Source::from(design), Options { optimization: Optimization::Full, trace })
}

/// Hears of a run: the cycles so far, and the share of the work that has been sent.
pub type Progress<'a> = &'a (dyn Fn(u64, f64) + Sync);
