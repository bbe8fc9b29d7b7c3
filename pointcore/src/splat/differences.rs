//! How a frame differs from its reference, and how much of that rounding explains.

use pointcore_contract::splat::{AttributeFormat, Config};
use pointcore_golden::reference::Frame;
use serde::Serialize;

/// Largest difference of an attribute that the rounding of one value explains. In coarse fixed point it is [more](rounding_limit), and that of
/// sums of many samples [grows with them](sum_limit).
pub const ROUNDING_LIMIT: f64 = 1.0 / 256.0;

/// Units in the last place of a fixed-point attribute that the host's and the normalizer's rounding and the missing one come to.
const ROUNDED_PLACES: f64 = 2.0;

/// Roundings of a sample on its way into a sum: of its attribute, of the product with its weight, of the sum.
const ROUNDINGS_PER_SAMPLE: f64 = 3.0;

/// Largest difference that the rounding of sums over so many samples explains; sums in fixed point are exact.
#[must_use]
pub fn sum_limit(config: &Config, samples: u32) -> f64 {
    match config.attribute {
        AttributeFormat::Float(format) => {
            let half_place = 0.5_f64.powi(format.mantissa as i32 + 1);
            ROUNDING_LIMIT.max(ROUNDINGS_PER_SAMPLE * f64::from(samples) * half_place)
        }
        AttributeFormat::Fixed(_) => rounding_limit(config),
    }
}

/// Largest difference of an attribute that the rounding of one value explains on a configuration.
#[must_use]
pub fn rounding_limit(config: &Config) -> f64 {
    match config.attribute {
        AttributeFormat::Float(_) => ROUNDING_LIMIT,
        AttributeFormat::Fixed(fraction) => {
            let places = ROUNDED_PLACES * 0.5_f64.powi(fraction.number().fraction as i32);
            places.max(ROUNDING_LIMIT)
        }
    }
}

/// How far a stored or tested depth may be off: 16 units in the last place of a 24-bit depth, for the roundings of `f32` in setup
/// and of the fixed-point depths behind it.
pub const DEPTH_ROUNDING: f64 = 16.0 / (1 << 24) as f64;

/// Roundings of a fragment's depth behind its sums: of both sums, of the reciprocal, which may be made of Newton steps, and of the product.
const DEPTH_ROUNDINGS: f64 = 5.0;

/// How far a fragment's depth may be off where it is tested against one in memory.
#[must_use]
pub fn merge_rounding(config: &Config) -> f64 {
    DEPTH_ROUNDING + DEPTH_ROUNDINGS * 0.5_f64.powi(config.geometry.mantissa as i32 + 1)
}

/// How far ρ² may be off at the edge of a splat: some 2⁻²⁴ for each of its roundings, magnified by the foreshortening of splats that
/// are seen almost edge-on.
pub const EDGE_ROUNDING: f64 = 1.0 / (1 << 14) as f64;

/// How a frame differs from its reference, in pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Differences {
    /// Those that only one of both covers.
    #[serde(rename = "coverage_differences")]
    pub coverage: u64,
    /// Of those, pixels where the reference's surface lies within rounding of a depth in memory ([`merge_rounding`]), so that one of both was
    /// hidden.
    #[serde(rename = "merge_differences")]
    pub merge: u64,
    /// Those covered by both that took their cardinal attribute from another splat: two weights were nearly equal.
    #[serde(rename = "material_differences")]
    pub material: u64,
    /// Those covered by both whose attributes differ by more than the rounding of one value explains ([`rounding_limit`]).
    #[serde(rename = "outcome_differences")]
    pub outcome: u64,
    /// Of those, pixels where no test came near another outcome, and the rounding of their sums explains the difference ([`sum_limit`]).
    #[serde(rename = "sum_differences")]
    pub sum: u64,
    /// Of those, pixels where the reference's depth test came within [`DEPTH_ROUNDING`] of another outcome.
    #[serde(rename = "depth_test_differences")]
    pub depth_test: u64,
    /// Of the others, pixels where a sample's ρ² came within [`EDGE_ROUNDING`] of the edge of its splat.
    #[serde(rename = "edge_differences")]
    pub edge: u64,
}

impl Differences {
    pub(super) fn of(frame: &Frame, reference: &Frame, config: &Config) -> Self {
        let limit = rounding_limit(config);
        let mut found = Self::default();
        let tests = reference.margins.iter().zip(&reference.decisions);
        for (pair, (margins, decisions)) in frame.pixels.iter().zip(&reference.pixels).zip(tests) {
            match pair {
                (Some(a), Some(b)) => {
                    found.material += u64::from(a.material != b.material);
                    let apart = a.attributes.iter().zip(&b.attributes).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    if apart > limit {
                        found.outcome += 1;
                        let summed = sum_limit(config, decisions.pass + decisions.blend);
                        if margins.depth <= DEPTH_ROUNDING {
                            found.depth_test += 1;
                        } else if margins.edge <= EDGE_ROUNDING {
                            found.edge += 1;
                        } else if apart <= summed {
                            found.sum += 1;
                        }
                    }
                }
                (None, None) => {}
                _ => {
                    found.coverage += 1;
                    found.merge += u64::from(config.merge.is_on() && margins.depth <= merge_rounding(config));
                }
            }
        }
        found
    }

    /// Why pixels differ by more than one rounding, in words.
    fn explanation(&self) -> String {
        let Self { outcome, depth_test, edge, sum, .. } = *self;
        if outcome == 0 {
            return "0".to_owned();
        }
        let unexplained = outcome - depth_test - edge - sum;
        format!(
            "{outcome}: in {depth_test} the stored depth lies within rounding of an end of the ε-band, in \
             {edge} a sample within rounding of its splat's edge, so that a test came out differently; in {sum} \
             the sums were rounded, no test; {unexplained} are unexplained"
        )
    }

    /// Why pixels are covered differently, in words.
    fn covered(&self) -> String {
        match self.merge {
            0 => self.coverage.to_string(),
            merge => format!("{}: in {merge} the surface lies within rounding of a depth in memory", self.coverage),
        }
    }

    /// The figures with their names, in words.
    pub(super) fn rows(&self) -> [(&'static str, String); 3] {
        [
            ("pixels covered differently", self.covered()),
            ("pixels with another material", self.material.to_string()),
            ("pixels that differ by more than one rounding", self.explanation()),
        ]
    }
}
