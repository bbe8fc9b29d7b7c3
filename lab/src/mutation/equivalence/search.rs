//! ABC's search for an invariant under which two versions never differ, or for inputs that show a difference.

use super::way::Way;
use super::{Proof, followed};
use crate::mutation::MutationError;
use crate::mutation::process::{self, Verdict};
use pointcore_tb::cache::file;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

/// Both versions, with an output that says whether they differ.
pub(super) const MITER: &str = "miter.aig";

/// The ABC that comes with Debian's yosys.
const ABC: &str = "yosys-abc";

/// What is followed comes to an end, if after so many times the time for a proof.
const PATIENCE: u32 = 60;

/// Cycles within which a difference is sought at first.
const SOON: u32 = 12;

/// Takes cycles that follow each other in turns together, up to 24 of them: what was inverted between two looks is not there then.
const IN_TURNS: &str = "lcorr; scorr; phase -F 2; lcorr; scorr; phase -F 2; lcorr; scorr; phase -F 2; phase -F 3; orpos; lcorr; scorr; scorr -F 4";

/// What ABC says of a property that holds, and of one that does not.
const PROVED: &str = "Property proved";
const REFUTED: &str = "was asserted in frame";

fn is_answer(line: &str) -> bool {
    line.contains(PROVED) || line.contains(REFUTED)
}

/// Asks whether the miter in `folder` ever says that both differ, with one reset before all else or without.
pub(super) fn search(folder: &Path, way: Way<'_>, has_one_reset: bool, seconds: u32) -> Result<Proof, MutationError> {
    // What is assumed is so after the reset.
    let reset = if has_one_reset { "strash; cycle -F 1; " } else { "" };
    let ask = |question: &str, limit: u32| {
        let mut command = Command::new(ABC);
        command.args(["-c", &format!("read_aiger {MITER}; {reset}fold; strash; {question}")]).current_dir(folder);
        process::run(command, Duration::from_secs(limit.into()), is_answer)
    };
    // Most differences show soon. Otherwise registers that hold the same in both are merged, by a look at them alone at first, which
    // is enough where a difference never gets into one; what is left is small.
    let (sweep, search, patience) = match way {
        Way::At(_) => {
            let soon = ask(&format!("bmc3 -F {SOON} -T {seconds}"), 2 * seconds)?;
            if matches!(soon, Verdict::Failed(text) if text.contains(REFUTED)) {
                return Ok(Proof::Different);
            }
            ("lcorr; &get; &scorr -C 100; &put; scorr; scorr -F 4", seconds, 2 * seconds)
        }
        Way::InTurns(_) => (IN_TURNS, seconds, 4 * seconds),
        // Registers that are not near follow from one look, but there are many; what one holds for some cycles, from some looks.
        Way::Around(_) => (IN_TURNS, 4 * seconds, 8 * seconds),
        Way::Followed(_) => {
            let miter = folder.join(MITER);
            let limit = Duration::from_secs((PATIENCE * seconds).into());
            return Ok(followed::follow(&miter, limit).map_err(file("read", &miter))?);
        }
    };
    Ok(match ask(&format!("{sweep}; pdr -T {search}"), patience)? {
        Verdict::Failed(text) if text.contains(PROVED) => Proof::Equivalent,
        Verdict::Failed(text) if text.contains(REFUTED) => Proof::Different,
        // Without an answer it came to its end, to that of its time, or to that of the memory there is.
        Verdict::Passed | Verdict::Failed(_) | Verdict::Stuck => Proof::Open,
    })
}
