//! The lockstep tests of the units, as a program that runs with mutants.

use super::MutationError;
use super::campaign::{Campaign, Event, Score, Subject, Tests};
use super::modules::Modules;
use super::process::{self, Verdict, output};
use pointcore_tb::cache::file;
use pointcore_tb::verilated::substitute;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// What a unit's name begins with.
const ROOMS: [&str; 8] = ["memory", "float", "stream_", "splat_", "search_", "process_", "points_", "bus_"];
/// A unit's tests take seconds; one that takes this long without a mutant is stuck.
const LIMIT: Duration = Duration::from_secs(600);

/// The built tests.
#[derive(Clone, Debug)]
pub struct Suite {
    program: PathBuf,
    tests: Vec<String>,
}

impl Suite {
    /// Has cargo build the tests; the current folder is the project's.
    ///
    /// # Errors
    /// They cannot be built, or do not list their names.
    pub fn build() -> Result<Self, MutationError> {
        let arguments = ["test", "--workspace", "--test", "units", "--no-run", "--message-format=json"];
        let messages = output(Command::new("cargo").args(arguments))?;
        let executable = |line: &str| {
            let message: serde_json::Value = serde_json::from_str(line).ok()?;
            Some(PathBuf::from(message.get("executable")?.as_str()?))
        };
        let program = messages.lines().rev().find_map(executable).ok_or_else(|| MutationError::Program {
            program: "cargo".to_owned(),
            output: "it named no executable for `--test units`".to_owned(),
        })?;
        let listed = output(Command::new(&program).arg("--list"))?;
        let tests = listed.lines().filter_map(|line| line.strip_suffix(": test")).map(str::to_owned).collect();
        Ok(Self { program, tests })
    }

    /// The units whose tests these are.
    #[must_use]
    pub fn units(&self) -> BTreeSet<&str> {
        let unit = |test: &'_ String| test.split_once("::").map(|(unit, _)| unit.to_owned());
        let named: BTreeSet<_> = self.tests.iter().filter_map(unit).collect();
        let tests = self.tests.iter().filter_map(|test| test.split_once("::")).map(|(unit, _)| unit);
        tests.filter(|unit| named.contains(*unit) && ROOMS.iter().any(|room| unit.starts_with(room))).collect()
    }

    /// Tries mutants of all designs that a unit's tests build.
    ///
    /// # Errors
    /// The unit is unknown, its tests fail without a mutant, or a tool fails.
    pub fn try_unit(
        &self,
        unit: &str,
        campaign: &Campaign,
        progress: &(dyn Fn(Event) + Sync),
    ) -> Result<Score, MutationError> {
        if !self.units().contains(unit) {
            let known = self.units().into_iter().collect::<Vec<_>>().join(", ");
            return Err(MutationError::Unknown { name: unit.to_owned(), known });
        }
        let scratch = tempfile::tempdir().map_err(file("create a folder in", &std::env::temp_dir()))?;
        let folder = scratch.path();
        // Test threads have the names of their tests only if there are several.
        let all = Tests::all([format!("{unit}::")]);
        let seen = self.run(&all, folder, 0, LIMIT, &["--test-threads=2"])?;
        if seen.is_found() {
            return Err(MutationError::Baseline { name: unit.to_owned(), output: format!("{seen:?}") });
        }
        let subjects = self.subjects(unit, folder)?;
        let run = |tests: &Tests, number: u32, limit: Duration| {
            self.run(tests, folder, number, limit, &["--test-threads=1", "--exact"])
        };
        campaign.run(unit, &subjects, folder, run, progress)
    }

    /// The designs that were built, and by which tests.
    fn subjects(&self, unit: &str, folder: &Path) -> Result<Vec<Subject>, MutationError> {
        let path = folder.join(substitute::USES);
        let uses = fs::read_to_string(&path).map_err(file("read", &path))?;
        let of_unit = || self.tests.iter().filter(|test| test.starts_with(&format!("{unit}::"))).cloned();
        let mut builders: BTreeMap<(String, String), Tests> = BTreeMap::new();
        for line in uses.lines() {
            let mut words = line.split(' ').map(str::to_owned);
            let [Some(digest), Some(top), Some(test), Some(case)] = [(); 4].map(|()| words.next()) else { continue };
            let tests = || Tests { cases: Some(BTreeSet::new()), ..Tests::default() };
            let Tests { names, cases } = builders.entry((digest, top)).or_insert_with(tests);
            // What is built for no case is every case's.
            *cases = cases.take().zip(case.parse().ok()).map(|(cases, case)| &cases | &[case].into());
            // What a thread builds that is no test's own may be any test's.
            if self.tests.contains(&test) { names.extend([test]) } else { names.extend(of_unit()) }
        }
        let units = self.units();
        let elsewhere = |module: &str| home(&units, module).is_some_and(|home| home != unit);
        let subject = |((digest, top), tests): ((String, String), Tests)| {
            let read = |ending: &str| {
                let path = folder.join(format!("{digest}.{ending}"));
                fs::read_to_string(&path).map_err(file("read", &path))
            };
            let verilog = read(substitute::ORIGINAL)?;
            let modules = Modules::of(&verilog).within(&top, elsewhere);
            let modules = modules.into_iter().map(str::to_owned).collect();
            let interfaces = serde_json::from_str(&read(substitute::INTERFACES)?);
            let interfaces = interfaces.expect("the tests write what they have from the generator");
            let substitute = folder.join(digest + ".v");
            Ok(Subject { verilog, modules, others: String::new(), core: None, top, interfaces, tests, substitute })
        };
        builders.into_iter().map(subject).collect()
    }

    fn run(
        &self,
        tests: &Tests,
        substitutes: &Path,
        mutant: u32,
        limit: Duration,
        arguments: &[&str],
    ) -> Result<Verdict, MutationError> {
        let mut command = Command::new(&self.program);
        command.args(&tests.names).args(arguments).env(substitute::VARIABLE, substitutes);
        if let Some(cases) = &tests.cases {
            let numbers: Vec<_> = cases.iter().map(usize::to_string).collect();
            command.env(substitute::CASES, numbers.join(","));
        }
        command.env(substitute::ARGUMENT, format!("+mutant={mutant}"));
        process::run(command, limit, |line| line.starts_with("test ") && line.ends_with("FAILED"))
    }
}

/// The unit that a module is of: its name begins with the unit's.
fn home<'a>(units: &BTreeSet<&'a str>, module: &str) -> Option<&'a str> {
    let is_of = |unit: &&str| module.strip_prefix(*unit).is_some_and(|rest| rest.is_empty() || rest.starts_with('_'));
    units.iter().copied().filter(is_of).max_by_key(|unit| unit.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_module_is_at_home_in_one_unit() {
        let units = BTreeSet::from(["splat_heap", "splat_heap_stage", "float"]);
        let of = |module| home(&units, module);
        assert_eq!([of("splat_heap"), of("splat_heap_stage_l2")], [Some("splat_heap"), Some("splat_heap_stage")]);
        assert_eq!([of("float_add_s6"), of("floats"), of("splat")], [Some("float"), None, None]);
    }
}
