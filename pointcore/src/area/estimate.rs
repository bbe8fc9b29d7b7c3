//! Area and clock of a configuration: as recorded where it was placed and routed as it is, else estimated from what was.

use super::fit::{TERMS, fit, predict};
use super::proxy::Proxy;
use pointcore_contract::splat::Config;
use serde::{Deserialize, Serialize};

/// The clock of what has not been placed and routed.
pub const NOMINAL_MHZ: f64 = 100.0;
/// Units below which a fit says nothing about others.
const UNITS_MIN: usize = 8;

/// Where a figure comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Origin {
    /// Of this configuration, by synthesis or place and route.
    Recorded,
    /// From its operators, by the weights that come nearest to recorded units.
    Estimated,
    /// Assumed.
    Nominal,
}

/// A configuration's area and clock.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Look-up tables with four inputs, those in the place of carry cells included; none where too few units are recorded.
    pub lut4: Option<f64>,
    /// Where that comes from.
    pub lut4_origin: Origin,
    /// The clock.
    pub mhz: f64,
    /// Where that comes from.
    pub mhz_origin: Origin,
}

/// Hardware that was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct AreaSample {
    /// What it holds.
    pub proxy: Proxy,
    /// Look-up tables with four inputs that it takes, those in the place of carry cells included.
    pub lut4: f64,
    /// Its clock, where it was placed and routed.
    pub mhz: Option<f64>,
    /// The configuration, where it is a whole renderer.
    pub renderer: Option<Config>,
}

/// A whole renderer that was measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Known {
    config: Config,
    lut4: f64,
    mhz: Option<f64>,
}

/// Weights of a core's operators, and how well they do.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fit {
    /// Look-up tables for each of [`Proxy::logic`].
    pub weights: [f64; TERMS],
    /// Units that they come from.
    pub units: usize,
    /// Median, over the units, of the error when a unit is estimated from all others, as a share of what it takes.
    pub median_error: f64,
}

/// What hardware that was measured says of configurations that were not.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimator {
    cores: Vec<Known>,
    /// None where too few units are recorded.
    pub fit: Option<Fit>,
}

impl Estimator {
    /// Learns from hardware that was measured as it is now.
    #[must_use]
    pub fn new(samples: &[AreaSample]) -> Self {
        let core =
            |sample: &AreaSample| Some(Known { config: sample.renderer.clone()?, lut4: sample.lut4, mhz: sample.mhz });
        let cores = samples.iter().filter_map(core).collect();
        let rows = samples.iter().map(|sample| (sample.proxy.logic(), sample.lut4));
        let rows: Vec<_> = rows.filter(|(_, value)| *value > 0.0).collect();
        Self { cores, fit: (rows.len() >= UNITS_MIN).then(|| Fit::new(&rows)).flatten() }
    }

    /// Look-up tables, estimated.
    #[must_use]
    pub fn lut4(&self, proxy: &Proxy) -> Option<f64> {
        self.fit.as_ref().map(|fit| predict(&fit.weights, &proxy.logic()))
    }

    /// Area and clock of a configuration whose hardware holds what `proxy` counts.
    #[must_use]
    pub fn estimate(&self, config: &Config, proxy: &Proxy) -> Estimate {
        let known = self.cores.iter().find(|known| known.config == *config);
        let estimated = self.lut4(proxy);
        let (lut4, lut4_origin) = match known {
            Some(known) => (Some(known.lut4), Origin::Recorded),
            None => (estimated, Origin::Estimated),
        };
        match known.and_then(|known| known.mhz) {
            Some(mhz) => Estimate { lut4, lut4_origin, mhz, mhz_origin: Origin::Recorded },
            None => Estimate { lut4, lut4_origin, mhz: NOMINAL_MHZ, mhz_origin: Origin::Nominal },
        }
    }
}

impl Fit {
    fn new(rows: &[([f64; TERMS], f64)]) -> Option<Self> {
        let weights = fit(rows)?;
        let left_out = |index: usize| {
            let others = [&rows[..index], &rows[index + 1..]].concat();
            let (terms, value) = &rows[index];
            fit(&others).map(|weights| (predict(&weights, terms) / value - 1.0).abs())
        };
        let mut errors: Vec<f64> = (0..rows.len()).filter_map(left_out).collect();
        errors.sort_by(f64::total_cmp);
        Some(Self { weights, units: rows.len(), median_error: *errors.get(errors.len() / 2)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn proxy() -> Proxy {
        Proxy { adder_bits: 100, mux_bits: 10, ..Proxy::default() }
    }

    #[test]
    fn what_was_measured_is_preferred_to_an_estimate() {
        let known = Known { config: Config::default(), lut4: 5000.0, mhz: Some(87.0) };
        let fit = Fit { weights: [2.0, 1.0, 0.0, 0.0], units: 9, median_error: 0.1 };
        let estimator = Estimator { cores: vec![known], fit: Some(fit) };
        let recorded = estimator.estimate(&Config::default(), &proxy());
        assert_eq!((recorded.lut4, recorded.lut4_origin, recorded.mhz), (Some(5000.0), Origin::Recorded, 87.0));
        let other = estimator.estimate(&Config { tile_slots: 9, ..Config::default() }, &proxy());
        assert_eq!((other.lut4, other.mhz, other.mhz_origin), (Some(210.0), NOMINAL_MHZ, Origin::Nominal));
    }

    #[test]
    fn without_samples_there_is_no_area() {
        let estimator = Estimator::new(&[]);
        assert_eq!(estimator.estimate(&Config::default(), &proxy()).lut4, None);
    }

    #[test]
    fn the_error_is_that_of_units_left_out() {
        let rows: Vec<_> = (1..10).map(|i| ([f64::from(i), f64::from(i % 4), 0.0, 0.0], f64::from(2 * i))).collect();
        let fit = Fit::new(&rows).expect("the rows determine it");
        assert!(fit.median_error < 1e-9 && (fit.weights[0] - 2.0).abs() < 1e-9, "{fit:?}");
    }
}
