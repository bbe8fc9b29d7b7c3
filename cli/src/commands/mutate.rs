//! `pointcore mutate`: which small faults of the generated Verilog the shipped tests notice.

use super::{Failure, Output, existing, merge, numbers, progress, write};
use pointcore::configuration::{read_text, wrong};
use pointcore_lab::mutation::{
    Campaign, Event, MutationError, MutationRecord, Scope, Score, SelfTest, Settings, Suite,
};
use pointcore_lab::{LabError, note};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Arguments of `mutate`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Units whose lockstep tests are tried, by the names of their tests (search_sieve), and folders of packages whose own
    /// tests are (generated/tiny_knn); all units by default.
    subjects: Vec<String>,
    /// Mutants of each.
    #[arg(long, default_value_t = 100, value_parser = numbers::within(1_usize..=10_000, "1 to 10000 mutants"))]
    mutants: usize,
    /// Seed of their choice.
    #[arg(long, default_value_t = 1, value_parser = numbers::whole())]
    seed: u64,
    /// Tests at a time; by default as many as there are processors.
    #[arg(long, value_parser = numbers::within(1_usize..=256, "1 to 256 at a time"))]
    jobs: Option<usize>,
    /// Seconds for each proof that a mutant which was missed changes nothing; with 0 none is tried, and --again does it later.
    #[arg(long, default_value_t = 60, value_parser = numbers::within(0_u32..=86_400, "0 to 86400 seconds"))]
    proof_seconds: u32,
    /// Keep every score in this file as soon as it is known.
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Write the tables of this Markdown file anew from the record.
    #[arg(long, value_name = "FILE", requires = "record")]
    tables: Option<PathBuf>,
    /// Merge the record's figures into this file, as `mutation.UNIT.FIGURE`.
    #[arg(long, value_name = "FILE", requires = "record")]
    merge: Option<PathBuf>,
    /// Try only what the record says was missed, as with more time for proofs or after a change of the tests.
    #[arg(long, requires = "record")]
    again: bool,
    /// Try only what the record has no score of, or one of other Verilog, as after a change of the hardware.
    #[arg(long, requires = "record", conflicts_with = "again")]
    changed: bool,
    /// Try nothing: write --tables and --merge from the record.
    #[arg(long, requires = "record", conflicts_with_all = ["subjects", "again", "changed"])]
    recorded: bool,
}

impl From<MutationError> for Failure {
    fn from(error: MutationError) -> Self {
        Self::Lab(LabError::Mutation(error))
    }
}

/// Tries the mutants of one subject after the other.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let mut record = arguments.record.as_deref().map_or(Ok(MutationRecord::default()), MutationRecord::load)?;
    if let Some(path) = &arguments.merge {
        existing(path)?;
    }
    let scope = match (arguments.again, arguments.changed) {
        (true, _) => Scope::Missed(record.clone()),
        (_, true) => Scope::Changed(record.clone()),
        _ => Scope::All,
    };
    let mut scores = Vec::new();
    if !arguments.recorded {
        let keep = |score: Score| {
            note!("{}", line(&score));
            score.missed.iter().for_each(|missed| note!("  missed: {missed}"));
            scores.push(score.clone());
            record.insert(score);
            arguments.record.as_ref().map_or(Ok(()), |path| write(path, &record.text()))
        };
        try_all(arguments, scope, keep)?;
    }
    if let Some(path) = &arguments.merge {
        merge(path, record.figures())?;
    }
    if let Some(path) = &arguments.tables {
        let text = record.tabulate(&read_text(path)?).map_err(|error| wrong(path, error.to_string()))?;
        write(path, &text)?;
    }
    let lines: Vec<_> = scores.iter().map(line).collect();
    output.print(&scores, &lines.join("\n"))
}

fn line(score: &Score) -> String {
    let Score { name, mutants, found, equivalent, missed, .. } = score;
    let (percent, missed) = (score.percent(), missed.len());
    format!("{name}: {found} of {mutants} mutants found, {equivalent} change nothing, {missed} missed ({percent:.1} %)")
}

fn try_all(
    arguments: &Arguments,
    scope: Scope,
    mut keep: impl FnMut(Score) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let settings = Settings {
        mutants: arguments.mutants,
        seed: arguments.seed,
        jobs: arguments.jobs.unwrap_or(processors),
        proof_seconds: arguments.proof_seconds,
    };
    let campaign = Campaign::new(settings, scope)?;
    let is_folder = |subject: &String| Path::new(subject).is_dir() || subject.contains(std::path::is_separator);
    let (packages, mut units): (Vec<_>, Vec<_>) = arguments.subjects.iter().cloned().partition(is_folder);
    for package in packages {
        for test in SelfTest::all(Path::new(&package)).map_err(MutationError::from)? {
            keep(watched(|progress| test.run(&campaign, progress))?)?;
        }
    }
    if units.is_empty() && !arguments.subjects.is_empty() {
        return Ok(());
    }
    let suite = progress::with_spinner("building the tests", Suite::build)?;
    if units.is_empty() {
        units = suite.units().into_iter().map(str::to_owned).collect();
    }
    for unit in units {
        keep(watched(|progress| suite.try_unit(&unit, &campaign, progress))?)?;
    }
    Ok(())
}

/// Shows how far the mutants of a subject are.
fn watched<T>(run: impl FnOnce(&(dyn Fn(Event) + Sync)) -> Result<T, MutationError>) -> Result<T, MutationError> {
    let (total, done) = (AtomicU64::new(1), AtomicU64::new(0));
    progress::with_count("mutants", 100, |progress| {
        run(&|event| {
            match event {
                Event::Listed(count) | Event::Missed(count) => {
                    total.store(count.max(1) as u64, Ordering::Relaxed);
                    done.store(0, Ordering::Relaxed);
                }
                Event::Tried | Event::Judged => _ = done.fetch_add(1, Ordering::Relaxed),
            }
            progress(100 * done.load(Ordering::Relaxed) / total.load(Ordering::Relaxed));
        })
    })
}
