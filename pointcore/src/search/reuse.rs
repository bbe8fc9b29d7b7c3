//! When the coherent neighbor cache may answer a query with the neighborhood of another (thesis 6.4.2).

use super::SearchError;
use crate::number::encode;
use pointcore_contract::Format;
use pointcore_contract::search::records::CacheSetup;

/// Units in the last place by which coverage is understated, so that no rounding lets a query pass whose neighbors would differ.
const GUARD_ULPS: f32 = 32.0;

/// What queries of one search have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QueryKind {
    /// They ask for the k nearest neighbors.
    Nearest,
    /// They ask for neighbors within a radius.
    Ball,
}

/// How far neighborhoods may be reused.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Reuse {
    /// Neighbors may be farther than the true ones by the factor 1 + ε; 0 for exact ones.
    pub epsilon: f32,
    /// Balls are searched with their radius times this, so that near queries find themselves covered.
    pub alpha: f32,
}

impl Default for Reuse {
    fn default() -> Self {
        Self { epsilon: 0.0, alpha: 1.25 }
    }
}

impl Reuse {
    /// Tolerances that make sense.
    pub const EPSILON: std::ops::RangeInclusive<f32> = 0.0..=10.0;
    /// Extensions that make sense.
    pub const ALPHA: std::ops::RangeInclusive<f32> = 1.0..=10.0;

    /// Checks both factors.
    ///
    /// # Errors
    /// The first one without meaning.
    pub fn validate(&self) -> Result<(), SearchError> {
        let wrong = |setting, value: f32, expected| Err(SearchError::Reuse { setting, value, expected });
        if !Self::EPSILON.contains(&self.epsilon) {
            return wrong("epsilon", self.epsilon, "0 to 10");
        }
        if !Self::ALPHA.contains(&self.alpha) {
            return wrong("alpha", self.alpha, "1 to 10");
        }
        Ok(())
    }

    /// What the core is told: eq. 6.5 for k nearest neighbors, eq. 6.6 for balls.
    #[must_use]
    pub fn setup(self, format: Format, kind: QueryKind) -> CacheSetup {
        let guard = 1.0 - GUARD_ULPS / (1_u32 << format.mantissa) as f32;
        let (far_scale, margin_scale) = match kind {
            QueryKind::Ball => (guard, 1.0 + self.epsilon),
            QueryKind::Nearest => ((1.0 + self.epsilon) * guard, 1.0 / (2.0 + self.epsilon)),
        };
        CacheSetup {
            ball: kind == QueryKind::Ball,
            far_scale: encode(format, far_scale),
            margin_scale: encode(format, margin_scale),
        }
    }

    /// The squared radius with which a ball is searched.
    pub(super) fn extended_radius2(self, format: Format, radius: f32) -> u32 {
        let extended = radius * self.alpha;
        encode(format, extended * extended)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::decode;

    #[test]
    fn coverage_follows_the_table_and_is_understated() {
        for format in [Format::F32.flushed(), Format::F24] {
            let reuse = Reuse { epsilon: 0.5, alpha: 2.0 };
            let scales = |kind| {
                let CacheSetup { ball, far_scale, margin_scale } = reuse.setup(format, kind);
                (ball, decode(format, far_scale), decode(format, margin_scale))
            };
            let (ball, far_scale, margin_scale) = scales(QueryKind::Nearest);
            assert!(!ball && far_scale < 1.5 && far_scale > 1.498);
            assert!((margin_scale - 0.4).abs() < 1e-4);
            let (ball, far_scale, margin_scale) = scales(QueryKind::Ball);
            assert!(ball && far_scale < 1.0 && far_scale > 0.999 && margin_scale == 1.5);
            assert_eq!(decode(format, reuse.extended_radius2(format, 1.5)), 9.0);
        }
    }

    #[test]
    fn factors_without_meaning_are_refused() {
        let sound = Reuse::default();
        assert!(sound.validate().is_ok());
        for reuse in [
            Reuse { epsilon: -0.1, ..sound },
            Reuse { epsilon: f32::NAN, ..sound },
            Reuse { alpha: 0.9, ..sound },
            Reuse { alpha: f32::INFINITY, ..sound },
        ] {
            assert!(reuse.validate().unwrap_err().to_string().contains("expected"), "{reuse:?}");
        }
    }
}
