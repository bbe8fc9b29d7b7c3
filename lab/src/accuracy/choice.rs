//! What points cost, which of them none betters, and the cheapest that is accurate enough.

use super::sweep::MeasuredPoint;
use pointcore::area::estimate::{Estimate, Estimator};
use serde::Serialize;

/// Signal-to-noise ratios that differ by less are the same.
const EQUAL_DB: f64 = 0.1;

/// What the cheapest point has the least of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Prefer {
    /// Time multiplied by area: frames a second from a device full of cores.
    #[default]
    AreaTime,
    /// Time.
    Time,
    /// Area.
    Area,
}

/// Which error counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Against {
    /// The truth of 16 samples a pixel.
    #[default]
    Truth,
    /// The f64 reference at the same samples: rounding alone.
    Rounding,
}

/// A signal-to-noise ratio as a user writes it, such as `45dB`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decibels(pub f64);

impl std::str::FromStr for Decibels {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = text.strip_suffix("dB").or_else(|| text.strip_suffix("db")).unwrap_or(text).trim();
        let value = number.parse().ok().filter(|value: &f64| value.is_finite() && *value > 0.0);
        value.map(Self).ok_or_else(|| "expected a number of decibels, such as 45dB".to_owned())
    }
}

/// A point and its costs.
pub struct Rated {
    /// The point.
    pub measured: MeasuredPoint,
    /// Area and clock; none where no hardware renders it.
    pub estimate: Option<Estimate>,
    /// Time of a frame in milliseconds.
    pub time_ms: Option<f64>,
    /// No other point is as accurate, as fast and as small, and better in one of these.
    pub on_front: bool,
}

impl Rated {
    /// Look-up tables.
    #[must_use]
    pub fn lut4(&self) -> Option<f64> {
        self.estimate.and_then(|estimate| estimate.lut4)
    }

    /// Cost in the preferred terms; none where no hardware renders the point.
    #[must_use]
    pub fn cost(&self, prefer: Prefer) -> Option<f64> {
        let time = self.time_ms?;
        Some(match prefer {
            // Without any area time is all there is.
            Prefer::AreaTime => time * self.lut4().unwrap_or(1.0),
            Prefer::Time => time,
            Prefer::Area => self.lut4().unwrap_or(time),
        })
    }

    /// Decibels.
    #[must_use]
    pub fn psnr_db(&self, against: Against) -> f64 {
        match against {
            Against::Truth => self.measured.figures.psnr_db,
            Against::Rounding => self.measured.figures.rounding_psnr_db,
        }
    }

    /// Whether this point is in nothing worse than another, and in something better.
    fn betters(&self, other: &Self) -> bool {
        let (Some(time), Some(other_time)) = (self.time_ms, other.time_ms) else { return false };
        let (area, other_area) = (self.lut4().unwrap_or(0.0), other.lut4().unwrap_or(0.0));
        let gain = self.psnr_db(Against::Truth) - other.psnr_db(Against::Truth);
        let no_worse = gain > -EQUAL_DB && time <= other_time && area <= other_area;
        no_worse && (gain >= EQUAL_DB || time < other_time || area < other_area)
    }
}

/// Finds what every point costs, and the front.
#[must_use]
pub fn rate(measured: Vec<MeasuredPoint>, estimator: &Estimator) -> Vec<Rated> {
    let rated = |measured: MeasuredPoint| {
        let hardware = measured.figures.hardware.as_ref();
        let estimate = hardware.map(|hardware| estimator.estimate(&hardware.config, &hardware.proxy));
        let time_ms = hardware.zip(estimate).map(|(hardware, estimate)| hardware.cycles as f64 / (estimate.mhz * 1e3));
        Rated { measured, estimate, time_ms, on_front: false }
    };
    let mut all: Vec<Rated> = measured.into_iter().map(rated).collect();
    let on_front = |point: &Rated| point.time_ms.is_some() && !all.iter().any(|other| other.betters(point));
    let front: Vec<bool> = all.iter().map(on_front).collect();
    all.iter_mut().zip(front).for_each(|(rated, on_front)| rated.on_front = on_front);
    all
}

/// The cheapest point with an error no larger than asked for.
#[must_use]
pub fn cheapest(rated: &[Rated], at_least: Decibels, against: Against, prefer: Prefer) -> Option<&Rated> {
    let holds = rated.iter().filter(|point| point.psnr_db(against) >= at_least.0);
    let costs = holds.filter_map(|point| Some((point.cost(prefer)?, point)));
    costs.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, point)| point)
}

/// The most accurate point that hardware renders.
#[must_use]
pub fn most_accurate(rated: &[Rated], against: Against) -> Option<(&Rated, f64)> {
    let rendered = rated.iter().filter(|point| point.time_ms.is_some());
    let best = rendered.max_by(|a, b| a.psnr_db(against).total_cmp(&b.psnr_db(against)))?;
    Some((best, best.psnr_db(against)))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::accuracy::figures::{Hardware, PointEngine, PointFigures};
    use crate::accuracy::point::SweepPoint;
    use pointcore::area::estimate::Fit;
    use pointcore::area::proxy::Proxy;
    use pointcore_contract::splat::Config;

    /// Points by name, signal-to-noise ratio, cycles and area.
    pub fn rated(points: &[(&str, f64, u64, u64)]) -> Vec<Rated> {
        let measured = |&(name, psnr_db, cycles, adder_bits): &(&str, f64, u64, u64)| {
            let proxy = Proxy { adder_bits, ..Proxy::default() };
            let figures = PointFigures {
                engine: PointEngine::Golden,
                psnr_db,
                flip: 0.9,
                worst: 0.1,
                rounding_psnr_db: psnr_db + 10.0,
                surface_differences: Some(0),
                samples: 4,
                hardware: (cycles > 0).then(|| Hardware { cycles, proxy, config: Config::default() }),
            };
            MeasuredPoint {
                point: SweepPoint { name: name.to_owned(), ..SweepPoint::base() },
                figures,
                folder: "nowhere".into(),
            }
        };
        rate(points.iter().map(measured).collect(), &estimator())
    }

    /// A look-up table for each bit of a sum.
    pub fn estimator() -> Estimator {
        let fit = Fit { weights: [1.0, 0.0, 0.0, 0.0], units: 9, median_error: 0.0 };
        serde_json::from_value(serde_json::json!({ "cores": [], "fit": fit })).expect("an estimator")
    }

    #[test]
    fn the_front_is_what_nothing_betters() {
        let points = rated(&[
            ("good", 50.0, 400, 100),
            ("as good, larger", 50.05, 400, 120),
            ("fast", 40.0, 100, 100),
            ("small", 40.0, 200, 50),
            ("worse", 39.0, 200, 60),
            ("f64", 60.0, 0, 0),
        ]);
        let front: Vec<_> =
            points.iter().filter(|point| point.on_front).map(|point| point.measured.point.name.as_str()).collect();
        assert_eq!(front, ["good", "fast", "small"]);
    }

    #[test]
    fn the_cheapest_that_holds_is_found_in_the_preferred_terms() {
        let points = rated(&[("good", 50.0, 300, 100), ("fast", 41.0, 90, 300), ("small", 41.0, 400, 50)]);
        let name = |at_least, against, prefer| {
            cheapest(&points, Decibels(at_least), against, prefer).map(|point| point.measured.point.name.as_str())
        };
        assert_eq!(name(40.0, Against::Truth, Prefer::AreaTime), Some("small"));
        assert_eq!(name(40.0, Against::Truth, Prefer::Time), Some("fast"));
        assert_eq!(name(45.0, Against::Truth, Prefer::Time), Some("good"));
        assert_eq!(name(50.5, Against::Rounding, Prefer::Area), Some("small"));
        assert_eq!(name(55.0, Against::Truth, Prefer::Area), None);
        assert_eq!(most_accurate(&points, Against::Rounding).map(|(_, db)| db), Some(60.0));
    }

    #[test]
    fn decibels_are_read() {
        assert_eq!("45dB".parse(), Ok(Decibels(45.0)));
        assert_eq!("45.5 dB".parse(), Ok(Decibels(45.5)));
        for text in ["dB", "-3", "inf", "45 %"] {
            assert!(text.parse::<Decibels>().unwrap_err().contains("45dB"), "{text}");
        }
    }
}
