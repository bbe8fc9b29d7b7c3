//! Mutants of some designs, each tried by the tests that build its design.

use super::MutationError;
use super::equivalence::{self, Proof};
use super::process::Verdict;
use super::record::MutationRecord;
use super::schemata::Schemata;
use crate::synthesis::Tool;
use pointcore_tb::cache::{file, key};
use pointcore_tb::verilated::ModuleInterface;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// How much longer than without a mutant a test may take, and what it may take at least.
const PATIENCE: u32 = 5;
const SHORTEST_LIMIT: Duration = Duration::from_secs(20);
/// What a test may take without a mutant, its builds included, and from then on.
const BUILD_LIMIT: Duration = Duration::from_secs(3600);
const LIMIT: Duration = Duration::from_secs(600);

/// How mutants are chosen and tried.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Mutants of a unit or package.
    pub mutants: usize,
    /// Seed of their choice.
    pub seed: u64,
    /// Tests at a time.
    pub jobs: usize,
    /// Seconds for the proof that a mutant which was missed changes nothing; none is tried with none.
    pub proof_seconds: u32,
}

/// What came of the mutants of a unit or package.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Score {
    /// The unit or package.
    pub name: String,
    /// Mutants that were tried.
    pub mutants: usize,
    /// Those that the tests found.
    pub found: usize,
    /// Those that provably change no output.
    pub equivalent: usize,
    /// The others, as yosys' commands.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missed: Vec<String>,
    /// Hash of the Verilog that was mutated.
    pub source: String,
}

impl Score {
    /// Whether a mutant is one of those that were missed.
    pub(super) fn misses(&self, mutant: &str) -> bool {
        self.missed.iter().any(|missed| missed.rsplit_once(" (").is_some_and(|(name, _)| name == mutant))
    }

    /// Found, of those that change something, in percent.
    #[must_use]
    pub fn percent(&self) -> f64 {
        100.0 * self.found as f64 / (self.mutants - self.equivalent).max(1) as f64
    }
}

/// Something happened to a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// So many will be tried.
    Listed(usize),
    /// One was tried.
    Tried,
    /// So many that were missed are now to be proved equivalent.
    Missed(usize),
    /// One was judged by the prover.
    Judged,
}

/// Tests, or some of their cases.
#[derive(Clone, Debug, Default)]
pub struct Tests {
    /// Their names.
    pub names: BTreeSet<String>,
    /// Numbers of the cases; all where there are none.
    pub cases: Option<BTreeSet<usize>>,
}

impl Tests {
    /// All cases of the tests with these names.
    pub fn all(names: impl IntoIterator<Item = String>) -> Self {
        Self { names: names.into_iter().collect(), cases: None }
    }
}

/// A design, and the tests that build it.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The modules that are mutated, and those in them that have tests of their own.
    pub verilog: String,
    /// Names of the modules that are mutated.
    pub modules: Vec<String>,
    /// Other modules of the design.
    pub others: String,
    /// The one of them that the top joins with the buses, and that is not mutated.
    pub core: Option<String>,
    /// Its top module.
    pub top: String,
    /// What modules show to each other, of those of which it is known: which outputs count when.
    pub interfaces: Vec<ModuleInterface>,
    /// The tests that build it.
    pub tests: Tests,
    /// Where the tests find what is built in its place.
    pub substitute: PathBuf,
}

/// A mutant of a subject.
struct Mutant<'a> {
    subject: &'a Subject,
    number: u32,
    mutation: String,
}

impl Mutant<'_> {
    /// What a record calls it.
    fn name(&self) -> String {
        format!("{}: {}", self.subject.top, self.mutation)
    }
}

/// What a campaign tries.
#[derive(Clone, Debug)]
pub enum Scope {
    /// All mutants.
    All,
    /// What a record says was missed, as with more time for proofs or after a change of the tests.
    Missed(MutationRecord),
    /// All mutants of what a record has no score of, or one of other Verilog.
    Changed(MutationRecord),
}

impl Scope {
    /// A score that need not be found anew.
    fn known(&self, name: &str, source: &str) -> Option<&Score> {
        let Self::Changed(record) = self else { return None };
        record.score(name).filter(|score| score.source == source)
    }
}

/// The tools, and how they are used.
#[derive(Clone, Debug)]
pub struct Campaign {
    yosys: Tool,
    settings: Settings,
    scope: Scope,
}

impl Campaign {
    /// With yosys as it is installed.
    ///
    /// # Errors
    /// There is none, or none that is new enough.
    pub fn new(settings: Settings, scope: Scope) -> Result<Self, MutationError> {
        Ok(Self { yosys: Tool::yosys()?, settings, scope })
    }

    /// Tries mutants of `subjects` by `run`, which is given tests, a number and a limit.
    pub(super) fn run(
        &self,
        name: &str,
        subjects: &[Subject],
        folder: &Path,
        run: impl Fn(&Tests, u32, Duration) -> Result<Verdict, MutationError> + Sync,
        progress: &(dyn Fn(Event) + Sync),
    ) -> Result<Score, MutationError> {
        let source = key(subjects.iter().map(|subject| subject.verilog.as_str()))[..16].to_owned();
        if let Some(score) = self.scope.known(name, &source) {
            return Ok(score.clone());
        }
        let mutants = self.mutants(subjects, folder)?;
        let (before, mutants) = self.asked(name, source, mutants)?;
        progress(Event::Listed(mutants.len()));
        let all = Tests::all(subjects.iter().flat_map(|subject| subject.tests.names.clone()));
        // The first run without a mutant builds, those of each subject are timed.
        let without = |tests: &Tests, limit: Duration| {
            let begin = Instant::now();
            let verdict = run(tests, 0, limit)?;
            if verdict.is_found() {
                return Err(MutationError::Baseline { name: name.to_owned(), output: format!("{verdict:?}") });
            }
            Ok(begin.elapsed())
        };
        without(&all, BUILD_LIMIT)?;
        let mut limits = BTreeMap::new();
        for Mutant { subject, .. } in &mutants {
            if !limits.contains_key(&subject.substitute) {
                let duration = without(&subject.tests, LIMIT)?;
                limits.insert(subject.substitute.clone(), SHORTEST_LIMIT.max(PATIENCE * duration));
            }
        }
        let try_one = |Mutant { subject, number, .. }: &Mutant<'_>| {
            let verdict = run(&subject.tests, *number, limits[&subject.substitute])?;
            progress(Event::Tried);
            Ok(verdict.is_found())
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(self.settings.jobs).build();
        let pool =
            pool.map_err(|error| MutationError::Program { program: "rayon".into(), output: error.to_string() })?;
        let found: Result<Vec<bool>, MutationError> = pool.install(|| mutants.par_iter().map(try_one).collect());
        let found = found?;
        let missed: Vec<_> =
            mutants.iter().zip(&found).filter(|(_, found)| !**found).map(|(mutant, _)| mutant).collect();
        progress(Event::Missed(missed.len()));
        let judge = |mutant: &&Mutant<'_>| {
            let proof = match self.settings.proof_seconds {
                0 => Ok(Proof::Open),
                seconds => equivalence::prove(&self.yosys, mutant.subject, &mutant.mutation, seconds),
            };
            progress(Event::Judged);
            proof
        };
        let proofs: Result<Vec<Proof>, MutationError> = pool.install(|| missed.par_iter().map(judge).collect());
        let proofs = proofs?;
        let left = missed.iter().zip(&proofs).filter(|(_, proof)| **proof != Proof::Equivalent);
        Ok(Score {
            found: before.found + found.iter().filter(|found| **found).count(),
            equivalent: before.equivalent + proofs.iter().filter(|proof| **proof == Proof::Equivalent).count(),
            missed: left.map(|(mutant, proof)| format!("{} ({proof})", mutant.name())).collect(),
            ..before
        })
    }

    /// The mutants that are to be tried, and the score of those that need not be.
    fn asked<'a>(
        &self,
        name: &str,
        source: String,
        mut mutants: Vec<Mutant<'a>>,
    ) -> Result<(Score, Vec<Mutant<'a>>), MutationError> {
        let none =
            Score { name: name.to_owned(), mutants: mutants.len(), found: 0, equivalent: 0, missed: vec![], source };
        let Scope::Missed(record) = &self.scope else { return Ok((none, mutants)) };
        let of_these = |score: &&Score| score.source == none.source && score.mutants == none.mutants;
        let before = record.score(name).filter(of_these);
        mutants.retain(|mutant| before.is_some_and(|score| score.misses(&mutant.name())));
        match before {
            Some(before) if mutants.len() == before.missed.len() => Ok((before.clone(), mutants)),
            _ => Err(MutationError::NotRecorded { name: none.name }),
        }
    }

    /// Mutants of all subjects, in their substitutes: each has its share.
    fn mutants<'a>(&self, subjects: &'a [Subject], folder: &Path) -> Result<Vec<Mutant<'a>>, MutationError> {
        let mut mutants: Vec<Mutant<'a>> = Vec::new();
        for (index, subject) in subjects.iter().enumerate() {
            let share = (self.settings.mutants - mutants.len()).div_ceil(subjects.len() - index);
            if share == 0 {
                continue;
            }
            let first = mutants.len() as u32 + 1;
            let schemata = Schemata::new(&self.yosys, folder, subject, share, self.settings.seed, first)?;
            fs::write(&subject.substitute, &schemata.verilog).map_err(file("write", &subject.substitute))?;
            let numbered = (first..).zip(schemata.mutations);
            mutants.extend(numbered.map(|(number, mutation)| Mutant { subject, number, mutation }));
        }
        Ok(mutants)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_did_not_change_is_not_tried_again() {
        let score =
            Score { name: "float".into(), mutants: 9, found: 9, equivalent: 0, missed: vec![], source: "a".into() };
        let mut record = MutationRecord::default();
        record.insert(score.clone());
        let changed = Scope::Changed(record.clone());
        assert_eq!(changed.known("float", "a"), Some(&score));
        assert_eq!([changed.known("float", "b"), changed.known("memory", "a")], [None, None]);
        assert_eq!([Scope::All, Scope::Missed(record)].map(|scope| scope.known("float", "a").cloned()), [None, None]);
    }
}
