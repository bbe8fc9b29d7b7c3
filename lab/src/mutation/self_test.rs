//! The tests of a package, as `pointcore gen` writes them and FuseSoC runs them, with mutants of what they test.

use super::MutationError;
use super::campaign::{Campaign, Event, Score, Subject, Tests};
use super::modules::Modules;
use super::process::{self, Verdict, output};
use super::record::SELF_TEST;
use pointcore::bus::Bus;
use pointcore::configuration::{self, ConfigurationError, read_text, wrong};
use pointcore::generated::GenerateError;
use pointcore_tb::cache::file;
use pointcore_tb::verilated::ModuleInterface;
use rtl::elaborate;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

/// As the package's FuseSoC core has it built.
const ARGUMENTS: [&str; 8] =
    ["--binary", "--x-initial", "unique", "-O3", "-Wno-lint", "-Wno-style", "-Wno-fatal", "-j"];
/// The same for what is started.
const RUN_ARGUMENT: &str = "+verilator+rand+reset+2";
/// What the names of a package's files begin with.
const CORES: [&str; 3] = ["splat", "search", "points"];
/// The ends of the names of a package's files: a module, its test, and what the test reads.
const PARTS: [(&str, &str); 2] = [("_top", "_test"), ("_axi", "_axi_test")];

/// A module of a package, with the test that ships with it.
#[derive(Clone, Debug)]
pub struct SelfTest<'a> {
    folder: &'a Path,
    name: String,
    module: String,
    test: String,
}

impl<'a> SelfTest<'a> {
    /// Those of the package in `folder`: `search_top.v` with `search_test.sv`, `search_axi.v` with `search_axi_test.sv`.
    ///
    /// # Errors
    /// There is no such package.
    pub fn all(folder: &'a Path) -> Result<Vec<Self>, ConfigurationError> {
        let package = folder.file_name().unwrap_or_default().to_string_lossy();
        let core = CORES.into_iter().find(|core| folder.join(format!("{core}_top.v")).exists());
        let core = core
            .ok_or_else(|| wrong(folder, "no package: expected a splat_top.v, search_top.v or points_top.v in it"))?;
        let one = |(module, test): (&str, &str)| Self {
            folder,
            name: format!("{SELF_TEST}{package}{}", module.trim_start_matches("_top")),
            module: format!("{core}{module}"),
            test: format!("{core}{test}"),
        };
        Ok(PARTS.into_iter().map(one).collect())
    }

    /// Tries mutants of the module.
    ///
    /// # Errors
    /// A file is missing, the test fails without a mutant, or a tool fails.
    pub fn run(&self, campaign: &Campaign, progress: &(dyn Fn(Event) + Sync)) -> Result<Score, MutationError> {
        let Self { folder, name, module, test } = self;
        let scratch = tempfile::tempdir().map_err(file("create a folder in", &std::env::temp_dir()))?;
        let work = scratch.path();
        let verilog = read_text(&folder.join(format!("{module}.v")))?;
        // A top on AXI has the core beside it, which is tried by its own test.
        let core = module.strip_suffix("_axi").map(|core| format!("{core}_top"));
        let others = core.as_ref().map(|core| read_text(&folder.join(format!("{core}.v")))).transpose()?;
        let others = others.unwrap_or_default();
        for entry in fs::read_dir(folder).map_err(file("read", folder))? {
            let source = entry.map_err(file("read", folder))?.path();
            let name = source.file_name().unwrap_or_default();
            if name == format!("{test}.sv").as_str() || source.extension().is_some_and(|ending| ending == "hex") {
                fs::copy(&source, work.join(name)).map_err(file("copy", &source))?;
            }
        }
        let others_path = work.join("others.v");
        fs::write(&others_path, &others).map_err(file("write", &others_path))?;
        let mutated = work.join("mutated-design.v");
        let (top, tests) = (module.clone(), Tests::all([test.clone()]));
        let interfaces = self.interfaces()?;
        let modules = Modules::of(&verilog).names().map(str::to_owned).collect();
        let subject = Subject { verilog, modules, others, core, top, interfaces, tests, substitute: mutated };
        let run = |_: &Tests, number: u32, limit: Duration| {
            let program = work.join("obj_dir").join(format!("V{test}"));
            if !program.exists() {
                build(work, test)?;
            }
            let mut command = Command::new(program);
            command.args([RUN_ARGUMENT, &format!("+mutant={number}")]).current_dir(work);
            let verdict = process::run(command, limit, |line| line.contains("FAILED"))?;
            Ok::<Verdict, MutationError>(verdict)
        };
        campaign.run(name, &[subject], work, run, progress)
    }

    /// What the modules show to each other, which their Verilog does not tell.
    fn interfaces(&self) -> Result<Vec<ModuleInterface>, MutationError> {
        let path = self.folder.join("config.toml");
        let configuration = configuration::parse(&path, &read_text(&path)?)?;
        let design = match self.module.ends_with("_axi") {
            true => Bus::new(&configuration)?.design,
            false => elaborate(&*configuration.module()?).map_err(GenerateError::from)?,
        };
        Ok(design.interfaces().to_vec())
    }
}

fn build(work: &Path, test: &str) -> Result<(), MutationError> {
    let mut command = Command::new("verilator");
    command.args(ARGUMENTS).arg("2").args(["--top-module", test, "mutated-design.v", "others.v"]);
    output(command.arg(format!("{test}.sv")).current_dir(work)).map(drop)
}
