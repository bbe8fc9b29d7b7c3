//! What generated hardware of any core goes through: faults of the generator, a build for speed, and
//! news of a run.

use crate::configuration::Configuration;
use pointcore_hdl::compiler::{CompileError, Options};
use pointcore_hdl::{points, search, splat};
use pointcore_tb::verilated::{BuildOptions, Builder, Library, Optimization, Trace, VerilatedError, VerilogSource};
use rtl::{Design, ElaborationError, Module};
use std::rc::Rc;
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

impl Configuration {
    /// The module of the whole core.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn module(&self) -> Result<Rc<Module>, GenerateError> {
        let options = Options::default();
        Ok(match self {
            Self::Splat(config) => splat::top::core(config, &options)?.module.into(),
            Self::Search(config) => search::top::core(config, &options)?.module.into(),
            Self::Points(config) => points::top::core(config, &options)?.module.into(),
        })
    }
}

/// Verilates a core, for speed.
///
/// # Errors
/// The tools are missing or fail.
pub fn verilate(design: &Design, trace: Trace) -> Result<Arc<Library>, VerilatedError> {
    Builder::new()?.build(&VerilogSource::from(design), BuildOptions { optimization: Optimization::OF_CORES, trace })
}

/// Hears of a run: the cycles so far, and the share of the work that has been sent.
pub type Progress<'a> = &'a (dyn Fn(u64, f64) + Sync);
