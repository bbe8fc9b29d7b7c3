//! What the project has measured of whole cores: `docs/area.json`, as it was when the library was built.

use super::device::{Evidence, Needs};
use crate::configuration::{Configuration, ecp5, knn, parse, points};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The record's text.
pub const RECORD: &str = include_str!("../../../docs/area.json");
/// The technology whose clocks count: the one that cores are placed and routed on.
const TARGET: &str = "ecp5";
/// Places that a carry cell takes from look-up tables.
const LUT4_PER_CARRY: u64 = 2;

/// Configurations that an entry may name, by their files.
const CONFIGURATIONS: [(&str, &str); 8] = [
    ("configs/asic.toml", include_str!("../../../configs/asic.toml")),
    ("configs/ecp5.toml", include_str!("../../../configs/ecp5.toml")),
    ("configs/fpga.toml", include_str!("../../../configs/fpga.toml")),
    ("configs/knn.toml", include_str!("../../../configs/knn.toml")),
    ("configs/points.toml", include_str!("../../../configs/points.toml")),
    ("configs/tiny.toml", include_str!("../../../configs/tiny.toml")),
    ("configs/tiny_knn.toml", include_str!("../../../configs/tiny_knn.toml")),
    ("configs/upsample.toml", include_str!("../../../configs/upsample.toml")),
];

/// An entry, as far as it matters here.
#[derive(Deserialize)]
struct Entry {
    unit: String,
    target: String,
    configuration: Option<String>,
    revision: Option<String>,
    area: Cells,
    timing: Option<Timing>,
}

#[derive(Deserialize)]
struct Cells {
    lut: u64,
    carry: u64,
    flip_flop: u64,
    block_ram: u64,
    dsp: u64,
}

#[derive(Deserialize)]
struct Timing {
    fmax_mhz: f64,
}

/// A core that was placed and routed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RecordedCore {
    /// Its name in the record.
    pub unit: String,
    /// The revision of the project that it was measured of, where the hardware has changed since.
    pub revision: Option<String>,
    /// Its clock.
    pub mhz: f64,
    /// What it takes.
    pub needs: Needs,
}

impl Entry {
    fn is_of(&self, configuration: &Configuration) -> bool {
        match (&self.configuration, self.unit.as_str()) {
            (Some(path), _) => CONFIGURATIONS.iter().any(|(name, text)| {
                name == path && parse(Path::new(name), text).is_ok_and(|known| known == *configuration)
            }),
            (None, "splat") => *configuration == Configuration::Splat(ecp5()),
            (None, "search") => *configuration == Configuration::Search(knn()),
            (None, "points") => *configuration == Configuration::Points(points()),
            (None, _) => false,
        }
    }

    fn core(self) -> Option<RecordedCore> {
        let Cells { lut, carry, flip_flop, block_ram, dsp } = self.area;
        let needs = Needs {
            lut4: Some((lut + LUT4_PER_CARRY * carry) as f64),
            flip_flops: flip_flop,
            block_rams: block_ram,
            multipliers: dsp,
            evidence: Evidence::Recorded,
        };
        Some(RecordedCore { unit: self.unit, revision: self.revision, mhz: self.timing?.fmax_mhz, needs })
    }
}

/// What was measured of a configuration's core, if it was placed and routed.
///
/// # Panics
/// Never: a test reads the record.
#[must_use]
pub fn recorded(configuration: &Configuration) -> Option<RecordedCore> {
    let entries: Vec<Entry> = serde_json::from_str(RECORD).expect("the record is one of ours");
    let found = entries.into_iter().filter(|entry| entry.target == TARGET && entry.is_of(configuration));
    found.filter_map(Entry::core).next()
}

/// Where a clock comes from.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ClockOrigin {
    /// Asked for.
    Given,
    /// Placed and routed on an LFE5U-85F.
    Recorded {
        /// The core's name in the record.
        unit: String,
        /// The revision that it was measured of, where the hardware has changed since.
        revision: Option<String>,
    },
    /// Assumed, since this configuration was not placed and routed.
    Nominal,
}

/// The clock for which times are stated.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Clock {
    /// In MHz.
    pub mhz: f64,
    /// Where it comes from.
    pub origin: ClockOrigin,
}

impl Clock {
    /// The clock that is given, else the recorded one, else the nominal one.
    #[must_use]
    pub fn of(configuration: &Configuration, given_mhz: Option<f64>) -> Self {
        match (given_mhz, recorded(configuration)) {
            (Some(mhz), _) => Self { mhz, origin: ClockOrigin::Given },
            (None, Some(RecordedCore { unit, revision, mhz, .. })) => {
                Self { mhz, origin: ClockOrigin::Recorded { unit, revision } }
            }
            (None, None) => Self { mhz: super::estimate::NOMINAL_MHZ, origin: ClockOrigin::Nominal },
        }
    }
}

impl std::fmt::Display for Clock {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} MHz, ", self.mhz)?;
        match &self.origin {
            ClockOrigin::Given => f.write_str("as asked"),
            ClockOrigin::Recorded { unit, revision } => {
                write!(f, "as `{unit}` was placed and routed on an LFE5U-85F")?;
                revision.as_ref().map_or(Ok(()), |revision| write!(f, " at revision {revision}"))
            }
            ClockOrigin::Nominal => f.write_str("assumed: this configuration has not been placed and routed"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::area::device::{Device, Shortage};
    use crate::search::SearchCore;
    use pointcore_contract::search::Config;

    #[test]
    fn the_clock_is_the_recorded_one_of_that_configuration_alone() {
        let known = recorded(&Configuration::Search(knn())).expect("`search` is in the record");
        let clock = |config: Config, given| Clock::of(&Configuration::Search(config), given);
        assert_eq!(clock(knn(), None).mhz, known.mhz);
        assert!(clock(knn(), None).to_string().contains("as `search` was placed and routed"));
        let other = clock(Config { threads: 8, ..knn() }, None);
        assert_eq!((other.mhz, other.origin.clone()), (100.0, ClockOrigin::Nominal));
        assert!(other.to_string().contains("assumed"));
        assert_eq!(clock(knn(), Some(50.0)), Clock { mhz: 50.0, origin: ClockOrigin::Given });
    }

    #[test]
    fn counted_block_rams_are_near_what_synthesis_takes() {
        for configuration in [Configuration::Search(knn()), Configuration::Splat(ecp5())] {
            let known = recorded(&configuration).expect("both cores are in the record");
            let design = rtl::elaborate(&configuration.module().expect("the generator is right")).expect("it is sound");
            let counted = Needs::counted(&design, None);
            // What was recorded of other hardware may have had other memories; the search core's are the same.
            if known.revision.is_some() && matches!(configuration, Configuration::Splat(_)) {
                continue;
            }
            let known = known.needs;
            let ratio = counted.block_rams as f64 / known.block_rams as f64;
            assert!((0.85..1.2).contains(&ratio), "{counted:?} {known:?}");
            assert!(counted.multipliers >= known.multipliers, "{counted:?} {known:?}");
        }
        let core = SearchCore::generate(&knn()).expect("the configuration is valid");
        let counted = Needs::counted(&core.design, None);
        let small: Device = "12f".parse().expect("a device");
        let shortages = counted.shortages(&small);
        assert!(shortages.iter().any(Shortage::is_of_block_ram), "{shortages:?}");
        let large = "LFE5U-85F".parse().expect("a device");
        assert_eq!(counted.shortages(&large), []);
        assert!("85G".parse::<Device>().unwrap_err().contains("XC7A35T"));
    }
}
