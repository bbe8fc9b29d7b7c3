//! The record of measurements that is kept with the source: of which Verilog each was made, with which tools.
//!
//! An entry claims to be of the hardware as it is now, and is held to it by the hash of what it was measured of, unless it names the
//! revision of the project that it was measured of. Hardware may so change faster than it is measured, and no table says what is not true.

use super::revision::Revision;
use super::{DeviceArea, MeasuredUnit, Measurement, Target, Timing, all, source_hash};
use pointcore::configuration::{ConfigurationError, parse, read_text, wrong};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// A measurement, and what it was made of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AreaEntry {
    /// The unit's name.
    pub unit: String,
    /// The technology.
    pub target: Target,
    /// The configuration file, of a core that is measured from one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub configuration: Option<PathBuf>,
    /// Runs of place and route; the figures are those of the median.
    pub seeds: usize,
    /// The first of their seeds.
    #[serde(default = "first", skip_serializing_if = "is_first")]
    pub first_seed: u32,
    /// Hash of the Verilog, the script and the arguments.
    pub source: String,
    /// The revision of the project that it was measured of, where the hardware has changed since.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub revision: Option<Revision>,
    /// What the tools say of their versions.
    pub tools: Vec<String>,
    /// What the unit takes.
    pub area: DeviceArea,
    /// The run with the median frequency.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub timing: Option<Timing>,
    /// The frequency with every seed, in MHz.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fmax_mhz: Vec<f64>,
}

/// An entry that claims to be of the hardware as it is now, and is not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stale {
    /// What is wrong.
    pub problem: String,
    /// The command that puts it right.
    pub remedy: String,
}

/// Measurements, at most one of a unit and target.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct AreaRecord {
    entries: Vec<AreaEntry>,
}

/// The seed that runs begin with where nothing else is asked for.
const fn first() -> u32 {
    1
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
const fn is_first(seed: &u32) -> bool {
    *seed == first()
}

impl AreaEntry {
    /// Keeps a measurement; frequencies to a hundredth.
    #[must_use]
    pub fn new(
        target: Target,
        configuration: Option<PathBuf>,
        source: String,
        tools: Vec<String>,
        measurement: Measurement,
    ) -> Self {
        let Measurement { unit, area, timing, fmax_mhz, first_seed } = measurement;
        let round = |mhz: f64| (mhz * 100.0).round() / 100.0;
        let timing = timing.map(|timing| Timing { fmax_mhz: round(timing.fmax_mhz), ..timing });
        let (seeds, fmax_mhz) = (fmax_mhz.len(), fmax_mhz.into_iter().map(round).collect());
        Self { unit, target, configuration, seeds, first_seed, source, revision: None, tools, area, timing, fmax_mhz }
    }

    /// What was measured.
    #[must_use]
    pub fn measurement(&self) -> Measurement {
        let Self { unit, area, timing, fmax_mhz, first_seed, .. } = self.clone();
        Measurement { unit, area, timing, fmax_mhz, first_seed }
    }

    /// The command that measures it anew into the record.
    fn command(&self, record: &Path) -> String {
        let unit = self.configuration.as_ref().map_or_else(|| self.unit.clone(), |path| path.display().to_string());
        let mut seeds = if self.seeds > 0 { format!(" --seeds {}", self.seeds) } else { String::new() };
        if !is_first(&self.first_seed) {
            seeds += &format!(" --first-seed {}", self.first_seed);
        }
        format!("pointcore area {unit} --target {}{seeds} --record {}", self.target.name(), record.display())
    }

    /// The unit as it is now, if it can be told.
    fn unit_now(&self, known: Vec<MeasuredUnit>) -> Option<MeasuredUnit> {
        match &self.configuration {
            Some(path) => Some(MeasuredUnit::core(self.unit.clone(), parse(path, &read_text(path).ok()?).ok()?)),
            None => known.into_iter().find(|unit| unit.name == self.unit),
        }
    }

    /// The hash of the unit as it is now; none if there is none of that name.
    fn regenerated(&self, known: &[MeasuredUnit]) -> Result<Option<String>, String> {
        let hash = |unit: &MeasuredUnit| source_hash(self.target, unit).map(Some).map_err(|error| error.to_string());
        match &self.configuration {
            Some(path) => {
                let read = read_text(path).and_then(|text| parse(path, &text));
                hash(&MeasuredUnit::core(self.unit.clone(), read.map_err(|error| error.to_string())?))
            }
            None => known.iter().find(|unit| unit.name == self.unit).map_or(Ok(None), hash),
        }
    }
}

impl AreaRecord {
    /// Reads a record; an empty one if there is no such file.
    ///
    /// # Errors
    /// The file cannot be read, or is none of ours.
    pub fn load(path: &Path) -> Result<Self, ConfigurationError> {
        if !path.exists() {
            return Ok(Self::default());
        }
        Self::parse(path, &read_text(path)?)
    }

    /// Reads a record's text; `path` is where it lies.
    ///
    /// # Errors
    /// It is none of ours.
    pub fn parse(path: &Path, text: &str) -> Result<Self, ConfigurationError> {
        serde_json::from_str(text).map_err(|error| wrong(path, format!("no record of areas: {error}")))
    }

    /// The record as a file: an entry in the place that its unit has in tables, whatever order they were measured in.
    #[must_use]
    pub fn text(&self) -> String {
        serde_json::to_string_pretty(self).expect("a record is JSON") + "\n"
    }

    /// The entries.
    #[must_use]
    pub fn entries(&self) -> &[AreaEntry] {
        &self.entries
    }

    /// The entries of a target that are of the hardware as it is now, with the units they are of.
    #[must_use]
    pub fn fresh(&self, target: Target) -> Vec<(&AreaEntry, MeasuredUnit)> {
        let is_fresh = |(entry, unit): &(&AreaEntry, MeasuredUnit)| {
            source_hash(target, unit).is_ok_and(|source| source == entry.source)
        };
        self.known(target).into_par_iter().filter(is_fresh).collect()
    }

    /// The entries of a target whose units are still known, those of earlier revisions among them, with the units as they are now.
    #[must_use]
    pub fn known(&self, target: Target) -> Vec<(&AreaEntry, MeasuredUnit)> {
        let of_target = self.entries.iter().filter(|entry| entry.target == target);
        of_target.filter_map(|entry| Some((entry, entry.unit_now(all())?))).collect()
    }

    /// Takes an entry in, in the place of an older one.
    pub fn insert(&mut self, entry: AreaEntry) {
        self.entries.retain(|old| (&old.unit, old.target) != (&entry.unit, entry.target));
        self.entries.push(entry);
        let names: Vec<_> = all().into_iter().map(|unit| unit.name).collect();
        let place = |entry: &AreaEntry| names.iter().position(|name| *name == entry.unit).unwrap_or(names.len());
        self.entries.sort_by_cached_key(|entry| (entry.target, place(entry), entry.unit.clone()));
    }

    /// The entries that claim to be of the hardware as it is now and are not, found by generating it; nothing is synthesized. `path` is
    /// where the record lies.
    #[must_use]
    pub fn stale(&self, path: &Path) -> Vec<Stale> {
        let known = all();
        let stale = |entry: &AreaEntry| {
            if entry.revision.is_some() {
                return None;
            }
            let AreaEntry { unit, target, .. } = entry;
            let name = format!("`{unit}` on {}", target.name());
            let remedy = entry.command(path);
            match entry.regenerated(&known) {
                Ok(Some(source)) if source == entry.source => None,
                Ok(Some(_)) => Some(Stale { problem: format!("{name} was measured of other Verilog"), remedy }),
                Ok(None) => Some(Stale {
                    problem: format!("{name} is not known"),
                    remedy: format!("delete its entry from {}", path.display()),
                }),
                Err(error) => Some(Stale { problem: format!("{name}: {error}"), remedy }),
            }
        };
        self.entries.par_iter().filter_map(stale).collect()
    }

    /// Has every entry that is not of the hardware as it is now name the revision that it was measured of: `revision`, unless it names one
    /// already. An entry that has come true again names none. Returns how many entries are of an earlier revision.
    pub fn mark_stale(&mut self, revision: &Revision) -> usize {
        let known = all();
        self.entries.par_iter_mut().for_each(|entry| {
            let is_current = entry.regenerated(&known).is_ok_and(|source| source.as_ref() == Some(&entry.source));
            entry.revision = (!is_current).then(|| entry.revision.take().unwrap_or_else(|| revision.clone()));
        });
        self.earlier()
    }

    /// How many entries are of an earlier revision, and say so.
    #[must_use]
    pub fn earlier(&self) -> usize {
        self.entries.iter().filter(|entry| entry.revision.is_some()).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(unit: &str, target: Target) -> AreaEntry {
        let area = DeviceArea { lut: 42, ..DeviceArea::default() };
        let timing = Timing { fmax_mhz: 123.456, from: "a".into(), to: "b".into() };
        let measurement = Measurement {
            unit: unit.into(),
            area,
            timing: Some(timing),
            fmax_mhz: vec![120.0, 123.456, 130.0],
            first_seed: 2,
        };
        let unit = all().into_iter().find(|known| known.name == unit);
        let source = unit.map(|unit| source_hash(target, &unit).unwrap_or_else(|error| panic!("{error}")));
        AreaEntry::new(target, None, source.unwrap_or_default(), vec!["yosys".into()], measurement)
    }

    fn revision(text: &str) -> Revision {
        text.parse().unwrap_or_else(|error| panic!("{error}"))
    }

    fn record(units: &[&str]) -> AreaRecord {
        let mut record = AreaRecord::default();
        units.iter().for_each(|unit| record.insert(entry(unit, Target::Ecp5)));
        record
    }

    #[test]
    fn a_record_is_the_same_in_whatever_order_it_was_measured() {
        let all = record(&["f32_add", "bf16_lt", "heap1023"]);
        assert_eq!(record(&["heap1023", "f32_add", "bf16_lt", "f32_add"]), all);
        let again: AreaRecord = serde_json::from_str(&all.text()).expect("it was written as JSON");
        assert_eq!((again.text(), &again), (all.text(), &all));
        assert_eq!(all.entries()[0].fmax_mhz[1], 123.46);
    }

    #[test]
    fn what_was_measured_of_other_hardware_is_stale() {
        let path = Path::new("area.json");
        let mut record = record(&["bf16_lt", "bf16_eq", "bf16_gone"]);
        record.entries[0].source += "0";
        let changed = record.entries[0].unit.clone();
        let stale = record.stale(path);
        assert_eq!(stale.len(), 2, "{stale:?}");
        assert_eq!(
            stale[0].remedy,
            format!("pointcore area {changed} --target ecp5 --seeds 3 --first-seed 2 --record area.json")
        );
        assert!(stale[1].problem.contains("`bf16_gone`"), "{stale:?}");
        let missing = AreaEntry { configuration: Some("gone.toml".into()), ..entry("gone", Target::Gates) };
        let stale = AreaRecord { entries: vec![missing] }.stale(path);
        assert!(stale[0].problem.contains("gone.toml: cannot be read"), "{stale:?}");
    }

    #[test]
    fn what_names_its_revision_passes_and_is_shown_with_it() {
        let path = Path::new("area.json");
        let mut record = record(&["bf16_lt", "bf16_eq", "bf16_gone"]);
        record.entries[0].source += "0";
        let changed = record.entries[0].unit.clone();
        assert_eq!(record.stale(path).len(), 2, "unmarked");
        assert_eq!(record.mark_stale(&revision("abc1234")), 2);
        assert_eq!(record.stale(path), [], "marked");
        assert_eq!(record.mark_stale(&revision("def5678")), 2, "what names a revision keeps it");
        let again: AreaRecord = serde_json::from_str(&record.text()).expect("it was written as JSON");
        assert_eq!(again, record);

        let text =
            record.tabulate("<!-- area ecp5 -->\n<!-- end of area -->\n").unwrap_or_else(|error| panic!("{error}"));
        let of = |unit: &str| text.lines().find(|line| line.starts_with(&format!("| `{unit}` "))).unwrap_or_default();
        assert!(text.contains("| critical path | revision |"), "{text}");
        assert!(of(&changed).ends_with("| abc1234 |") && of("bf16_gone").ends_with("| abc1234 |"), "{text}");
        assert_eq!(text.matches("abc1234").count(), 2, "the third is of the hardware as it is now: {text}");

        record.entries[0].source.pop();
        assert_eq!(record.mark_stale(&revision("def5678")), 1, "what has come true again names none");
        record.insert(entry("bf16_gone", Target::Ecp5));
        assert_eq!((record.earlier(), record.stale(path).len()), (0, 1), "measured anew, it claims to be current");
    }

    #[test]
    fn a_revision_fits_a_cell() {
        for wrong in ["", "a b", "a|b", "`a`"] {
            let error = wrong.parse::<Revision>().unwrap_err();
            assert!(error.contains("expected a commit's short hash"), "{error}");
        }
        assert_eq!(revision("2026-11-22").to_string(), "2026-11-22");
    }
}
