//! What a record teaches an estimator of areas.

use super::{AreaEntry, AreaRecord, DeviceArea, MeasuredUnit, Target};
use pointcore::area::estimate::{AreaSample, Estimator};
use pointcore::area::proxy::Proxy;
use pointcore::configuration::{Configuration, ecp5, parse, read_text};
use pointcore_contract::splat::Config;
use rtl::elaborate;

/// Places that a carry cell of ECP5 takes from look-up tables.
const LUT4_PER_CARRY: u64 = 2;

fn lut4(area: &DeviceArea) -> f64 {
    (area.lut + LUT4_PER_CARRY * area.carry) as f64
}

/// The configuration of an entry that is a whole renderer.
fn renderer(entry: &AreaEntry) -> Option<Config> {
    match &entry.configuration {
        Some(path) => match parse(path, &read_text(path).ok()?) {
            Ok(Configuration::Splat(config)) => Some(config),
            _ => None,
        },
        None => (entry.unit == "splat").then(ecp5),
    }
}

fn sample(entry: &AreaEntry, unit: &MeasuredUnit) -> Option<AreaSample> {
    let proxy = Proxy::of(&elaborate(&*unit.module().ok()?).ok()?);
    let mhz = entry.timing.as_ref().map(|timing| timing.fmax_mhz);
    // What was measured of other Verilog teaches, but is not the area of a configuration.
    let renderer = if entry.revision.is_none() { renderer(entry) } else { None };
    Some(AreaSample { proxy, lut4: lut4(&entry.area), mhz, renderer })
}

impl AreaRecord {
    /// An estimator that has learned from all units that are still there. Some were measured of an earlier revision: how many operators
    /// they have is counted of what they are now, so an estimate is as far off as their area has changed since.
    #[must_use]
    pub fn estimator(&self) -> Estimator {
        let known = self.known(Target::Ecp5);
        Estimator::new(&known.iter().filter_map(|(entry, unit)| sample(entry, unit)).collect::<Vec<_>>())
    }
}
