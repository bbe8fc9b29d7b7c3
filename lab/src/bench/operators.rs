//! Operators of every format, hardware against golden.

use crate::float_check::{Enable, Stages, check_format};
use crate::note;
use crate::{Figures, LabError};
use pointcore_contract::Format;

/// Operand triples for each operator and format.
const CASES: u64 = 1 << 20;
/// Seed of the operands.
const SEED: u64 = 1;

/// Counts cases and mismatches of every operator.
///
/// # Errors
/// The operators cannot be built or run.
pub fn figures(figures: &mut Figures) -> Result<(), LabError> {
    for (name, format) in Format::NAMED {
        note!("operators: {name}");
        for report in check_format(format, Stages::Default, Enable::Always, CASES, SEED)? {
            let key = format!("fp.{}.{name}", report.operation);
            figures.insert(format!("{key}.cases"), report.cases.into());
            figures.insert(format!("{key}.mismatches"), report.mismatches.into());
        }
    }
    Ok(())
}
