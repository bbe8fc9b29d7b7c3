//! Operators of one operand, compared on every operand that there is.
//!
//! Steps of a root or of a quotient keep to ranges that no prover finds. But an operator is a pipeline: what it answers depends on
//! its operand alone. With its registers taken for wires it is a function, which a simulator computes millions of times a second.
//! That the mutant is such a pipeline, too, is shown first: it holds while it is not enabled, and without registers it has no loop.

use super::versions::Folder;
use super::{Proof, Prover, REGISTER};
use crate::mutation::MutationError;
use crate::mutation::process::{self, Verdict};
use crate::mutation::schemata::NETLIST;
use crate::mutation::side_by_side::VERSIONS;
use pointcore_tb::verilated::{Direction, ModuleInterface, Port};
use std::process::Command;
use std::time::Duration;

/// Bits of the longest operand.
const OPERAND_BITS: u32 = 32;
/// The module in which an operator is enabled at all times, or never.
const ENABLED: &str = "enabled";
/// Registers as yosys has them, and as wires.
const REGISTERS: &str = "t:$dff* t:$sdff* t:$adff* t:$dlatch* %u %u %u";
const WIRES: &str = "(* techmap_celltype = \"$dff\" *)\nmodule wires(CLK, D, Q);\nparameter WIDTH = 1;\n\
    parameter CLK_POLARITY = 1;\ninput CLK;\ninput [WIDTH-1:0] D;\noutput [WIDTH-1:0] Q;\nassign Q = D;\nendmodule\n";

/// Goes through all operands.
const LOOP: &str = include_str!("exhausted.cpp");

/// The operand and the result of an operator that has one operand.
fn ports(interface: &ModuleInterface) -> Option<[&Port; 2]> {
    let mut operands = interface.ports.iter().filter(|port| port.direction == Direction::Input);
    let result = interface.ports.iter().find(|port| port.direction == Direction::Output)?;
    let operand = operands.find(|port| !["clk", "enable"].contains(&&*port.name))?;
    let has_enable = interface.ports.iter().any(|port| port.name == "enable");
    (interface.ports.len() == 4 && has_enable && operand.width <= OPERAND_BITS).then_some([operand, result])
}

/// What a register always takes is what it always holds, once it took it: it then holds that out of its turn, too.
fn of_output(mutation: &str) -> String {
    let is_stuck = mutation.contains(REGISTER) && mutation.contains("-mode const");
    if is_stuck { mutation.replace(" -port D ", " -port Q ") } else { mutation.to_owned() }
}

impl Prover<'_> {
    /// Compares an operator with its mutant, if it has one operand: `None` of another module, or of a mutant that is no pipeline.
    pub(super) fn exhaust(&self, module: &str) -> Result<Option<Proof>, MutationError> {
        let known = self.subject.interfaces.iter().find(|interface| interface.name == module);
        let Some([operand, result]) = known.and_then(ports) else { return Ok(None) };
        let folder = Folder::new()?;
        let range = |port: &Port| format!("[{}:0] {}", port.width - 1, port.name);
        let around = |enable: u32| {
            format!(
                "module {ENABLED}(input clk, input {}, output {});\n{module} unit(.clk(clk), .enable(1'd{enable}), \
                 .{2}({2}), .{3}({3}));\nendmodule\n",
                range(operand),
                range(result),
                operand.name,
                result.name
            )
        };
        let flat = |around: &str| {
            format!("read_verilog {around}\nhierarchy -top {ENABLED}\nproc\nflatten\nmemory\nopt -full\n")
        };
        let [gold, gate] = VERSIONS;
        let as_wires = |name: &str| {
            format!(
                "{}dffunmap\ntechmap -map wires.v\nselect -assert-none {REGISTERS}\ncheck -assert\n\
                 rename {ENABLED} {name}\nwrite_verilog -noattr {name}.v\n",
                flat("runs.v")
            )
        };
        let read = format!("read_verilog source.v\nhierarchy -top {}\n{NETLIST}", self.subject.top);
        // The mutant comes first: its cells have the names of a first reading.
        let pipelines = format!(
            "{read}{}\ndesign -save mutant\n{}select -assert-none {REGISTERS}\ndesign -load mutant\n{}design -reset\n{read}{}",
            of_output(self.mutation),
            flat("holds.v"),
            as_wires(gate),
            as_wires(gold)
        );
        folder.write("source.v", &self.subject.verilog)?;
        folder.write("runs.v", &around(1))?;
        folder.write("holds.v", &around(0))?;
        folder.write("wires.v", WIRES)?;
        folder.write("pipelines.ys", &pipelines)?;
        if self.yosys.run(module, folder.path(), &["-q", "pipelines.ys"]).is_err() {
            return Ok(None);
        }
        let connected = |version: &str| {
            format!(
                "{version} {version}(.clk(1'd0), .{0}(operand), .{1}({version}_result));\n",
                operand.name, result.name
            )
        };
        let [operand_range, result_range] = [operand.width, result.width].map(|width| width - 1);
        folder.write(
            "both.v",
            &format!(
                "module both(input [{operand_range}:0] operand, output differ);\nwire [{result_range}:0] gold_result, \
                 gate_result;\n{}{}assign differ = gold_result != gate_result;\nendmodule\n",
                connected(gold),
                connected(gate)
            ),
        )?;
        folder.write("loop.cpp", &LOOP.replace("OPERAND_BITS", &operand.width.to_string()))?;
        let mut build = Command::new("verilator");
        build.args(["--cc", "--exe", "--build", "-O3", "--x-assign", "fast", "-Wno-fatal", "-Wno-lint", "-Wno-style"]);
        build.args(["-CFLAGS", "-O3", "--top-module", "both", "both.v", "gold.v", "gate.v", "loop.cpp"]);
        process::output(build.current_dir(folder.path()))?;
        let run = Command::new(folder.path().join("obj_dir/Vboth"));
        let limit = Duration::from_secs((4 * self.seconds).into());
        Ok(Some(match process::run(run, limit, |line| line.starts_with("differs"))? {
            Verdict::Passed => Proof::Equivalent,
            Verdict::Failed(_) => Proof::Different,
            Verdict::Stuck => Proof::Open,
        }))
    }
}
