//! Both versions of a module as yosys has them side by side.

use super::planted::FAULT;
use super::way::{self, Marks, Way};
use super::{Proof, Prover, followed, one_reset, plain, search};
use crate::mutation::MutationError;
use crate::mutation::schemata::NETLIST;
use crate::mutation::side_by_side::{self, Border};
use crate::note;
use pointcore_tb::cache::file;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Compares all outputs in every cycle.
const MITER: &str = "miter -equiv -flatten gold gate miter\n";

/// A folder of its own for each comparison.
pub(super) struct Folder(TempDir);

impl Folder {
    pub fn new() -> Result<Self, MutationError> {
        Ok(Self(tempfile::tempdir().map_err(file("create a folder in", &std::env::temp_dir()))?))
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    pub fn write(&self, name: &str, text: &str) -> Result<(), MutationError> {
        let path = self.path().join(name);
        Ok(fs::write(&path, text).map_err(file("write", &path))?)
    }

    fn read(&self, name: &str) -> Result<String, MutationError> {
        let path = self.path().join(name);
        Ok(fs::read_to_string(&path).map_err(file("read", &path))?)
    }
}

impl Prover<'_> {
    /// Compares both in one way; of what yosys cannot prepare nothing is claimed.
    pub(super) fn compare_as(&self, module: &str, open: &BTreeSet<&str>, way: Way<'_>) -> Result<Proof, MutationError> {
        let folder = Folder::new()?;
        let verilog = &self.subject.verilog;
        let has_one_reset = way.has_one_reset() && one_reset::has_reset(verilog, plain(module));
        let mut texts = [verilog.clone(), assuming_assertions(verilog)];
        if has_one_reset {
            texts = texts.map(|text| one_reset::with_one_reset(&text, plain(module)));
        }
        folder.write("source.v", &texts[0])?;
        folder.write("assuming.v", &texts[1])?;
        folder.write("first_cycle.v", one_reset::FIRST_CYCLE)?;
        folder.write("delays.v", followed::DELAYS)?;
        folder.write("library.v", &self.subject.others)?;
        folder.write("versions.ys", &self.versions(module, open, way))?;
        if !self.prepare(&folder, "versions.ys", way) {
            return Ok(Proof::Open);
        }
        let miter = match self.compared(&folder, module, open, way, has_one_reset)? {
            Some(border) => {
                folder.write("comparison.v", &border.side_by_side())?;
                format!(
                    "read_verilog -formal comparison.v\nhierarchy -top {0}\nproc\nflatten\nrename {0} miter\n",
                    side_by_side::MODULE
                )
            }
            None => MITER.to_owned(),
        };
        folder.write(
            "miter.ys",
            &format!(
                "read_rtlil versions.il\n{miter}chformal -lower\nhierarchy -top miter\nopt_clean\nmemory_map\nopt_clean\n\
                 techmap\nopt_clean\ndffunmap\nsimplemap\nopt_clean\nsetundef -undriven -zero\nsetundef -zero\n\
                 zinit -all\naigmap\nopt_clean\nwrite_aiger -symbols -zinit {}\n",
                search::MITER
            ),
        )?;
        if !self.prepare(&folder, "miter.ys", way) {
            return Ok(Proof::Open);
        }
        search::search(folder.path(), way, has_one_reset, self.seconds)
    }

    /// What makes both versions of a module, flat and with what is open turned round.
    fn versions(&self, module: &str, open: &BTreeSet<&str>, way: Way<'_>) -> String {
        let Self { subject, .. } = self;
        let top = &subject.top;
        let library = match subject.core {
            Some(_) => format!("read_verilog -overwrite library.v\nhierarchy -top {top}\nproc\n"),
            None => String::new(),
        };
        // Its inputs are outputs of the design, and its outputs inputs: whatever an open module may do.
        let each = |text: fn(&&str) -> String| open.iter().map(text).collect::<String>();
        let blackened = each(|name| format!("blackbox {name} $paramod*\\\\{name}\n"));
        let turned = each(|name| format!("expose -evert */t:{name} */t:$paramod*\\\\{name}\n"));
        let kept = way.kept(module);
        let read = format!(
            "{library}read_verilog first_cycle.v\nproc first_cycle\n{kept}{blackened}hierarchy -top {module}\n"
        );
        let flat = |name: &str, found: &str, before: &str, after: &str| {
            let [memory, delays] = [way.memory(), &way.delays(!found.is_empty())];
            format!(
                "{read}{found}{memory}\nflatten\n{delays}rename {module} {name}\n{before}{turned}opt_clean\n{after}\
                 setundef -undriven -zero\nsetundef -zero\ndesign -stash {name}\n"
            )
        };
        let Marks { before, after, shown } = way.marks();
        let [fault, tie] = self.planted();
        let found = if self.cell.is_some() { format!("select -assert-any */{FAULT}\n") } else { String::new() };
        let unreset = if way.has_one_reset() { self.no_reset_goes_through(module) } else { String::new() };
        let [gold, gate] = side_by_side::VERSIONS;
        let [gold, gate] = [flat(gold, "", "", ""), flat(gate, &found, &before, &after)];
        let source = |options: &str, name: &str| {
            format!("read_verilog -lib library.v\nread_verilog {options} {name}\nhierarchy -top {top}\n{NETLIST}")
        };
        let [assuming, mutated] = [source("-formal -D RTL_ASSERT", "assuming.v"), source("", "source.v")];
        // The mutant comes first: its cells have the names of a first reading.
        // No pass here may take a value for another because it is open: what is open was set to zero in both.
        format!(
            "{mutated}{fault}{unreset}{tie}{gate}design -reset\n{assuming}chformal -assert2assume\n{gold}design -reset\n\
             design -copy-from gold gold\ndesign -copy-from gate gate\n\
             {shown}tee -q -o ports portlist gold\nwrite_rtlil versions.il\n"
        )
    }

    /// Whether yosys comes to the end of a script: what it has to do may be too large for its memory.
    fn prepare(&self, folder: &Folder, script: &str, way: Way<'_>) -> bool {
        let done = self.yosys.run(&self.subject.top, folder.path(), &["-q", script]);
        if let (Err(error), Way::At(_)) = (&done, way) {
            note!("{}: undecided, for {error}", self.mutation);
        }
        done.is_ok()
    }

    /// The border at which they are compared, if it is known.
    fn compared(
        &self,
        folder: &Folder,
        module: &str,
        open: &BTreeSet<&str>,
        way: Way<'_>,
        has_one_reset: bool,
    ) -> Result<Option<Border>, MutationError> {
        let around = match way {
            Way::At(border) | Way::InTurns(border) | Way::Followed(border) => return Ok(border.cloned()),
            Way::Around(around) => around,
        };
        let known = self.border(plain(module), open).unwrap_or_default().with_ports(&folder.read("ports")?);
        let border = if has_one_reset { known.after_reset() } else { known };
        let mut answers = Vec::new();
        for _ in 0..around.operators.in_a_row() {
            let more = border.answers(&folder.read("reached")?);
            if more == answers {
                break;
            }
            folder.write("reached.ys", &format!("read_rtlil versions.il\n{}", way::reached(&more)))?;
            if !self.prepare(folder, "reached.ys", way) {
                break;
            }
            answers = more;
        }
        let compared = border.with_operators(&answers).with_compared(&folder.read("reached")?);
        Ok(Some(compared.expect("what yosys lists of a module's outputs is among its ports")))
    }
}

/// The design with assertions that hold in every cycle, to be assumed. Simulations with assertions spoil what a memory's
/// port reads while it is written; the mutant does not, and need not differ for that.
fn assuming_assertions(verilog: &str) -> String {
    let clocked = "always @(posedge clk) if (!rst) begin\n`ifdef FORMAL";
    let held = "always @* if (!rst) begin\n`ifdef FORMAL";
    verilog.replace(clocked, held).replace("_word <= ~words[", "_word <= words[")
}
