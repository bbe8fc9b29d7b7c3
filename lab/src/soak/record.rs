//! How much was soaked, kept with the source and made into a table.

use super::campaign::SOURCES;
use super::case::CaseOutcome;
use super::device::Core;
use crate::Figures;
use crate::marks::{self, MarkError};
use crate::synthesis::Revision;
use pointcore::configuration::{ConfigurationError, read_text, wrong};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What a campaign came to on one core.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SoakEntry {
    /// The core.
    pub core: Core,
    /// The revision of the project whose hardware and models were run.
    pub revision: Revision,
    /// Hash of the sources that decide what comes of it.
    pub sources: String,
    /// Seed of the campaign.
    pub seed: u64,
    /// Cycles on each configuration, at least, unless a run failed there.
    pub cycles_per_configuration: u64,
    /// Configurations.
    pub configurations: u64,
    /// Clean runs.
    pub runs: u64,
    /// Frames or queries that came out of them.
    pub items: u64,
    /// Cycles compared in them.
    pub cycles: u64,
    /// Runs that were not clean: a difference, a deadlock, a failed assertion.
    pub mismatches: u64,
    /// The commands that make those.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub failures: Vec<String>,
}

/// What campaigns came to, at most one entry of a campaign and core.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct SoakRecord {
    entries: Vec<SoakEntry>,
}

impl SoakEntry {
    /// The sums of a campaign's cases of one core; none where it has none.
    #[must_use]
    pub fn of(
        core: Core,
        cases: &[CaseOutcome],
        revision: &Revision,
        seed: u64,
        cycles_per_configuration: u64,
    ) -> Option<Self> {
        let of_core = || cases.iter().filter(|case| case.core == core);
        let sum = |count: fn(&CaseOutcome) -> u64| of_core().map(count).sum();
        let failures: Vec<_> = of_core().filter_map(|case| case.failure.as_ref()).collect();
        let entry = Self {
            core,
            revision: revision.clone(),
            sources: SOURCES.to_owned(),
            seed,
            cycles_per_configuration,
            configurations: of_core().count() as u64,
            runs: sum(|case| case.runs),
            items: sum(|case| case.items),
            cycles: sum(|case| case.cycles),
            mismatches: failures.len() as u64,
            failures: failures.into_iter().map(|failure| failure.reproduce.clone()).collect(),
        };
        (entry.configurations > 0).then_some(entry)
    }

    /// Whether another entry's cases begin with these, or these with the other's.
    fn is_of_same_campaign(&self, other: &Self) -> bool {
        let key = |entry: &Self| (entry.core, entry.sources.clone(), entry.seed, entry.cycles_per_configuration);
        key(self) == key(other)
    }
}

/// A figure of an entry.
type Count = fn(&SoakEntry) -> u64;

impl SoakRecord {
    /// Reads a record; an empty one if there is no such file.
    ///
    /// # Errors
    /// The file cannot be read, or is none of ours.
    pub fn load(path: &Path) -> Result<Self, ConfigurationError> {
        if !path.exists() {
            return Ok(Self::default());
        }
        serde_json::from_str(&read_text(path)?).map_err(|error| wrong(path, error.to_string()))
    }

    /// Adds what a campaign came to. Of the same campaign the larger one stays: no cycle counts twice.
    pub fn add(&mut self, entry: SoakEntry) {
        match self.entries.iter_mut().find(|other| other.is_of_same_campaign(&entry)) {
            Some(other) if other.configurations > entry.configurations => {}
            Some(other) => *other = entry,
            None => self.entries.push(entry),
        }
    }

    /// The file's text.
    #[must_use]
    pub fn text(&self) -> String {
        serde_json::to_string_pretty(self).expect("entries have string keys") + "\n"
    }

    fn sum(&self, core: Option<Core>, count: Count) -> u64 {
        let of_core = |entry: &&SoakEntry| core.is_none_or(|core| core == entry.core);
        self.entries.iter().filter(of_core).map(count).sum()
    }

    /// Figures by key: `soak.cycles` and the like, and of one core `soak.splat.cycles`.
    #[must_use]
    pub fn figures(&self) -> Figures {
        let counts: [(&str, Count); 3] = [
            ("cycles", |entry| entry.cycles),
            ("configurations", |entry| entry.configurations),
            ("mismatches", |entry| entry.mismatches),
        ];
        let mut figures = Figures::new();
        for (name, count) in counts {
            figures.insert(format!("soak.{name}"), self.sum(None, count).into());
            for core in Core::ALL {
                figures.insert(format!("soak.{}.{name}", core.name()), self.sum(Some(core), count).into());
            }
        }
        figures
    }

    /// A document with its table written anew, between `<!-- soak -->` and `<!-- end of soak -->`.
    ///
    /// # Errors
    /// The table is missing, or has no end.
    pub fn tabulate(&self, document: &str) -> Result<String, MarkError> {
        marks::replace(document, "soak", &self.table())
    }

    /// A line of a campaign and core each, and one of all together.
    fn table(&self) -> String {
        let mut lines = String::new();
        for entry in &self.entries {
            let SoakEntry { core, revision, seed, configurations, runs, cycles, mismatches, .. } = entry;
            let name = core.name();
            let counts = [configurations, runs, cycles, mismatches].map(|count| grouped(*count)).join(" | ");
            lines += &format!("| {name} | {revision} | {seed} | {counts} |\n");
        }
        let counts: [Count; 4] =
            [|entry| entry.configurations, |entry| entry.runs, |entry| entry.cycles, |entry| entry.mismatches];
        let counts = counts.map(|count| grouped(self.sum(None, count))).join(" | ");
        let head = "| core | revision | seed | configurations | runs | cycles | mismatches |\n";
        format!("{head}|---|---|--:|--:|--:|--:|--:|\n{lines}| both | | | {counts} |\n")
    }
}

/// A number with a comma before every three digits.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let comma = |place: usize| place > 0 && (digits.len() - place).is_multiple_of(3);
    digits.char_indices().flat_map(|(place, digit)| comma(place).then_some(',').into_iter().chain([digit])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::soak::case::CaseFailure;

    fn outcome(case: u64, failed: bool) -> CaseOutcome {
        let core = if case.is_multiple_of(2) { Core::Splat } else { Core::Search };
        let failure = CaseFailure { run: 3, reproduce: format!("pointcore soak --case {case}"), text: "x".into() };
        let configuration = String::new();
        CaseOutcome { case, core, cycles: 1000, runs: 3, items: 7, configuration, failure: failed.then_some(failure) }
    }

    fn record(cases: &[CaseOutcome], seed: u64) -> Vec<SoakEntry> {
        let revision = "abc1234".parse::<Revision>().unwrap_or_else(|error| panic!("{error}"));
        Core::ALL.into_iter().filter_map(|core| SoakEntry::of(core, cases, &revision, seed, 1000)).collect()
    }

    #[test]
    fn campaigns_add_up_and_none_counts_twice() {
        let cases: Vec<_> = (0..5).map(|case| outcome(case, case == 4)).collect();
        let mut soak = SoakRecord::default();
        record(&cases, 1).into_iter().for_each(|entry| soak.add(entry));
        record(&cases[..2], 1).into_iter().for_each(|entry| soak.add(entry));
        let figures = soak.figures();
        assert_eq!((&figures["soak.cycles"], &figures["soak.splat.cycles"]), (&5000.into(), &3000.into()));
        assert_eq!((&figures["soak.configurations"], &figures["soak.mismatches"]), (&5.into(), &1.into()));
        assert_eq!(soak.entries[0].failures, ["pointcore soak --case 4"]);
        record(&cases, 2).into_iter().for_each(|entry| soak.add(entry));
        assert_eq!(soak.figures()["soak.cycles"], 10_000);
        assert_eq!(serde_json::from_str::<SoakRecord>(&soak.text()).ok(), Some(soak.clone()));
        let text = soak.tabulate("<!-- soak: by a command -->\nold\n<!-- end of soak -->\n");
        let text = text.unwrap_or_else(|error| panic!("{error}"));
        assert!(text.contains("| splat | abc1234 | 1 | 3 | 9 | 3,000 | 1 |"), "{text}");
        assert!(text.contains("| both | | | 10 | 30 | 10,000 | 2 |") && !text.contains("old"), "{text}");
    }

    #[test]
    fn numbers_are_grouped() {
        assert_eq!([0, 999, 1000, 1_234_567].map(grouped), ["0", "999", "1,000", "1,234,567"]);
    }
}
