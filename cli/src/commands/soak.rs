//! `pointcore soak`: random configurations of both cores under random stimuli, in lockstep with their models.

use super::shard::{Shard, spread};
use super::{Failure, Output, existing, merge, numbers, write};
use pointcore::configuration::{parse, read_text, wrong};
use pointcore_lab::soak::campaign::Campaign;
use pointcore_lab::soak::case::CaseOutcome;
use pointcore_lab::soak::device::{AnyConfig, Core};
use pointcore_lab::soak::record::{SoakEntry, SoakRecord};
use pointcore_lab::synthesis::Revision;
use pointcore_lab::{LabError, note};
use pointcore_tb::cache::Cache;
use pointcore_tb::toolchain::Toolchain;
use pointcore_tb::verilated::{Builder, VerilatedError};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// The folder of compiled cores, in that of cases.
const VERILATED: &str = "verilated";

/// Arguments of `soak`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Seed of configurations and stimuli.
    #[arg(long, default_value_t = 1, value_parser = numbers::whole())]
    seed: u64,
    /// Cases, each a configuration: renderers and search cores in turns.
    #[arg(long, default_value_t = 100, value_parser = numbers::within(1_u64..=1_000_000, "1 to 1000000 cases"))]
    cases: u64,
    /// Cycles on each configuration, at least: the last run is brought to its end.
    #[arg(long, value_name = "CYCLES", default_value_t = 10_000_000, value_parser = numbers::within(1_u64.., "at least 1"))]
    cycles_per_configuration: u64,
    /// Cases at a time.
    #[arg(long, default_value_t = 1, value_parser = numbers::within(1_u16..=256, "1 to 256 at a time"))]
    jobs: u16,
    /// Run only every N-th case, from the I-th, and write nothing but these; the same command without it puts all together, and fails
    /// where a run of any shard was not clean.
    #[arg(long, value_name = "I/N", conflicts_with_all = ["case", "record"])]
    shard: Option<Shard>,
    /// The folder in which finished cases are kept, by default in cargo's target folder; several machines may share it.
    #[arg(long, value_name = "DIR")]
    kept: Option<PathBuf>,
    /// Run this case alone, as a failure names it, whether it is kept or not.
    #[arg(long, value_name = "N", value_parser = numbers::whole(), conflicts_with_all = ["cases", "record", "recorded"])]
    case: Option<u64>,
    /// Run the configuration of this file alone, in the place of random ones.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["case", "cases", "shard", "record", "recorded"])]
    configuration: Option<PathBuf>,
    /// Of the case or the configuration, make this run alone.
    #[arg(long, value_name = "N", value_parser = numbers::whole())]
    run: Option<u64>,
    /// Add what the cases came to to this file.
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// The revision of the project that is run, for the record: a commit's short hash or a date.
    #[arg(long, requires = "record")]
    revision: Option<Revision>,
    /// Write the table of this Markdown file anew from the record.
    #[arg(long, value_name = "FILE", requires = "record")]
    tables: Option<PathBuf>,
    /// Merge the record's sums into this file, as `soak.cycles` and the like.
    #[arg(long, value_name = "FILE", requires = "record")]
    merge: Option<PathBuf>,
    /// Run nothing: write --tables and --merge from the record.
    #[arg(long, requires = "record")]
    recorded: bool,
}

impl Arguments {
    fn campaign(&self) -> Result<Campaign, LabError> {
        let folder = self.kept.clone().unwrap_or_else(|| Cache::default_folder("soak"));
        let toolchain = Toolchain::find().map_err(VerilatedError::from)?;
        let builder = Builder::with(toolchain, folder.join(VERILATED));
        Ok(Campaign::new(self.seed, self.cycles_per_configuration, folder, builder))
    }

    /// The cases to be run.
    fn numbers(&self) -> Vec<u64> {
        match (self.case.or(self.configuration.as_ref().map(|_| 0)), self.shard) {
            (Some(case), _) => vec![case],
            (None, Some(shard)) => shard.of(0..self.cases),
            (None, None) => (0..self.cases).collect(),
        }
    }
}

/// Runs the cases that are not kept, and says what came of all.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    if arguments.run.is_some() && arguments.case.is_none() && arguments.configuration.is_none() {
        return Err(Failure::Usage(
            "--run is one of a case or configuration: expected --case or --configuration".into(),
        ));
    }
    if arguments.record.is_some() && arguments.revision.is_none() && !arguments.recorded {
        let problem = "--record needs the revision that is run: expected --revision, a commit's short hash or a date";
        return Err(Failure::Usage(problem.to_owned()));
    }
    // Files that are none are found before anything is run.
    let mut record = arguments.record.as_deref().map_or(Ok(SoakRecord::default()), SoakRecord::load)?;
    if let Some(path) = &arguments.merge {
        existing(path)?;
    }
    let outcomes = if arguments.recorded { Vec::new() } else { soak(arguments)? };
    if let (Some(path), Some(revision)) = (&arguments.record, &arguments.revision) {
        let Arguments { seed, cycles_per_configuration, .. } = *arguments;
        let entry = |core| SoakEntry::of(core, &outcomes, revision, seed, cycles_per_configuration);
        Core::ALL.into_iter().filter_map(entry).for_each(|entry| record.add(entry));
        write(path, &record.text())?;
    }
    if let Some(path) = &arguments.merge {
        merge(path, record.figures())?;
    }
    if let Some(path) = &arguments.tables {
        tabulate(&record, path)?;
    }
    if arguments.recorded {
        let figures = record.figures();
        let lines: Vec<_> = figures.iter().map(|(name, value)| format!("{name} {value}")).collect();
        return output.print(&figures, &lines.join("\n"));
    }
    let failures: Vec<_> = outcomes.iter().filter_map(failure).collect();
    output.print(&outcomes, &summary(&outcomes))?;
    if arguments.shard.is_some() {
        // What is kept is for whoever puts all together, and who fails then.
        failures.iter().for_each(|failure| note!("{failure}"));
        return Ok(());
    }
    if failures.is_empty() { Ok(()) } else { Err(Failure::Soak(failures.join("\n\n"))) }
}

fn tabulate(record: &SoakRecord, path: &Path) -> Result<(), Failure> {
    let text = record.tabulate(&read_text(path)?).map_err(|error| wrong(path, error.to_string()))?;
    write(path, &text)
}

/// A configuration of a core that is soaked.
fn configuration(path: &Path) -> Result<AnyConfig, Failure> {
    let other = || wrong(path, "is for the point processor: a soak needs `kind = \"splat\"` or `kind = \"search\"`");
    Ok(AnyConfig::of(parse(path, &read_text(path)?)?).ok_or_else(other)?)
}

/// What all cases came to; those that were finished are kept when one cannot be run.
fn soak(arguments: &Arguments) -> Result<Vec<CaseOutcome>, Failure> {
    let (campaign, numbers) = (arguments.campaign()?, arguments.numbers());
    let given = arguments.configuration.as_ref();
    let given = given.map(|path| Ok::<_, Failure>((path, configuration(path)?))).transpose()?;
    let (done, cycles) = (AtomicU64::new(0), AtomicU64::new(0));
    let outcomes = spread(&numbers, arguments.jobs, |&number| {
        let is_alone = arguments.case.is_some() || given.is_some();
        let kept = if is_alone { None } else { campaign.kept(number)? };
        let is_new = kept.is_none();
        let outcome = match (kept, &given) {
            (Some(outcome), _) => Ok(outcome),
            (None, Some((path, config))) => campaign.given(path, config.clone(), arguments.run),
            (None, None) if is_alone => campaign.again(number, arguments.run),
            (None, None) => campaign.run(number),
        };
        let outcome = outcome.inspect_err(|error| {
            note!("case {number} cannot be run (pointcore soak --seed {} --case {number}): {error}", arguments.seed);
        })?;
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        let all = cycles.fetch_add(outcome.cycles, Ordering::Relaxed) + outcome.cycles;
        if is_new {
            note!("{done} of {}: {}; {all} cycles so far", numbers.len(), line(&outcome));
        }
        Ok::<_, LabError>(outcome)
    });
    Ok(outcomes.into_iter().collect::<Result<_, _>>()?)
}

fn line(outcome: &CaseOutcome) -> String {
    let CaseOutcome { case, core, cycles, runs, failure, .. } = outcome;
    let end = if failure.is_some() { "then one that is not" } else { "all clean" };
    format!("case {case} ({}): {runs} runs in {cycles} cycles, {end}", core.name())
}

fn summary(outcomes: &[CaseOutcome]) -> String {
    let sum = |count: fn(&CaseOutcome) -> u64| outcomes.iter().map(count).sum::<u64>();
    let failed = outcomes.iter().filter(|outcome| outcome.failure.is_some()).count();
    let (runs, cycles) = (sum(|outcome| outcome.runs), sum(|outcome| outcome.cycles));
    format!("{} configurations, {runs} clean runs, {cycles} cycles, {failed} mismatches", outcomes.len())
}

/// What went wrong, on which hardware.
fn failure(outcome: &CaseOutcome) -> Option<String> {
    let CaseOutcome { case, configuration, failure, .. } = outcome;
    let failure = failure.as_ref()?;
    let text =
        [&failure.text, "", &format!("again: {}", failure.reproduce), "configuration:", configuration].join("\n");
    Some(format!("case {case}, run {}: {}", failure.run, text.trim_end()))
}
