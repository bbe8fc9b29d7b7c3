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
use crate::mutation::side_by_side::{Operator, VERSIONS};
use pointcore_tb::verilated::{ModuleInterface, Port};
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

/// An operator of one operand.
struct Unary<'a> {
    module: &'a str,
    enable: String,
    operand: &'a Port,
    result: &'a Port,
}

impl<'a> Unary<'a> {
    /// That of an interface, if it is one.
    fn of(interface: &'a ModuleInterface) -> Option<Self> {
        let Operator { enable, operands, result, .. } = Operator::of(interface)?;
        let [operand] = &operands[..] else { return None };
        let port = |name: &str| interface.ports.iter().find(|port| port.name == name);
        let (operand, result) = (port(operand)?, port(&result)?);
        (operand.width <= OPERAND_BITS).then_some(Self { module: &interface.name, enable, operand, result })
    }

    /// A module in which it is enabled or not.
    fn enabled(&self, enable: bool) -> String {
        let Self { module, enable: port, operand: Port { name: a, width: a_bits, .. }, .. } = self;
        let Port { name: y, width: y_bits, .. } = self.result;
        format!(
            "module {ENABLED}(input clk, input [{}:0] {a}, output [{}:0] {y});\n\
             {module} unit(.clk(clk), .{port}(1'd{}), .{a}({a}), .{y}({y}));\nendmodule\n",
            a_bits - 1,
            y_bits - 1,
            u32::from(enable)
        )
    }

    /// A module in which both versions are given an operand.
    fn both(&self) -> String {
        let [a, y] = [self.operand, self.result].map(|port| &port.name);
        let [gold, gate] = VERSIONS
            .map(|version| format!("{version} {version}(.clk(1'd0), .{a}(operand), .{y}({version}_result));\n"));
        let [operand, result] = [self.operand, self.result].map(|port| port.width - 1);
        format!(
            "module both(input [{operand}:0] operand, output differ);\nwire [{result}:0] gold_result, gate_result;\n\
             {gold}{gate}assign differ = gold_result != gate_result;\nendmodule\n"
        )
    }
}

/// What a register always takes is what it always holds, once it took it: it then holds that out of its turn, too.
fn of_output(mutation: &str) -> String {
    let is_stuck = mutation.contains(REGISTER) && mutation.contains("-mode const");
    if is_stuck { mutation.replace(" -port D ", " -port Q ") } else { mutation.to_owned() }
}

impl Prover<'_> {
    /// Compares an operator with its mutant, if it has one operand: `None` of another module, or of a mutant that is no pipeline.
    pub(super) fn exhaust(&self, module: &str) -> Result<Option<Proof>, MutationError> {
        let interface = self.subject.interfaces.iter().find(|interface| interface.name == module);
        let Some(operator) = interface.and_then(Unary::of) else { return Ok(None) };
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
        let folder = Folder::new()?;
        folder.write("source.v", &self.subject.verilog)?;
        folder.write("runs.v", &operator.enabled(true))?;
        folder.write("holds.v", &operator.enabled(false))?;
        folder.write("wires.v", WIRES)?;
        folder.write("pipelines.ys", &pipelines)?;
        if self.yosys.run(module, folder.path(), &["-q", "pipelines.ys"]).is_err() {
            return Ok(None);
        }
        folder.write("both.v", &operator.both())?;
        folder.write("loop.cpp", &LOOP.replace("OPERAND_BITS", &operator.operand.width.to_string()))?;
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
