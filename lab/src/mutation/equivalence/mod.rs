//! Proofs that a mutant changes nothing that can be seen.
//!
//! Design and mutant run side by side on the same inputs, from all registers zero; ABC searches an invariant under which
//! no output ever differs, or inputs that show a difference. Where a module's streams are known, outputs count when they
//! count in lockstep, and inputs keep the rules of streams. The design's assertions are assumed, as simulations check
//! them: some say what its neighbors never do. Inputs are free otherwise, so a mutant counts even where only inputs show
//! it that no neighbor gives.

mod exhausted;
mod one_reset;

use super::MutationError;
use super::campaign::Subject;
use super::modules::{Instance, Modules};
use super::process::{self, Verdict};
use super::schemata::NETLIST;
use super::side_by_side::{self, Border};
use crate::note;
use crate::synthesis::Tool;
use pointcore_tb::cache::file;
use std::collections::BTreeSet;
use std::fmt;
use std::fs;
use std::process::Command;
use std::time::Duration;

/// The ABC that comes with Debian's yosys.
const ABC: &str = "yosys-abc";

/// Bits of a memory that is taken for registers.
const LARGEST_MEMORY_BITS: u32 = 2048;

/// What the names of floating-point operators begin with.
const OPERATORS: &str = "float_";

/// Cycles within which a difference is sought at first.
const SOON: u32 = 12;

/// With more text than this a module is a whole core: the prover comes to no end with it.
const LARGEST_BYTES: usize = 120_000;

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

/// Compares a design with its mutant: an operator of one operand on all of them, else first the module that is mutated, whatever the modules in it do, which is small; then
/// with what is in it but large memories and operators, unless that is large; then what surrounds it, likewise, which may hide
/// the difference or keep it from coming about.
pub fn prove(yosys: &Tool, subject: &Subject, mutation: &str, seconds: u32) -> Result<Proof, MutationError> {
    let module = argument(mutation, "-module").unwrap_or(&subject.top);
    let text = format!("{}\n{}", subject.verilog, subject.others);
    let (mutated, cell) = (plain(module), argument(mutation, "-cell"));
    Prover { yosys, subject, mutation, mutated, cell, seconds, modules: Modules::of(&text) }.judge(module)
}

/// What follows an option of a mutation.
fn argument<'a>(mutation: &'a str, name: &str) -> Option<&'a str> {
    mutation.split(' ').skip_while(|word| *word != name).nth(1)
}

/// How a module is compared with its mutant.
#[derive(Clone, Copy)]
enum Way<'a> {
    /// At its border, if that is known.
    At(Option<&'a Border>),
    /// There, too, with one reset of the module and what is in it, which comes first: where a phase then tells when something is
    /// looked at, all cycles of its turn become one. A reset may come at any other time; nothing depends on what registers hold
    /// then, as tests say that begin with random values. Of a fault in this cell that a reset goes through nothing is claimed.
    InTurns(Option<&'a Border>),
    /// At the registers near the mutated cell: these and those that have a reset are registers in both, all others inputs,
    /// equal in both, and what they take next is compared, with one reset and in turns, too. That is small in a module of
    /// any size. It shows that what holds is as it was when it is looked at.
    Around(Around<'a>),
}

impl Way<'_> {
    /// Whether there is one reset, where the module has any.
    const fn has_one_reset(self) -> bool {
        !matches!(self, Self::At(_))
    }
}

/// Near what, and how.
#[derive(Clone, Copy)]
struct Around<'a> {
    /// The mutated cell.
    cell: &'a str,
    operators: Operators,
    /// What it holds first, where it is a register; else zero.
    first: Option<&'a str>,
}

/// What operators may be given.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Operators {
    /// The same in every cycle.
    Strict,
    /// Something else, which they then answer to.
    Tolerant,
}

/// What yosys calls registers.
const REGISTER: &str = "$procdff";

/// So many registers behind a mutated cell are near it: what looks at a register in every cycle may itself not be looked at.
const NEAR: usize = 3;

/// In yosys' words, the next registers behind what is selected.
const NEXT: &str = " %co*:-$dff %co2:+$dff[D,Q]";

/// Registers that have a reset tell the time: phases, pointers, counts.
const CONTROL: &str = "select -set control */w:one_reset */w:first_cycle.first %u %co2:+$mux[S,Y] %co2:+$dff[D,Q]\n";

/// Has both versions show their registers but for these and those that are marked as near.
const SHOWN: &str = "expose -cut -dff -shared */w:* */w:first_cycle.* %d @control %d */a:near %d\n";

/// Compares all outputs in every cycle.
const MITER: &str = "miter -equiv -flatten gold gate miter\n";

/// What proofs about one mutant share.
struct Prover<'a> {
    yosys: &'a Tool,
    subject: &'a Subject,
    mutation: &'a str,
    /// The module that is mutated, and the cell in it.
    mutated: &'a str,
    cell: Option<&'a str>,
    seconds: u32,
    modules: Modules<'a>,
}

/// What the prover comes to no end with: a memory of more bits than that is a flood of registers, and operators compute.
fn is_hard(instance: &Instance<'_>) -> bool {
    let is_large_memory = |[width, depth]: [u32; 2]| width * depth > LARGEST_MEMORY_BITS;
    instance.of.starts_with(OPERATORS) || instance.memory_size().is_some_and(is_large_memory)
}

/// What the text calls a module: of one with parameters, yosys' name ends with it.
fn plain(module: &str) -> &str {
    module.rsplit('\\').next().unwrap_or(module)
}

impl Prover<'_> {
    /// Whether nobody sees a difference outside of `module`, or of all that place it.
    fn judge(&self, module: &str) -> Result<Proof, MutationError> {
        let Self { subject, modules, .. } = self;
        let name = plain(module);
        let is_core = |name: &str| subject.core.as_deref() == Some(name);
        let is_mutated = name == self.mutated;
        // Where a port is mutated, the instance may not look at it: what it does shows that. A memory looks at all.
        let has_mutated_port =
            |inner: &Instance<'_>| is_mutated && self.cell == Some(inner.name) && inner.memory_size().is_none();
        let holds_mutated = |inner: &Instance<'_>| modules.within(inner.of, is_core).contains(&self.mutated);
        let inside = modules.inside(name);
        let mutated = inside.iter().filter(|inner| has_mutated_port(inner) || holds_mutated(inner));
        let mutated: BTreeSet<&str> = mutated.map(|inner| inner.of).collect();
        let within = modules.within(name, is_core);
        let hard = within.iter().flat_map(|module| modules.inside(module)).filter(is_hard);
        let inside: Vec<&str> = inside.iter().map(|inner| inner.of).collect();
        let cores = inside.iter().copied().filter(|inner| is_core(inner));
        let whole = cores.chain(hard.map(|inner| inner.of)).filter(|inner| *inner != self.mutated).collect();
        let open: BTreeSet<&str> =
            inside.iter().copied().filter(|inner| is_core(inner) || !mutated.contains(inner)).collect();
        let is_large = |within: &[&str]| modules.bytes(within) > LARGEST_BYTES;
        let is_small = !is_large(&modules.within(name, |inner| open.contains(inner)));
        let exhausted = if is_mutated { self.exhaust(name)? } else { None };
        let mut proof = exhausted.unwrap_or(Proof::Open);
        if proof == Proof::Open && (is_mutated || is_small) {
            proof = self.compare(module, &open)?;
            if proof != Proof::Equivalent && self.is_hidden_near(module, &open)? {
                return Ok(Proof::Equivalent);
            }
        }
        if proof != Proof::Equivalent && open != whole && !is_large(&within) {
            proof = self.compare(module, &whole)?;
        }
        if proof == Proof::Equivalent || name == subject.top {
            return Ok(proof);
        }
        for outer in modules.around(name) {
            proof = self.judge(outer)?;
            if proof != Proof::Equivalent {
                break;
            }
        }
        Ok(proof)
    }

    /// What yosys calls the mutated cell in a module: around the one that is mutated, where all is one, its name ends so.
    fn name_in(&self, module: &str, cell: &str) -> String {
        if module == self.mutated { cell.to_owned() } else { format!("$flatten*.{cell}") }
    }

    /// Says that the mutated cell is not between a reset and a register, before it is mutated: what registers hold in a reset that
    /// does not get to them is not asked.
    fn no_reset_goes_through(&self) -> String {
        let [of, cell] = [self.mutated, self.cell.unwrap_or_default()];
        let each = |object: &str| format!("{of}/{object} $paramod*\\\\{of}/{object} %u");
        let resets = [each("i:rst"), each("w:one_reset")].join(" ");
        format!("select -assert-none {} {resets} %u %co*:-$dff %i\n", each(&format!("c:{cell}")))
    }

    /// The border of a module as the generator knows it.
    fn known(&self, module: &str) -> Option<Border> {
        self.subject.interfaces.iter().find(|interface| interface.name == module).map(Border::from)
    }

    /// The border of a module out of which some were taken, if all of them are known.
    fn border(&self, module: &str, open: &BTreeSet<&str>) -> Option<Border> {
        let mut border = self.known(module)?;
        self.take_out(&mut border, "", module, open)?;
        Some(border)
    }

    fn take_out(&self, border: &mut Border, path: &str, module: &str, open: &BTreeSet<&str>) -> Option<()> {
        for instance in self.modules.inside(module) {
            let place = format!("{path}{}", instance.name);
            if open.contains(instance.of) {
                let inner = self.known(instance.of).or_else(|| Border::memory(&instance))?;
                border.take_out(&place, &inner);
            } else {
                self.take_out(border, &format!("{place}."), instance.of, open)?;
            }
        }
        Some(())
    }

    /// Compares a module of the design with its mutant, whatever the `open` ones in it do. The proof is easiest where operators are given the
    /// same at all times; where they are not, it may be that their answers do not count.
    fn compare(&self, module: &str, open: &BTreeSet<&str>) -> Result<Proof, MutationError> {
        let tolerant = self.border(plain(module), open);
        let strict = tolerant.as_ref().map(Border::without_operators);
        let mut proof = self.compare_as(module, open, Way::At(strict.as_ref()))?;
        let mut border = strict.as_ref();
        if let Some(tolerant) =
            tolerant.as_ref().filter(|tolerant| proof != Proof::Equivalent && tolerant.has_operators())
        {
            proof = self.compare_as(module, open, Way::At(Some(tolerant)))?;
            border = Some(tolerant);
        }
        if proof == Proof::Open && self.cell.is_some() && one_reset::has_reset(&self.subject.verilog, plain(module)) {
            proof = self.compare_as(module, open, Way::InTurns(border.map(Border::after_reset).as_ref()))?;
        }
        Ok(proof)
    }

    /// Whether no register near the mutated cell shows a difference where it is looked at: whatever operators do, or as what they are
    /// given says. A register that inverts a bit may begin with it the other way.
    fn is_hidden_near(&self, module: &str, open: &BTreeSet<&str>) -> Result<bool, MutationError> {
        let Some(cell) = self.cell.map(|cell| self.name_in(plain(module), cell)) else { return Ok(false) };
        let bit = argument(self.mutation, "-portbit").filter(|_| cell.contains(REGISTER));
        let one = bit.and_then(|bit| bit.parse().ok()).map(|bit: usize| format!("{}'b1{}", bit + 1, "0".repeat(bit)));
        let around = |operators, first| Way::Around(Around { cell: &cell, operators, first });
        let strictly = self.compare_as(module, open, around(Operators::Strict, None))?;
        let has_operators = self.border(plain(module), open).is_some_and(|border| border.has_operators());
        if strictly == Proof::Equivalent || !has_operators {
            return Ok(strictly == Proof::Equivalent);
        }
        let proof = self.compare_as(module, open, around(Operators::Tolerant, None))?;
        if proof == Proof::Equivalent || one.is_none() {
            return Ok(proof == Proof::Equivalent);
        }
        Ok(self.compare_as(module, open, around(Operators::Tolerant, one.as_deref()))? == Proof::Equivalent)
    }

    /// Compares them in one way; of what yosys cannot prepare nothing is claimed.
    fn compare_as(&self, module: &str, open: &BTreeSet<&str>, way: Way<'_>) -> Result<Proof, MutationError> {
        let Self { yosys, subject, mutation, seconds, .. } = *self;
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
        let read =
            format!("{library}read_verilog first_cycle.v\nproc first_cycle\n{blackened}hierarchy -top {module}\n");
        // What operators answer is near what they are given where that may differ.
        let flat = |name: &str, before: &str, after: &str| {
            format!(
                "{read}memory\nflatten\nrename {module} {name}\n{before}{turned}opt_clean\n{after}\
                 setundef -undriven -zero\nsetundef -zero\ndesign -stash {name}\n"
            )
        };
        let [unreset, before, after, shown] = match way {
            Way::At(_) => Default::default(),
            Way::InTurns(_) => [self.no_reset_goes_through(), String::new(), String::new(), String::new()],
            Way::Around(around) => {
                let (marked, shown) = (around.mark(), format!("{CONTROL}{SHOWN}"));
                match around.operators {
                    Operators::Strict => [self.no_reset_goes_through(), String::new(), marked, shown],
                    Operators::Tolerant => [self.no_reset_goes_through(), marked, String::new(), shown],
                }
            }
        };
        let [gold, gate] = side_by_side::VERSIONS;
        let [gold, gate] = [flat(gold, "", ""), flat(gate, &before, &after)];
        let source = |options: &str, name: &str| {
            format!("read_verilog -lib library.v\nread_verilog {options} {name}\nhierarchy -top {top}\n{NETLIST}")
        };
        let [assuming, mutated] = [source("-formal -D RTL_ASSERT", "assuming.v"), source("", "source.v")];
        let mut texts = [subject.verilog.clone(), assuming_assertions(&subject.verilog)];
        let has_one_reset = way.has_one_reset() && one_reset::has_reset(&self.subject.verilog, plain(module));
        if has_one_reset {
            texts = texts.map(|text| one_reset::with_one_reset(&text, plain(module)));
        }
        // The mutant comes first: its cells have the names of a first reading.
        // No pass here may take a value for another because it is open: what is open was set to zero in both.
        let versions = format!(
            "{mutated}{unreset}{mutation}\n{gate}design -reset\n{assuming}chformal -assert2assume\n{gold}design -reset\n\
             design -copy-from gold gold\ndesign -copy-from gate gate\n\
             {shown}tee -q -o ports portlist gold\nwrite_rtlil versions.il\n"
        );
        let write = |name: &str, text: &str| {
            let path = folder.join(name);
            fs::write(&path, text).map_err(file("write", &path))
        };
        write("source.v", &texts[0])?;
        write("assuming.v", &texts[1])?;
        write("first_cycle.v", one_reset::FIRST_CYCLE)?;
        write("library.v", &subject.others)?;
        write("versions.ys", &versions)?;
        let prepare = |script: &str| {
            let done = yosys.run(top, folder, &["-q", script]);
            // It may be too large for yosys' memory; nothing is claimed of it then.
            if let (Err(error), Way::At(_)) = (&done, way) {
                note!("{mutation}: undecided, for {error}");
            }
            done.is_ok()
        };
        if !prepare("versions.ys") {
            return Ok(Proof::Open);
        }
        let border = match way {
            Way::At(border) | Way::InTurns(border) => border.cloned(),
            Way::Around(around) => {
                let path = folder.join("ports");
                let ports = fs::read_to_string(&path).map_err(file("read", &path))?;
                let known = self.border(plain(module), open).unwrap_or_default().with_ports(&ports);
                let border = if has_one_reset { known.after_reset() } else { known };
                Some(if around.operators == Operators::Strict { border.without_operators() } else { border })
            }
        };
        let miter = match &border {
            Some(border) => {
                write("comparison.v", &border.side_by_side())?;
                format!(
                    "read_verilog -formal comparison.v\nhierarchy -top {0}\nproc\nflatten\nrename {0} miter\n",
                    side_by_side::MODULE
                )
            }
            None => MITER.to_owned(),
        };
        write(
            "miter.ys",
            &format!(
                "read_rtlil versions.il\n{miter}chformal -lower\nhierarchy -top miter\nmemory_map\nopt_clean\n\
                 techmap\nopt_clean\ndffunmap\nsimplemap\nopt_clean\nsetundef -undriven -zero\nsetundef -zero\n\
                 zinit -all\naigmap\nopt_clean\nwrite_aiger -zinit miter.aig\n"
            ),
        )?;
        if !prepare("miter.ys") {
            return Ok(Proof::Open);
        }
        // What is assumed is so after the reset.
        let reset = if has_one_reset { "strash; cycle -F 1; " } else { "" };
        let ask = |question: &str, limit: u32| {
            let mut command = Command::new(ABC);
            command.args(["-c", &format!("read_aiger miter.aig; {reset}fold; strash; {question}")]).current_dir(folder);
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
        };
        Ok(match ask(&format!("{sweep}; pdr -T {search}"), patience)? {
            Verdict::Failed(text) if text.contains(PROVED) => Proof::Equivalent,
            Verdict::Failed(text) if text.contains(REFUTED) => Proof::Different,
            // Without an answer it came to its end, to that of its time, or to that of the memory there is.
            Verdict::Passed | Verdict::Failed(_) | Verdict::Stuck => Proof::Open,
        })
    }
}

impl Around<'_> {
    /// Marks what is near. The cell must be there.
    fn mark(self) -> String {
        let Self { cell, first, .. } = self;
        let first =
            first.map_or(String::new(), |first| format!("setattr -set init {first} gate/c:{cell} %co:+$dff[Q]\n"));
        format!(
            "select -assert-any gate/c:{cell}\n{first}\
             setattr -set near 1 gate/c:{cell}{}\n",
            NEXT.repeat(NEAR)
        )
    }
}

/// The design with assertions that hold in every cycle, to be assumed. Simulations with assertions spoil what a memory's
/// port reads while it is written; the mutant does not, and need not differ for that.
fn assuming_assertions(verilog: &str) -> String {
    let clocked = "always @(posedge clk) if (!rst) begin\n`ifdef FORMAL";
    let held = "always @* if (!rst) begin\n`ifdef FORMAL";
    verilog.replace(clocked, held).replace("_word <= ~words[", "_word <= words[")
}

/// Takes cycles that follow each other in turns together, up to 24 of them: what was inverted between two looks is not there then.
const IN_TURNS: &str = "lcorr; scorr; phase -F 2; lcorr; scorr; phase -F 2; lcorr; scorr; phase -F 2; phase -F 3; orpos; lcorr; scorr; scorr -F 4";

/// What ABC says of a property that holds, and of one that does not.
const PROVED: &str = "Property proved";
const REFUTED: &str = "was asserted in frame";

fn is_answer(line: &str) -> bool {
    line.contains(PROVED) || line.contains(REFUTED)
}

#[cfg(test)]
mod tests;
