//! How large the core is, and whether a device holds it.

use super::SearchError;
use super::generate::SearchCore;
use super::resources::{StorageRow, storage};
use crate::area::device::{Device, Evidence, Needs, Shortage};
use crate::area::recorded::recorded;
use crate::configuration::Configuration;
use pointcore_contract::search::Config;
use serde::Serialize;
use std::fmt::Write as _;

/// Records that a tree cache may hold, the largest tried first: fewer make the search wait for its tree.
const TREE_CACHES: [u32; 5] = [16_384, 4_096, 1_024, 256, 64];

/// A part of the core's memory.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MemoryPart {
    /// The part.
    pub part: &'static str,
    /// Its size.
    pub kilobytes: f64,
}

/// A device beside a core.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DeviceFit {
    /// The device.
    pub device: Device,
    /// What it has too little of: nothing if the core fits, as far as can be told.
    pub shortages: Vec<Shortage>,
    /// A `tree_cache` with which the core's memories fit, where with the tree on the chip they do not.
    pub tree_cache: Option<u32>,
}

/// The size of a core.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HardwareSize {
    /// Memory on the chip.
    pub kilobytes: f64,
    /// Part by part.
    pub memory: Vec<MemoryPart>,
    /// What it takes of a device.
    pub needs: Needs,
    /// The device that was asked about.
    pub fit: Option<DeviceFit>,
}

fn has_no_block_ram(shortages: &[Shortage]) -> bool {
    shortages.iter().any(Shortage::is_of_block_ram)
}

impl HardwareSize {
    /// Measures a core; `lut4` are its look-up tables as far as they can be estimated. What was recorded of the configuration counts for
    /// more.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn of(
        core: &SearchCore,
        config: &Config,
        device: Option<Device>,
        lut4: Option<f64>,
    ) -> Result<Self, SearchError> {
        let part = |StorageRow { part, kilobytes, .. }| MemoryPart { part, kilobytes };
        let memory: Vec<_> = storage(&core.design).into_iter().map(part).filter(|part| part.kilobytes > 0.0).collect();
        let known = recorded(&Configuration::Search(config.clone()));
        let needs = known.map_or_else(|| Needs::counted(&core.design, lut4), |known| known.needs);
        let fit = device.map(|device| DeviceFit::of(config, &needs, device)).transpose()?;
        Ok(Self { kilobytes: memory.iter().map(|part| part.kilobytes).sum(), memory, needs, fit })
    }

    /// Its rows of a report.
    #[must_use]
    pub fn rows(&self) -> Vec<(&'static str, String)> {
        let parts: Vec<_> =
            self.memory.iter().map(|MemoryPart { part, kilobytes }| format!("{part} {kilobytes:.1}")).collect();
        let mut rows = vec![("memory on the chip", format!("{:.1} kB: {}", self.kilobytes, parts.join(", ")))];
        let Needs { lut4, flip_flops, block_rams, multipliers, evidence } = self.needs;
        let lut4 = lut4.map_or(String::new(), |lut4| format!("{lut4:.0} LUT4, "));
        let (evidence, at_most) = match evidence {
            Evidence::Counted => ("before synthesis", "at most "),
            Evidence::Recorded => ("as recorded of an LFE5U-85F", ""),
        };
        let size = format!(
            "{lut4}{flip_flops} flip-flops, {block_rams} block RAMs of 18 kbit, {at_most}{multipliers} multipliers, {evidence}"
        );
        rows.push(("size", size));
        if let Some(DeviceFit { device, shortages, tree_cache }) = &self.fit {
            let mut text = format!("{}: ", device.name);
            if shortages.is_empty() {
                text += if self.needs.lut4.is_some() { "fits" } else { "fits, as far as it was counted" };
            } else {
                let list: Vec<_> = shortages.iter().map(Shortage::to_string).collect();
                _ = write!(text, "does not fit: {}", list.join(", "));
            }
            if let Some(lines) = tree_cache {
                _ = write!(
                    text,
                    "; with `tree_cache = {lines}` the tree lies in memory, and what is left on the chip fits"
                );
            }
            rows.push(("device", text));
        }
        rows
    }
}

impl DeviceFit {
    fn of(config: &Config, needs: &Needs, device: Device) -> Result<Self, SearchError> {
        let shortages = needs.shortages(&device);
        let mut tree_cache = None;
        if config.tree_cache == 0 && has_no_block_ram(&shortages) {
            for lines in TREE_CACHES {
                let smaller = SearchCore::generate(&Config { tree_cache: lines, ..config.clone() })?;
                if !has_no_block_ram(&Needs::counted(&smaller.design, None).shortages(&device)) {
                    tree_cache = Some(lines);
                    break;
                }
            }
        }
        Ok(Self { device, shortages, tree_cache })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration::knn;

    #[test]
    fn a_tree_that_does_not_fit_is_proposed_a_cache() {
        let size = |config: &Config, device: Option<&str>| {
            let core = SearchCore::generate(config).expect("the configuration is valid");
            let device = device.map(|name| name.parse().expect("a device"));
            HardwareSize::of(&core, config, device, None).expect("the generator is right")
        };
        let deep = Config { tree_depth: 17, ..knn() };
        let too_large = size(&deep, Some("LFE5U-45F"));
        let fit = too_large.fit.clone().expect("a device was named");
        assert!(has_no_block_ram(&fit.shortages), "{too_large:?}");
        let lines = fit.tree_cache.expect("a cache fits");
        assert!(too_large.rows().iter().any(|(_, text)| text.contains(&format!("`tree_cache = {lines}`"))));
        let cached = size(&Config { tree_cache: lines, ..deep }, Some("LFE5U-45F"));
        assert!(!has_no_block_ram(&cached.fit.clone().expect("a device was named").shortages), "{cached:?}");
        assert!(cached.kilobytes < too_large.kilobytes);
        let recorded = size(&knn(), Some("85F"));
        assert_eq!(recorded.fit.clone().expect("a device was named").shortages, []);
        assert!(recorded.rows()[1].1.contains("as recorded"), "{:?}", recorded.rows());
        assert_eq!(size(&knn(), None).fit, None);
    }
}
