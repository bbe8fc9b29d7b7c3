//! Proofs that a mutant changes nothing that can be seen.
//!
//! Design and mutant run side by side on the same inputs, from all registers zero; ABC searches an invariant under which
//! no output ever differs, or inputs that show a difference. Of a unit, outputs count when they count in lockstep, and inputs
//! keep the rules of streams. The design's assertions are assumed, as simulations check them: some say what its neighbors
//! never do. Inputs are free otherwise, so a mutant counts even where only inputs show it that no neighbor gives.

use super::MutationError;
use super::campaign::Subject;
use super::modules::Modules;
use super::process::{self, Verdict};
use super::schemata::NETLIST;
use crate::note;
use crate::synthesis::Tool;
use pointcore_tb::cache::file;
use pointcore_tb::verilated::side_by_side;
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

/// Compares a design with its mutant: first the module that is mutated alone, whatever the modules in it do, which is small;
/// then with them and ever more of what surrounds it, which may hide the difference or keep it from coming about.
pub fn prove(yosys: &Tool, subject: &Subject, mutation: &str, seconds: u32) -> Result<Proof, MutationError> {
    let module = mutation.split(' ').skip_while(|word| *word != "-module").nth(1).unwrap_or(&subject.top);
    let is_large = subject.core.is_none() && subject.verilog.len() > LARGEST_BYTES;
    let modules = Modules::of(&subject.verilog);
    let inside: Vec<&str> = subject.core.as_deref().into_iter().chain(modules.inside(plain(module))).collect();
    let whole: Vec<&str> = subject.core.as_deref().into_iter().collect();
    let alone = (!inside.is_empty()).then(|| (module.to_owned(), &inside));
    let around = surroundings(&modules, subject, module).into_iter().map(|module| (module, &whole));
    let mut proof = Proof::Open;
    for (module, open) in alone.into_iter().chain(around.filter(|(module, _)| !is_large || *module != subject.top)) {
        proof = compare(yosys, subject, (&module, open), mutation, seconds)?;
        if proof == Proof::Equivalent {
            break;
        }
    }
    Ok(proof)
}

/// A module and those around it, up to the top; the top next where there are several around one.
fn surroundings(modules: &Modules<'_>, subject: &Subject, module: &str) -> Vec<String> {
    let mut chain = vec![module.to_owned()];
    while let Some(inner) = chain.last().filter(|inner| **inner != subject.top) {
        let around = modules.around(plain(inner));
        let next = match around[..] {
            [one] if !chain.iter().any(|inner| inner == one) => one,
            _ => &subject.top,
        };
        chain.push(next.to_owned());
    }
    chain
}

/// What the text calls a module: of one with parameters, yosys' name ends with it.
fn plain(module: &str) -> &str {
    module.rsplit('\\').next().unwrap_or(module)
}

/// Compares a module of a design with its mutant, whatever the `open` ones in it do.
fn compare(
    yosys: &Tool,
    subject: &Subject,
    (module, open): (&str, &[&str]),
    mutation: &str,
    seconds: u32,
) -> Result<Proof, MutationError> {
    let scratch = tempfile::tempdir().map_err(file("create a folder in", &std::env::temp_dir()))?;
    let folder = scratch.path();
    let top = &subject.top;
    let library = match subject.core {
        Some(_) => format!("read_verilog -overwrite library.v\nhierarchy -top {top}\nproc\n"),
        None => String::new(),
    };
    // Its inputs are outputs of the design, and its outputs inputs: whatever an open module may do.
    let each = |text: fn(&&str) -> String| open.iter().map(text).collect::<String>();
    let blackened = each(|name| format!("blackbox {name} $paramod*\\\\{name}\n"));
    let turned = each(|name| format!("expose -evert */t:{name} */t:$paramod*\\\\{name}\n"));
    let read = format!("{library}{blackened}hierarchy -top {module}\n");
    let flat = |name: &str| {
        format!(
            "{read}memory\nflatten\n{turned}opt_clean\nsetundef -undriven -zero\nsetundef -zero\n\
             rename {module} {name}\ndesign -stash {name}\n"
        )
    };
    let [gold, gate] = side_by_side::VERSIONS.map(flat);
    let source = |options: &str, name: &str| {
        format!("read_verilog -lib library.v\nread_verilog {options} {name}\nhierarchy -top {top}\n{NETLIST}")
    };
    let [assuming, plain] = [source("-formal -D RTL_ASSERT", "assuming.v"), source("", "source.v")];
    let (comparison, miter) = match &subject.comparison {
        Some(comparison) if module == top && open.is_empty() => (
            comparison.as_str(),
            format!(
                "read_verilog -formal comparison.v\nhierarchy -top {0}\nproc\nflatten\nrename {0} miter\n",
                side_by_side::MODULE
            ),
        ),
        _ => ("", "miter -equiv -flatten gold gate miter\n".to_owned()),
    };
    // The mutant comes first: its cells have the names of a first reading.
    // No pass here may take a value for another because it is open: what is open was set to zero in both.
    let script = format!(
        "{plain}{mutation}\n{gate}design -reset\n{assuming}chformal -assert2assume\n{gold}design -reset\n\
         design -copy-from gold gold\ndesign -copy-from gate gate\n\
         {miter}chformal -lower\nhierarchy -top miter\nmemory_map\nopt_clean\ntechmap\nopt_clean\n\
         dffunmap\nsimplemap\nopt_clean\nsetundef -undriven -zero\nsetundef -zero\nzinit -all\naigmap\nopt_clean\n\
         write_aiger -zinit miter.aig\n"
    );
    let files = [
        ("source.v", subject.verilog.as_str()),
        ("assuming.v", &assuming_assertions(&subject.verilog)),
        ("library.v", &subject.others),
        ("comparison.v", comparison),
        ("miter.ys", &script),
    ];
    for (name, text) in files {
        let path = folder.join(name);
        fs::write(&path, text).map_err(file("write", &path))?;
    }
    if let Err(error) = yosys.run(top, folder, &["-q", "miter.ys"]) {
        // It may be too large for yosys' memory; nothing is claimed of it then.
        note!("{mutation}: undecided, for {error}");
        return Ok(Proof::Open);
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

/// The design with assertions that hold in every cycle, to be assumed. Simulations with assertions spoil what a memory's
/// port reads while it is written; the mutant does not, and need not differ for that.
fn assuming_assertions(verilog: &str) -> String {
    let clocked = "always @(posedge clk) if (!rst) begin\n`ifdef FORMAL";
    let held = "always @* if (!rst) begin\n`ifdef FORMAL";
    verilog.replace(clocked, held).replace("_word <= ~words[", "_word <= words[")
}

/// What ABC says of a property that holds, and of one that does not.
const PROVED: &str = "Property proved";
const REFUTED: &str = "was asserted in frame";

fn is_answer(line: &str) -> bool {
    line.contains(PROVED) || line.contains(REFUTED)
}

#[cfg(test)]
mod tests {
    use super::super::schemata::Schemata;
    use super::*;
    use pointcore_tb::verilated::{Direction, Port, StreamDeclaration, VerilogSource};
    use rtl::{Module, elaborate};

    const COUNTER: &str = "module counter(input clk, input rst, output reg [3:0] count);\n\
        wire never = count == 4'd12;\n\
        always @(posedge clk) if (rst || count == 4'd9 || never) count <= 0; else count <= count + 4'd1;\n\
        endmodule\n";

    /// What a prover says of a mutation, if there is a yosys.
    fn proof(subject: &Subject, mutation: &str) -> Option<Proof> {
        let Ok(yosys) = Tool::yosys() else {
            pointcore_tb::skipped::skipped("no yosys that is new enough: `make setup-fpga` installs it");
            return None;
        };
        Some(prove(&yosys, subject, mutation, 10).unwrap_or_else(|error| panic!("{error}")))
    }

    fn subject(verilog: &str, others: &str, core: Option<&str>, top: &str) -> Subject {
        Subject {
            verilog: verilog.to_owned(),
            others: others.to_owned(),
            core: core.map(str::to_owned),
            top: top.to_owned(),
            modules: Modules::of(verilog).names().map(str::to_owned).collect(),
            comparison: None,
            tests: Vec::new(),
            substitute: "unused".into(),
        }
    }

    #[test]
    fn a_condition_that_never_holds_is_equivalent_and_another_is_not() {
        let subject = subject(COUNTER, "", None, "counter");
        let stuck = |wire: &str| {
            proof(
                &subject,
                &format!(
                    "select -assert-count 1 w:{wire}\nmutate -list 1 -wire {wire} -mode const0 -o chosen\nscript chosen\n"
                ),
            )
        };
        let Some(never) = stuck("never") else { return };
        assert_eq!((never, stuck("count")), (Proof::Equivalent, Some(Proof::Different)));
    }

    #[test]
    fn what_surrounds_a_module_follows_it_up_to_the_top() {
        let verilog = "// A unit.\nmodule inner(input a);\nendmodule\nmodule outer (input a);\n  inner #(.W(2)) x(.a(a));\nendmodule\n\
            module top(input a);\n  outer y(.a(a));\n  shared z(.a(a));\nendmodule\nmodule other(input a);\n  shared z(.a(a));\nendmodule\n";
        let subject = subject(verilog, "", None, "top");
        let modules = Modules::of(&subject.verilog);
        assert_eq!(surroundings(&modules, &subject, "$paramod$12\\inner"), ["$paramod$12\\inner", "outer", "top"]);
        assert_eq!(surroundings(&modules, &subject, "shared"), ["shared", "top"]);
        assert_eq!(surroundings(&modules, &subject, "top"), ["top"]);
    }

    #[test]
    fn a_core_may_do_anything_and_may_not_see_a_difference() {
        let core = "module core(input clk, input [1:0] a, output y);\nassign y = a[0];\nendmodule\n";
        let top = "module top(input clk, input [2:0] x, output y);\n\
            reg [2:0] kept;\nalways @(posedge clk) kept <= x;\n\
            core core(.clk(clk), .a(kept[1:0]), .y(y));\nendmodule\n";
        let subject = subject(top, core, Some("core"), "top");
        let stuck = |bit: u32| {
            let place = format!("-mode const0 -wire kept -wirebit {bit}");
            proof(&subject, &format!("mutate -list 1 {place} -o chosen\nscript chosen\n"))
        };
        let Some(unused) = stuck(2) else { return };
        assert_eq!((unused, stuck(1), stuck(0)), (Proof::Equivalent, Some(Proof::Different), Some(Proof::Different)));
    }

    #[test]
    fn a_module_is_compared_alone_whatever_those_in_it_do() {
        let inner = "module inner #(\n    parameter W = 2, parameter V = 2\n) (input clk, input [W-1:0] a, output y);\nassign y = a[0];\nendmodule\n";
        let top = "module top(input clk, input [2:0] x, output z);\nreg [2:0] kept;\nwire y;\n\
            wire never = kept[0] && kept[2] && !kept[0];\nalways @(posedge clk) kept <= x;\n\
            inner #(.W(3), .V(3)) inner(\n.clk(clk), .a(kept), .y(y));\nassign z = y ^ never;\nendmodule\n";
        let subject = subject(&format!("{inner}{top}"), "", None, "top");
        let Ok(yosys) = Tool::yosys() else {
            pointcore_tb::skipped::skipped("no yosys that is new enough: `make setup-fpga` installs it");
            return;
        };
        let stuck = |wire: &str, open: &[&str]| {
            let mutation = format!("mutate -list 1 -mode const0 -wire {wire} -o chosen\nscript chosen\n");
            compare(&yosys, &subject, ("top", open), &mutation, 10).unwrap_or_else(|error| panic!("{error}"))
        };
        // Open, the inner module could look at all of what it is given.
        assert_eq!((stuck("never", &["inner"]), stuck("never", &[])), (Proof::Equivalent, Proof::Equivalent));
        let unused = "kept -wirebit 1";
        assert_eq!((stuck(unused, &["inner"]), stuck(unused, &[])), (Proof::Different, Proof::Equivalent));
    }

    /// A register after each of two comparisons of a number, of which one never holds where that is asserted.
    fn comparisons(asserts: bool) -> Subject {
        let mut m = Module::new("unit", "Sees numbers.");
        let x = m.input("x", 2);
        let [never, zero] = [("never", 3), ("zero", 0)].map(|(name, value)| m.wire(name, x.eq_lit(value)));
        for (name, seen) in [("never_seen", never), ("zero_seen", zero)] {
            let register = m.reg_reset(name, 1, 0);
            m.next(register, seen);
            m.output(&format!("{name}_before"), register);
        }
        if asserts {
            m.assert("in_range", !never);
        }
        let design = elaborate(&m).unwrap_or_else(|error| panic!("{error}"));
        subject(&VerilogSource::from(&design).verilog, "", None, "unit")
    }

    #[test]
    fn what_an_assertion_rules_out_does_not_count() {
        let [open, ruled] = [false, true].map(comparisons);
        let stuck = |subject, wire: &str| {
            proof(subject, &format!("mutate -list 1 -mode const0 -wire {wire} -o chosen\nscript chosen\n"))
        };
        let Some(anything) = stuck(&open, "never") else { return };
        assert_eq!((anything, stuck(&ruled, "never")), (Proof::Different, Some(Proof::Equivalent)));
        assert_eq!(stuck(&ruled, "zero"), Some(Proof::Different));
    }

    #[test]
    fn a_mutant_is_where_it_was_listed() {
        let Ok(yosys) = Tool::yosys() else {
            pointcore_tb::skipped::skipped("no yosys that is new enough: `make setup-fpga` installs it");
            return;
        };
        let subject = comparisons(true);
        let folder = tempfile::tempdir().unwrap_or_else(|error| panic!("{error}"));
        let schemata = Schemata::new(&yosys, folder.path(), &subject, 8, 1, 1);
        let schemata = schemata.unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(schemata.mutations.len(), 8);
        for mutation in &schemata.mutations {
            assert_ne!(proof(&subject, mutation), Some(Proof::Open), "{mutation}");
        }
    }

    #[test]
    fn what_no_stream_offers_does_not_count_and_what_waits_is_held() {
        let unit = "module unit(input clk, input rst, input in_valid, input in_x, output in_ready, output out_valid,\n\
            output out_x, output broken);\n\
            reg full, waited, kept;\nassign in_ready = full;\nassign out_valid = full;\nwire idle = in_x ^ waited;\n\
            assign out_x = full ? kept : idle;\nassign broken = waited && in_x != kept;\n\
            always @(posedge clk) begin\nwaited <= in_valid && !full && !rst;\nkept <= in_x;\n\
            full <= in_valid && !full && !rst;\nend\nendmodule\n";
        let port = |direction| move |name: &str| Port { name: name.to_owned(), width: 1, direction };
        let inputs = ["clk", "rst", "in_valid", "in_x"].map(port(Direction::Input));
        let outputs = ["in_ready", "out_valid", "out_x", "broken"].map(port(Direction::Output));
        let streams = vec![
            StreamDeclaration::stream("in", Direction::Input, ["x"]),
            StreamDeclaration::pulse("out", "valid", Direction::Output, ["x"]),
        ];
        let ports = [inputs, outputs].concat();
        let source = VerilogSource { verilog: unit.to_owned(), top: "unit".to_owned(), ports, streams };
        let strict = subject(unit, "", None, "unit");
        let tolerant = Subject { comparison: Some(side_by_side::side_by_side(&source)), ..strict.clone() };
        let stuck = |subject, wire: &str| {
            proof(subject, &format!("mutate -list 1 -mode const0 -wire {wire} -o chosen\nscript chosen\n"))
        };
        for (wire, expected) in [("idle", Proof::Equivalent), ("broken", Proof::Equivalent), ("kept", Proof::Different)]
        {
            let Some(strictly) = stuck(&strict, wire) else { return };
            assert_eq!((strictly, stuck(&tolerant, wire)), (Proof::Different, Some(expected)), "{wire}");
        }
    }
}
