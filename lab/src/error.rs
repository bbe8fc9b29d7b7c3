//! Why something could not be measured.

use crate::mutation::MutationError;
use crate::synthesis::SynthesisError;
use pointcore::configuration::ConfigurationError;
use pointcore::cost::CostError;
use pointcore::generated::GenerateError;
use pointcore::picture::PictureError;
use pointcore::plan::PlanError;
use pointcore::process::ProcessError;
use pointcore::scene::SceneError;
use pointcore::search::{SearchError, WrongAnswer};
use pointcore::splat::RenderError;
use pointcore_tb::cache::FileError;
use pointcore_tb::lockstep::LockstepError;
use pointcore_tb::verilated::VerilatedError;
use rtl::ElaborationError;
use std::path::PathBuf;

/// Why something could not be measured.
#[derive(Debug, thiserror::Error)]
pub enum LabError {
    /// The scene, or what a setting makes of it.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The hardware that a setting asks for.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// A configuration, or a record of areas.
    #[error(transparent)]
    Configuration(#[from] ConfigurationError),
    /// A fault of the generator.
    #[error("the hardware could not be generated: {0}")]
    Generate(#[from] GenerateError),
    /// Verilator, the compiler, or an assertion in the hardware.
    #[error(transparent)]
    Verilated(#[from] VerilatedError),
    /// Hardware and model differ, or the run did not end.
    #[error(transparent)]
    Lockstep(#[from] LockstepError),
    /// A scene that is not rendered.
    #[error(transparent)]
    Render(RenderError),
    /// An operator on neighborhoods.
    #[error(transparent)]
    Process(#[from] ProcessError),
    /// A fluid that nobody has seen.
    #[error("{0}")]
    Unphysical(String),
    /// A neighbor search.
    #[error(transparent)]
    Search(#[from] SearchError),
    /// Neighbors that are not the nearest, as far as they may differ.
    #[error("{0}")]
    Neighbors(WrongAnswer),
    /// Synthesis, place and route.
    #[error(transparent)]
    Synthesis(#[from] SynthesisError),
    /// Mutants of the Verilog.
    #[error(transparent)]
    Mutation(#[from] MutationError),
    /// A picture that cannot be written.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// A file of the cache, or of results.
    #[error(transparent)]
    File(#[from] FileError),
    /// A kept result that is none of ours.
    #[error("{}: {problem}; delete it to measure the point again", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        problem: String,
    },
}

impl From<ElaborationError> for LabError {
    fn from(error: ElaborationError) -> Self {
        Self::Generate(error.into())
    }
}

impl From<RenderError> for LabError {
    fn from(error: RenderError) -> Self {
        match error {
            RenderError::Plan(error) => error.into(),
            RenderError::Generate(error) => error.into(),
            RenderError::Verilated(error) => error.into(),
            RenderError::Lockstep(error) => error.into(),
            other => Self::Render(other),
        }
    }
}

impl From<CostError> for LabError {
    fn from(error: CostError) -> Self {
        match error {
            CostError::Generate(error) => Self::Generate(error),
            CostError::Run(error) => Self::Lockstep(error),
        }
    }
}
