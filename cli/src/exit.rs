//! Exit codes: 1 where hardware, models or records disagree, 2 where the input is wrong or a result cannot be written, 3 where a tool is missing
//! or fails.

use crate::commands::Failure;
use pointcore::process::ProcessError;
use pointcore::search::SearchError;
use pointcore::vectors::VectorsError;
use pointcore_lab::LabError;
use pointcore_lab::mutation::MutationError;
use pointcore_lab::synthesis::SynthesisError;
use pointcore_tb::lockstep::LockstepError;
use pointcore_tb::verilated::VerilatedError;
use std::process::ExitCode;

const DISAGREEMENT: u8 = 1;
const INPUT: u8 = 2;
const TOOL: u8 = 3;

/// The code of a failure.
pub fn code(failure: &Failure) -> ExitCode {
    ExitCode::from(match failure {
        Failure::Neighbors(_) | Failure::Operator(_) | Failure::Soak(_) | Failure::Stale { .. } => DISAGREEMENT,
        Failure::Mismatch(error) => lockstep(error),
        Failure::Verilated(error) => verilated(error),
        Failure::Generate(_) | Failure::Package(_) => TOOL,
        Failure::Scene(_)
        | Failure::Plan { .. }
        | Failure::Budget { .. }
        | Failure::Excluded { .. }
        | Failure::Configuration(_)
        | Failure::Usage(_)
        | Failure::Write { .. }
        | Failure::Print(_)
        | Failure::Picture(_)
        | Failure::Blank { .. }
        | Failure::Render(_) => INPUT,
        Failure::Search(error) => search(error),
        Failure::Process(error) => process(error),
        Failure::Vectors(error) => vectors(error),
        Failure::Lab(error) => lab(error),
    })
}

/// A folder that cannot be written is the user's to choose.
const fn verilated(error: &VerilatedError) -> u8 {
    match error {
        VerilatedError::File(_) | VerilatedError::Waveform { .. } => INPUT,
        VerilatedError::Stopped(_) => DISAGREEMENT,
        _ => TOOL,
    }
}

const fn lockstep(error: &LockstepError) -> u8 {
    match error {
        LockstepError::Verilated(error) => verilated(error),
        LockstepError::Seed { .. } => INPUT,
        _ => DISAGREEMENT,
    }
}

const fn search(error: &SearchError) -> u8 {
    match error {
        SearchError::Lockstep(error) => lockstep(error),
        SearchError::Verilated(error) => verilated(error),
        SearchError::Stuck { .. } => DISAGREEMENT,
        SearchError::Generate(_) => TOOL,
        _ => INPUT,
    }
}

const fn process(error: &ProcessError) -> u8 {
    match error {
        ProcessError::Generate(_) => TOOL,
        // The hardware finds these, too.
        ProcessError::Points(error) => search(error),
        _ => INPUT,
    }
}

const fn vectors(error: &VectorsError) -> u8 {
    match error {
        VectorsError::Frame(error) => lockstep(error),
        VectorsError::Generate(_) => TOOL,
        VectorsError::Search(error) => search(error),
        VectorsError::Base(_)
        | VectorsError::Surfaces(_)
        | VectorsError::Space { .. }
        | VectorsError::Numbers { .. } => INPUT,
    }
}

const fn lab(error: &LabError) -> u8 {
    match error {
        LabError::Neighbors(_) | LabError::Unphysical(_) => DISAGREEMENT,
        LabError::Process(error) => process(error),
        LabError::Lockstep(error) => lockstep(error),
        LabError::Verilated(error) => verilated(error),
        LabError::Search(error) => search(error),
        LabError::Synthesis(SynthesisError::TooLarge { .. }) => INPUT,
        LabError::Mutation(MutationError::Baseline { .. }) => DISAGREEMENT,
        LabError::Mutation(
            MutationError::Unknown { .. } | MutationError::NotRecorded { .. } | MutationError::Configuration(_),
        ) => INPUT,
        LabError::Generate(_) | LabError::Synthesis(_) | LabError::Mutation(_) => TOOL,
        LabError::Scene(_)
        | LabError::Plan(_)
        | LabError::Render(_)
        | LabError::Configuration(_)
        | LabError::Picture(_)
        | LabError::File(_)
        | LabError::Damaged { .. } => INPUT,
    }
}
