//! Exit codes: 1 where hardware, models or records disagree, 2 where the input is wrong or a result cannot be written, 3 where a tool is missing
//! or fails.

use crate::commands::Failure;
use pointcore::search::SearchError;
use pointcore::vectors::VectorsError;
use pointcore_lab::LabError;
use pointcore_lab::synthesis::SynthesisError;
use std::process::ExitCode;

const DISAGREEMENT: u8 = 1;
const INPUT: u8 = 2;
const TOOL: u8 = 3;

/// The code of a failure.
pub fn code(failure: &Failure) -> ExitCode {
    ExitCode::from(match failure {
        Failure::Mismatch(_) | Failure::Neighbors(_) | Failure::Stale { .. } => DISAGREEMENT,
        Failure::Generate(_) | Failure::Package(_) | Failure::Verilated(_) => TOOL,
        Failure::Scene(_)
        | Failure::Plan { .. }
        | Failure::Excluded { .. }
        | Failure::Configuration(_)
        | Failure::Usage(_)
        | Failure::Write { .. }
        | Failure::Picture(_) => INPUT,
        Failure::Search(error) => search(error),
        Failure::Vectors(error) => vectors(error),
        Failure::Lab(error) => lab(error),
    })
}

const fn search(error: &SearchError) -> u8 {
    match error {
        SearchError::Lockstep(_) | SearchError::Stuck { .. } => DISAGREEMENT,
        SearchError::Generate(_) | SearchError::Verilated(_) => TOOL,
        _ => INPUT,
    }
}

const fn vectors(error: &VectorsError) -> u8 {
    match error {
        VectorsError::Frame(_) => DISAGREEMENT,
        VectorsError::Generate(_) => TOOL,
        VectorsError::Search(error) => search(error),
        VectorsError::Base(_) | VectorsError::Space { .. } | VectorsError::Numbers { .. } => INPUT,
    }
}

const fn lab(error: &LabError) -> u8 {
    match error {
        LabError::Lockstep(_) | LabError::Neighbors(_) => DISAGREEMENT,
        LabError::Search(error) => search(error),
        LabError::Synthesis(SynthesisError::TooLarge { .. }) => INPUT,
        LabError::Generate(_) | LabError::Verilated(_) | LabError::Synthesis(_) => TOOL,
        LabError::Scene(_)
        | LabError::Plan(_)
        | LabError::Configuration(_)
        | LabError::Picture(_)
        | LabError::File(_)
        | LabError::Damaged { .. } => INPUT,
    }
}
