//! Proofs that a mutant changes nothing that can be seen.
//!
//! Design and mutant run side by side on the same inputs, from all registers zero; ABC searches an invariant under which
//! no output ever differs, or inputs that show a difference. Inputs are free: what a unit's neighbors never do counts too,
//! so a mutant that only they could show is not equivalent here.

use super::MutationError;
use super::campaign::Subject;
use super::process::{self, Verdict};
use super::schemata::NETLIST;
use crate::synthesis::Tool;
use pointcore_tb::cache::file;
use std::fmt;
use std::fs;
use std::process::Command;
use std::time::Duration;

/// The ABC that comes with Debian's yosys.
const ABC: &str = "yosys-abc";

/// A design with more text than this is a whole core: the prover comes to no end with it.
const LARGEST_BYTES: usize = 60_000;

/// What became of a proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proof {
    /// No input ever shows a difference.
    Equivalent,
    /// Some inputs show a difference.
    Different,
    /// Neither was found in the time given.
    Open,
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Equivalent => "equivalent",
            Self::Different => "differs",
            Self::Open => "undecided",
        })
    }
}

/// Compares a design with its mutant: first the module that is mutated alone, which is small, then the whole.
pub fn prove(yosys: &Tool, subject: &Subject, mutation: &str, seconds: u32) -> Result<Proof, MutationError> {
    let module = mutation.split(' ').skip_while(|word| *word != "-module").nth(1).unwrap_or(&subject.top);
    match compare(yosys, subject, module, mutation, seconds)? {
        Proof::Equivalent => Ok(Proof::Equivalent),
        proof if module == subject.top || subject.verilog.len() > LARGEST_BYTES => Ok(proof),
        // What surrounds the module may hide the difference, or keep it from coming about.
        _ => compare(yosys, subject, &subject.top, mutation, seconds),
    }
}

/// Compares a module of a design with its mutant.
fn compare(
    yosys: &Tool,
    subject: &Subject,
    module: &str,
    mutation: &str,
    seconds: u32,
) -> Result<Proof, MutationError> {
    if module == subject.top && !subject.others.is_empty() {
        // It is joined with what is not mutated, a whole core.
        return Ok(Proof::Open);
    }
    let scratch = tempfile::tempdir().map_err(file("create a folder in", &std::env::temp_dir()))?;
    let folder = scratch.path();
    let top = &subject.top;
    let flat = |name: &str| {
        format!(
            "hierarchy -top {module}\nmemory\nflatten\nopt_clean\nsetundef -undriven -zero\nsetundef -zero\n\
             rename {module} {name}\ndesign -stash {name}\n"
        )
    };
    let (gold, gate) = (flat("gold"), flat("gate"));
    // No pass here may take a value for another because it is open: what is open was set to zero in both.
    let script = format!(
        "read_verilog -lib library.v\nread_verilog source.v\nhierarchy -top {top}\n{NETLIST}design -save source\n{gold}\
         design -load source\n{mutation}\n{gate}\
         design -copy-from gold gold\ndesign -copy-from gate gate\n\
         miter -equiv -flatten gold gate miter\nhierarchy -top miter\nmemory_map\nopt_clean\ntechmap\nopt_clean\n\
         dffunmap\nsimplemap\nopt_clean\nsetundef -undriven -zero\nsetundef -zero\nzinit -all\naigmap\nopt_clean\n\
         write_aiger -zinit miter.aig\n"
    );
    for (name, text) in [("source.v", &subject.verilog), ("library.v", &subject.others), ("miter.ys", &script)] {
        let path = folder.join(name);
        fs::write(&path, text).map_err(file("write", &path))?;
    }
    match yosys.run(top, folder, &["-q", "miter.ys"]) {
        // A module that holds one of those that are not mutated cannot be brought to gates.
        Err(_) if !subject.others.is_empty() => return Ok(Proof::Open),
        result => result?,
    }
    // Registers that hold the same in both are merged first; what is left is small.
    let script = format!("read_aiger miter.aig; fold; strash; scorr; scorr -F 4; pdr -T {seconds}");
    let mut command = Command::new(ABC);
    command.args(["-c", &script]).current_dir(folder);
    Ok(match process::run(command, Duration::from_secs(2 * u64::from(seconds)), is_answer)? {
        Verdict::Failed(text) if text.contains(PROVED) => Proof::Equivalent,
        Verdict::Failed(_) => Proof::Different,
        Verdict::Passed | Verdict::Stuck => Proof::Open,
    })
}

/// What ABC says of a property that holds, and of one that does not.
const PROVED: &str = "Property proved";
const REFUTED: &str = "was asserted in frame";

fn is_answer(line: &str) -> bool {
    line.contains(PROVED) || line.contains(REFUTED)
}

#[cfg(test)]
mod tests {
    use super::*;

    const COUNTER: &str = "module counter(input clk, input rst, output reg [3:0] count);\n\
        wire never = count == 4'd12;\n\
        always @(posedge clk) if (rst || count == 4'd9 || never) count <= 0; else count <= count + 4'd1;\n\
        endmodule\n";

    #[test]
    fn a_condition_that_never_holds_is_equivalent_and_another_is_not() {
        let Ok(yosys) = Tool::yosys() else {
            pointcore_tb::skipped::skipped("no yosys that is new enough: `make setup-fpga` installs it");
            return;
        };
        let subject = Subject {
            verilog: COUNTER.to_owned(),
            others: String::new(),
            top: "counter".to_owned(),
            tests: Vec::new(),
            substitute: "unused".into(),
        };
        let prove = |mutation: &str| prove(&yosys, &subject, mutation, 10).unwrap_or_else(|error| panic!("{error}"));
        let mutate = |wire: &str| {
            format!(
                "select -assert-count 1 w:{wire}\nmutate -list 1 -wire {wire} -mode const0 -o chosen\nscript chosen\n"
            )
        };
        assert_eq!(prove(&mutate("never")), Proof::Equivalent);
        assert_eq!(prove(&mutate("count")), Proof::Different);
    }
}
