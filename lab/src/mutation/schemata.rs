//! All mutants of a design in one text, chosen by a number.

use super::MutationError;
use super::campaign::Subject;
use crate::synthesis::Tool;
use pointcore_tb::cache::file;
use std::fs;
use std::path::Path;

/// The signal that chooses a mutant, and its bits; no mutant has the number 0.
const CHOICE: &str = "mutant";
const CHOICE_BITS: u32 = 16;

/// What brings a design to the netlist whose bits are mutated. Names of cells follow from it.
pub const NETLIST: &str = "proc\nopt_expr -keepdc\nopt_clean\n";

/// What is left as it is: the initial contents of memories, and when they are read, have to be constant. What goes into a read and
/// what comes out is mutated at the cells around it.
const CONSTANT: &str = "t:$meminit t:$meminit_v2 t:$memrd t:$memrd_v2 %u %u %u";

/// Warnings that a netlist written as Verilog earns: it is wide where it need not be, and mutants confuse bits of a word.
const LINT: &str = "WIDTH UNUSED UNDRIVEN UNOPTFLAT PINMISSING CASEINCOMPLETE CASEOVERLAP CMPCONST UNSIGNED \
    VARHIDDEN DECLFILENAME BLKSEQ INITIALDLY EOFNEWLINE";

/// A design with its mutants.
#[derive(Clone, Debug)]
pub struct Schemata {
    /// The text: `+mutant=NUMBER` on the simulator's command line chooses.
    pub verilog: String,
    /// yosys' commands that make the mutants, without the choice; the numbers count up from the first.
    pub mutations: Vec<String>,
}

impl Schemata {
    /// `count` mutants of the subject, numbered from `first` on. The folder is for yosys.
    pub fn new(
        yosys: &Tool,
        folder: &Path,
        subject: &Subject,
        count: usize,
        seed: u64,
        first: u32,
    ) -> Result<Self, MutationError> {
        let top = &subject.top;
        for (name, text) in [("source.v", &subject.verilog), ("library.v", &subject.others)] {
            let path = folder.join(name);
            fs::write(&path, text).map_err(file("write", &path))?;
        }
        // With parameters of its own, a module's name ends with what it is called in the text.
        let modules: String = subject.modules.iter().map(|name| format!("{name}/* $paramod*\\\\{name}/* ")).collect();
        let union = "%u ".repeat(2 * subject.modules.len() - 1);
        let selection = format!("{modules}{union}{CONSTANT} %d");
        let script = format!(
            "read_verilog -lib library.v\nread_verilog source.v\nhierarchy -top {top}\n{NETLIST}\
             mutate -list {count} -seed {seed} -ctrl {CHOICE} {CHOICE_BITS} {first} -o mutations {selection}\n\
             script mutations\ndelete -port */{CHOICE}\nwrite_verilog -noattr -norename mutated.v\n"
        );
        let path = folder.join("mutate.ys");
        fs::write(&path, script).map_err(file("write", &path))?;
        yosys.run(top, folder, &["-q", "mutate.ys"])?;
        let read = |name: &str| {
            let path = folder.join(name);
            fs::read_to_string(&path).map_err(file("read", &path))
        };
        let choose = format!("-ctrl {CHOICE} {CHOICE_BITS} ");
        let plain = |line: &str| match line.split_once(&choose) {
            Some((command, rest)) => command.to_owned() + rest.split_once(' ').map_or("", |(_, rest)| rest),
            None => line.to_owned(),
        };
        let mutations = read("mutations")?.lines().map(plain).collect();
        Ok(Self { verilog: chosen_by_argument(&read("mutated.v")?), mutations })
    }
}

/// The text with the choice, which nothing drives and modules have no port for, read from the simulator's command line by each
/// of them: a test may have a module alone.
fn chosen_by_argument(netlist: &str) -> String {
    let wire = format!("  wire [{}:0] {CHOICE};\n", CHOICE_BITS - 1);
    let variable = format!(
        "  reg [{}:0] {CHOICE};\n  initial if (!$value$plusargs(\"{CHOICE}=%d\", {CHOICE})) {CHOICE} = 0;\n",
        CHOICE_BITS - 1
    );
    let lint = LINT.split_whitespace().map(|rule| format!("/* verilator lint_off {rule} */\n"));
    let connection = format!("    .{CHOICE}({CHOICE})");
    // Where it is an instance's last, none follows those before it.
    let unconnected = netlist.replace(&format!(",\n{connection}\n"), "\n").replace(&format!("{connection},\n"), "");
    lint.collect::<String>() + &unconnected.replace(&wire, &variable)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_module_reads_the_command_line() {
        let netlist = "module a(x);\n  wire [15:0] mutant;\nendmodule\nmodule top(x);\n  wire [15:0] mutant;\n  \
            a first (\n    .mutant(mutant),\n    .x(x)\n  );\n  a last (\n    .x(x),\n    .mutant(mutant)\n  );\nendmodule\n";
        let text = chosen_by_argument(netlist);
        assert_eq!(text.matches("  reg [15:0] mutant;\n  initial if (!$value$plusargs(").count(), 2, "{text}");
        assert!(text.contains("a first (\n    .x(x)\n  );\n  a last (\n    .x(x)\n  );"), "{text}");
    }
}
