//! Proofs that a mutant changes nothing that can be seen.
//!
//! Design and mutant run side by side on the same inputs, from all registers zero; ABC searches an invariant under which
//! no output ever differs, or inputs that show a difference. Inputs are free: what a unit's neighbors never do counts too,
//! so a mutant that only they could show is not equivalent here.

use super::MutationError;
use super::campaign::Subject;
use super::schemata::NETLIST;
use crate::synthesis::Tool;
use pointcore_tb::cache::file;
use std::fmt;
use std::fs;
use std::process::Command;

/// The ABC that comes with Debian's yosys.
const ABC: &str = "yosys-abc";

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

/// Compares a design with its mutant.
pub fn prove(yosys: &Tool, subject: &Subject, mutation: &str, seconds: u32) -> Result<Proof, MutationError> {
    let scratch = tempfile::tempdir().map_err(file("create a folder in", &std::env::temp_dir()))?;
    let folder = scratch.path();
    let write = |name: &str, text: &str| {
        let path = folder.join(name);
        fs::write(&path, text).map_err(file("write", &path))
    };
    let top = &subject.top;
    write("source.v", &subject.verilog)?;
    write("others.v", &subject.others)?;
    let flat = "memory\nflatten\nopt_clean\n";
    write(
        "miter.ys",
        &format!(
            "read_verilog others.v source.v\nhierarchy -top {top}\n{NETLIST}design -save source\n\
             {flat}rename {top} gold\ndesign -stash gold\n\
             design -load source\n{mutation}\n{flat}rename {top} gate\ndesign -stash gate\n\
             design -copy-from gold gold\ndesign -copy-from gate gate\n\
             miter -equiv -flatten -ignore_gold_x gold gate miter\nhierarchy -top miter\n\
             memory_map\nopt\nsetundef -zero\ntechmap\nopt\ndffunmap\nsimplemap\nopt_clean\nzinit -all\naigmap\nopt_clean\nwrite_aiger -zinit miter.aig\n"
        ),
    )?;
    yosys.run(top, folder, &["-q", "miter.ys"])?;
    // Registers that hold the same in both are merged first; what is left is small.
    let script = format!("read_aiger miter.aig; fold; strash; scorr; scorr -F 4; pdr -T {seconds}");
    let output = Command::new(ABC).args(["-c", &script]).current_dir(folder).output();
    let output = output.map_err(|error| MutationError::Program { program: ABC.into(), output: error.to_string() })?;
    let text = String::from_utf8_lossy(&output.stdout);
    Ok(if text.contains("Property proved") {
        Proof::Equivalent
    } else if text.contains("was asserted in frame") {
        Proof::Different
    } else {
        Proof::Open
    })
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
