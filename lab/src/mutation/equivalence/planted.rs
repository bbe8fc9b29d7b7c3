//! A fault as a cell of its own, so that yosys finds what looks at it.
//!
//! yosys' mutations end in a cell, but for constants: where what a cell puts out is stuck, nothing leads from there to what
//! saw it. So a constant is planted as an inverter, and that is given the opposite.

use super::{Prover, REGISTER, argument};

/// What selects the cells that make the fault, of modules and within them.
pub(super) const FAULT: &str = "c:*planted_fault_*";

/// The first of them, without the path to its module.
const FIRST: &str = "planted_fault_0";

impl Prover<'_> {
    /// What plants the fault, and what ties it to its constant, if it has one. Without a cell, as in tests, it is as yosys has it.
    pub(super) fn planted(&self) -> [String; 2] {
        let Self { mutation, cell, .. } = self;
        if cell.is_none() {
            return [format!("{mutation}\n"), String::new()];
        }
        let named =
            |mutation: &str| format!("{mutation}\nrename -enumerate -pattern planted_fault_% */c:$auto$mutate.cc:*\n");
        let (mode, opposite) = match argument(mutation, "-mode") {
            Some(mode @ "const0") => (mode, 1),
            Some(mode @ "const1") => (mode, 0),
            _ => return [named(mutation), String::new()],
        };
        let module = argument(mutation, "-module").unwrap_or(&self.subject.top);
        let inverted = mutation.replace(&format!("-mode {mode}"), "-mode inv");
        [named(&inverted), format!("cd {module}\nconnect -port {FIRST} A 1'b{opposite}\ncd ..\n")]
    }

    /// Says that the fault, not yet tied, is not between a reset and a register: what registers hold in a reset that does not
    /// get to them is not asked. What a register itself is given in a reset is a constant in the mutant, too.
    pub(super) fn no_reset_goes_through(&self, module: &str) -> String {
        if self.cell.is_none_or(|cell| cell.contains(REGISTER)) {
            return String::new();
        }
        format!(
            "design -push-copy\nhierarchy -top {module}\nflatten\n\
             select -assert-none */i:rst */w:*one_reset %u %co*:-$dff */{FAULT} %i\ndesign -pop\n"
        )
    }
}
