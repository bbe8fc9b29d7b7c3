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
    Some(AreaSample { proxy, lut4: lut4(&entry.area), mhz, renderer: renderer(entry) })
}

impl AreaRecord {
    /// An estimator that has learned from the entries that are of the hardware as it is now.
    #[must_use]
    pub fn estimator(&self) -> Estimator {
        let fresh = self.fresh(Target::Ecp5);
        Estimator::new(&fresh.iter().filter_map(|(entry, unit)| sample(entry, unit)).collect::<Vec<_>>())
    }
}
