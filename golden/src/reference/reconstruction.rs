//! One pixel of the surface reconstruction buffer: ternary depth test, accumulation, normalization (eqs. 5.8 to 5.13).

use super::projection::Projection;
use pointcore_contract::surface::CONTINUOUS_ATTRIBUTES;
use pointcore_contract::{Rendering, Splat};

/// Outcome of the ternary depth test (eq. 5.8).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision {
    /// The stored surface is nearer by more than ε: the splat is dropped.
    Fail,
    /// The splat is nearer by more than ε, or the pixel is empty: it replaces what is stored.
    Pass,
    /// Both belong to one surface: they are accumulated.
    Blend,
}

/// How often a pixel saw each outcome.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Decisions {
    /// See [`Decision::Fail`].
    pub fail: u32,
    /// See [`Decision::Pass`].
    pub pass: u32,
    /// See [`Decision::Blend`].
    pub blend: u32,
}

/// How near a pixel's tests came to another outcome: arithmetic that errs by more may decide otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margins {
    /// Least distance in depth of a stored depth from an end of an ε-band; infinite where none was tested.
    pub depth: f64,
    /// Least distance of a sample's `ρ²` from one, the edge of its splat, or of its depth from 0 or 1 where near or far plane cut its splat.
    pub edge: f64,
}

impl Default for Margins {
    fn default() -> Self {
        Self { depth: f64::INFINITY, edge: f64::INFINITY }
    }
}

impl Margins {
    /// Takes note of a sample's distance from an edge.
    pub fn note_edge(&mut self, distance: f64) {
        self.edge = self.edge.min(distance);
    }
}

/// A normalized pixel (eq. 5.13), ready for shading.
#[derive(Clone, Debug, PartialEq)]
pub struct Fragment {
    /// Depth in `0..=1`.
    pub depth: f64,
    /// The accumulated weight that depth and attributes were divided by.
    pub weight: f64,
    /// Continuous attributes, in the order of [`Splat::attributes`].
    pub attributes: [f64; CONTINUOUS_ATTRIBUTES],
    /// Cardinal attribute of the splat with the largest weight.
    pub material: u16,
}

/// A sample's depth and the ends of its ε-band.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    depth: f64,
    low: f64,
    high: f64,
}

impl Band {
    /// The band of eq. 5.9. Of a splat that ends before the near plane, the far limit is the near plane, where its depth is stored.
    #[must_use]
    pub fn around(depth: f64, projection: &Projection, rendering: &Rendering) -> Self {
        let epsilon = projection.half_depth * rendering.epsilon_scale + rendering.epsilon_bias;
        Self { depth, low: depth - epsilon, high: (depth + epsilon).max(0.0) }
    }

    /// A band that reaches every depth: such samples are blended whatever lies where.
    #[must_use]
    pub const fn everywhere(depth: f64) -> Self {
        Self { depth, low: f64::NEG_INFINITY, high: f64::INFINITY }
    }

    /// What holds both bands, at the depth between theirs.
    #[must_use]
    pub const fn hull(self, other: Self) -> Self {
        let depth = 0.5 * (self.depth + other.depth);
        Self { depth, low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The sample's depth.
    #[must_use]
    pub const fn depth(&self) -> f64 {
        self.depth
    }

    /// Whether a surface at a depth is nearer by more than ε.
    #[must_use]
    pub fn is_hidden_by(&self, stored: f64) -> bool {
        stored < self.low
    }
}

/// An accumulating pixel. It is empty iff its weight is zero, since every kernel weight is positive.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pixel {
    weight: f64,
    weighted_depth: f64,
    weighted_attributes: [f64; CONTINUOUS_ATTRIBUTES],
    /// The largest single weight since the last replacement. Eq. 5.12 compares with *the* stored weight, of which the
    /// cardinal attribute needs its own: against the accumulated sum, hardly any later splat could win, and the
    /// Voronoi cells that the thesis obtains need the maximum.
    cardinal_weight: f64,
    material: u16,
    /// How the tests of this pixel went.
    pub decisions: Decisions,
    /// How near this pixel's tests came to another outcome.
    pub margins: Margins,
}

impl Pixel {
    /// Adds a splat's sample of the given depth and kernel weight; says how its test went.
    pub fn add(&mut self, splat: &Splat, band: Band, weight: f64) -> Decision {
        let decision = self.test(band);
        match decision {
            Decision::Fail => self.decisions.fail += 1,
            Decision::Pass => {
                *self = Self { decisions: self.decisions, margins: self.margins, ..Self::default() };
                self.decisions.pass += 1;
                self.accumulate(splat, band.depth.clamp(0.0, 1.0), weight);
            }
            Decision::Blend => {
                self.decisions.blend += 1;
                self.accumulate(splat, band.depth.clamp(0.0, 1.0), weight);
            }
        }
        decision
    }

    /// Adds all that another pixel has summed up, whatever its depth.
    pub fn merge(&mut self, other: &Self) {
        self.weight += other.weight;
        self.weighted_depth += other.weighted_depth;
        for (sum, others) in self.weighted_attributes.iter_mut().zip(other.weighted_attributes) {
            *sum += others;
        }
        if self.cardinal_weight < other.cardinal_weight {
            self.cardinal_weight = other.cardinal_weight;
            self.material = other.material;
        }
    }

    /// Eq. 5.8; the stored depth is normalized first. Equality with a limit blends.
    fn test(&mut self, Band { low, high, .. }: Band) -> Decision {
        if self.weight == 0.0 {
            return Decision::Pass;
        }
        let stored = self.weighted_depth / self.weight;
        self.margins.depth = self.margins.depth.min((stored - low).abs()).min((stored - high).abs());
        if stored < low {
            Decision::Fail
        } else if stored > high {
            Decision::Pass
        } else {
            Decision::Blend
        }
    }

    /// Eqs. 5.11 and 5.12; on an emptied pixel they amount to eq. 5.10. Of equal weights the stored one keeps its
    /// cardinal attribute.
    fn accumulate(&mut self, splat: &Splat, depth: f64, weight: f64) {
        self.weight += weight;
        self.weighted_depth += weight * depth;
        for (sum, attribute) in self.weighted_attributes.iter_mut().zip(splat.attributes) {
            *sum += weight * f64::from(attribute);
        }
        if self.cardinal_weight < weight {
            self.cardinal_weight = weight;
            self.material = splat.material;
        }
    }

    /// Eq. 5.13; `None` if nothing fell on the pixel.
    #[must_use]
    pub fn normalized(&self) -> Option<Fragment> {
        (self.weight > 0.0).then(|| Fragment {
            depth: self.weighted_depth / self.weight,
            weight: self.weight,
            attributes: self.weighted_attributes.map(|sum| sum / self.weight),
            material: self.material,
        })
    }
}
