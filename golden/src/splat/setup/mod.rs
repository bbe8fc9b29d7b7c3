//! Setup unit: projection, bounds and depth band of a splat (thesis tables 5.1 and 5.2, recentred as docs/splat.md derives).
//!
//! A datapath of interval `setup_interval`, in the geometry format; the footprint leaves it in the rasterizer's. Bounds are rounded
//! outwards to pixels; those of a splat that crosses the eye plane hold its box as far as it lies before the eye. Dropped are splats
//! without a part between near and far plane, splats without a pixel and, with culling, splats that face away. A splat seen edge-on has no
//! `Δ` to speak of, and draws its screen filter's disc at most.

pub(super) mod bounds;
mod depths;
mod diagonals;
pub(super) mod fixed_footprint;
mod origin;
mod scaling;
pub(super) mod sight;
#[cfg(test)]
mod tests;

use super::parts::division::recip;
use super::uniforms::SetupUniforms;
use crate::datapath::{Datapath, Token};
use crate::number::Number;
use crate::unit::Model;
use bounds::{BOUND_BITS, EDGE_UNITS, Shadow};
use depths::Depths;
use diagonals::{Corners, Grid};
use fixed_footprint::Projection;
use origin::{Extent, Origin};
use pointcore_contract::splat::records::{DepthPlane, Footprint, ImageRectangle, SetupSplat, Sight, Splat};
pub use pointcore_contract::splat::units::setup::{In, Out};
use pointcore_contract::splat::{Config, Division, Feature, RasterFormat};
use pointcore_contract::{Format, Sampling};
use scaling::Coefficients;
use sight::Limits;
use std::ops::Range;

/// `e` up to this power of ½ counts as crossing the eye plane, in a format as precise as `f32`.
const CLEARANCE_FRACTION_BITS: u32 = 12;
/// The same in less precise ones, where bounds so near the eye plane would be rounding.
const COARSE_CLEARANCE_FRACTION_BITS: u32 = 5;
/// Fraction bits of `f32`.
const FINE_MANTISSA_BITS: u32 = 23;
/// Bits of a difference's precision that its terms' own rounding takes: a `Δ` that has cancelled to that is none.
const ROUNDING_BITS: u32 = 4;
/// Bits of it that may make a wrong sign in a format as precise as `f32`: such a splat is not culled.
const DOUBTFUL_BITS: u32 = 6;
/// The setup unit.
#[derive(Clone, Debug)]
pub struct Setup {
    geometry: Format,
    raster: RasterFormat,
    division: Division,
    culling: Feature,
    eye_plane: Feature,
    has_screen_filter: bool,
    edges: [u64; 2],
    sampling: Sampling,
    grid: Grid,
    datapath: Datapath<SetupSplat>,
}

/// Why a splat is dropped; of several reasons the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dropped {
    /// All of it lies before the near plane.
    Near,
    /// All of it lies behind the far plane.
    Far,
    /// No pixel of the image is within its bounds.
    Beside,
    /// It faces away from the eye, and is culled.
    Facing,
}

/// How far a splat leans towards the eye: what the bounds of both axes and the depth share.
#[derive(Clone, Copy, Debug)]
pub struct Slant {
    geometry: Format,
    one: Number,
    /// A tangent has taken the centre's place.
    is_turned: bool,
    /// The first tangent's depth relative to the centre's.
    pub alpha: Number,
    /// The second tangent's.
    pub beta: Number,
    /// `q = α² + β²`.
    squared: Number,
    /// Whether `e = 1 − q` says that the splat lies wholly in front of the eye.
    pub is_whole: bool,
    /// `f = 1/e`; `None` of a splat that is not whole, where there is a part that sees to it.
    reciprocal: Option<Number>,
}

impl Setup {
    /// The unit with a pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            geometry: config.geometry,
            raster: config.raster_format(),
            division: config.division,
            has_screen_filter: config.screen_filter.is_on(),
            culling: config.culling,
            eye_plane: config.eye_plane,
            edges: [config.width, config.height].map(u64::from),
            sampling: config.sampling,
            grid: Grid::new(config),
            datapath: Datapath::new(latency, config.setup_interval),
        }
    }

    fn number(&self, bits: u32) -> Number {
        Number::new(self.geometry, bits)
    }

    fn constant(&self, value: u64, fraction: u32) -> Number {
        Number::from_fixed(self.geometry, value, BOUND_BITS, fraction)
    }

    /// The splat with footprint and bounds; `None` if it is [dropped](Dropped).
    #[must_use]
    pub fn setup(&self, splat: &Splat, uniforms: &SetupUniforms) -> Option<SetupSplat> {
        self.outcome(splat, uniforms).ok()
    }

    /// The splat with footprint and bounds, or why there is none: the hardware drops it without saying why, but whoever sees nothing wants to know.
    ///
    /// # Errors
    /// It lies behind the far plane, covers no pixel, or faces away and is culled.
    pub fn outcome(&self, splat: &Splat, uniforms: &SetupUniforms) -> Result<SetupSplat, Dropped> {
        if splat.end {
            return Ok(SetupSplat { end: true, ..SetupSplat::default() });
        }
        let number = |bits| self.number(bits);
        let (scale, image_origin) = (uniforms.viewport.scale.map(number), uniforms.viewport.origin.map(number));
        let origin = self.origin(splat, uniforms);
        let extent = Extent::of(self.geometry, splat);
        if self.eye_plane.is_on() && !origin.is_beyond_near && !number(uniforms.near_plane).is_below(extent.high(2)) {
            return Err(Dropped::Near);
        }
        let (tangents, lowered) = self.lowered(&origin);
        let [first, second] = tangents;
        let r = recip(self.division, origin.center[2]);
        let slant = self.slant(&origin, tangents, lowered, r);
        let shadows = [0, 1].map(|axis| {
            let v = origin.center[axis] * r;
            let project = |tangent: [Number; 3], lean: Number| scale[axis] * (tangent[axis] * r - v * lean);
            let center = scale[axis] * v + image_origin[axis];
            Shadow { center, a: project(first, slant.alpha), b: project(second, slant.beta) }
        });
        let depths = Depths::new(self.division, r, &slant, origin.is_centered(), uniforms);
        if !(depths.is_center_before_far || self.begins_before_far(&extent, uniforms)) {
            return Err(Dropped::Far);
        }
        let has_disc = origin.is_centered() && depths.is_center_before_far;
        let spans = slant.reciprocal.map(|f| shadows.map(|shadow| shadow.span(&slant, f)));
        let [columns, rows] = [0, 1].map(|axis| {
            let ends = match spans {
                Some(spans) => shadows[axis].of_ellipse(self.division, spans[axis]),
                None => {
                    let deepest = recip(self.division, extent.high(2));
                    bounds::of_box(&extent, axis, deepest, [scale[axis], image_origin[axis]])
                }
            };
            let ends = self.with_disc(ends, shadows[axis].center, has_disc, uniforms);
            bounds::samples(self.geometry, self.sampling, [self.sampling.columns(), 1][axis], self.edges[axis], ends)
        });
        if columns.is_empty() || rows.is_empty() {
            return Err(Dropped::Beside);
        }
        let radius = (self.has_screen_filter && has_disc).then(|| number(uniforms.filter_radius));
        let corners = spans.zip(slant.reciprocal).map(|(spans, f)| Corners { shadows, spans, f, radius });
        let diagonals = self.grid.diagonals(self.division, corners).ok_or(Dropped::Beside)?;
        let (a, b) = (shadows.map(|shadow| shadow.a), shadows.map(|shadow| shadow.b));
        let scaled = Coefficients::new(a, b, [slant.alpha, slant.beta], lowered, depths.scale);
        let Coefficients { a, b, delta, m, unscaled, is_vanishing } = scaled;
        let is_fine = self.geometry.mantissa >= FINE_MANTISSA_BITS;
        let doubtful_bits = if is_fine { DOUBTFUL_BITS } else { ROUNDING_BITS };
        let is_edge_on = is_vanishing || self.is_cancelled(unscaled, ROUNDING_BITS);
        let is_doubtful = is_vanishing || self.is_cancelled(unscaled, doubtful_bits);
        let is_negative = unscaled[0].is_negative() ^ (origin.is_turned && origin.center[2].is_negative());
        let is_mirrored = scale[0].is_negative() ^ scale[1].is_negative() ^ origin.is_swapped;
        if self.culling.is_on() && !is_doubtful && is_negative == is_mirrored {
            return Err(Dropped::Facing);
        }
        let limits = Limits {
            is_negative,
            planes: depths.limits(self.division, delta),
            is_turned: origin.is_turned,
            has_disc: has_disc && self.has_screen_filter,
        };
        // `s1` comes in the place of `D`, with its sign.
        let a = if origin.is_turned { a.map(Number::negated) } else { a };
        let delta = (!is_edge_on).then_some(delta);
        let projection = Projection { center: shadows.map(|shadow| shadow.center), a, b, delta, m, limits };
        let footprint = self.footprint_of(&projection, &depths, [columns.clone(), rows.clone()]);
        let bounds = ImageRectangle {
            left: columns.start as u16,
            right: (columns.end - 1) as u16,
            top: rows.start as u16,
            bottom: (rows.end - 1) as u16,
        };
        let attributes = splat.attributes;
        Ok(SetupSplat { footprint, attributes, bounds, diagonals, ..SetupSplat::default() })
    }

    fn origin(&self, splat: &Splat, uniforms: &SetupUniforms) -> Origin {
        let near = self.eye_plane.is_on().then(|| self.number(uniforms.near_plane));
        Origin::of(self.geometry, splat, near)
    }

    /// The origin's tangents, and by how many powers of two they have been made shorter.
    fn lowered(&self, origin: &Origin) -> ([[Number; 3]; 2], i64) {
        match self.eye_plane {
            Feature::On => scaling::lowered(origin.center[2], origin.tangents),
            Feature::Off => (origin.tangents, 0),
        }
    }

    /// Whether the box of a splat begins before the far plane: `b/z ≤ 1 − a`, in whole terms.
    fn begins_before_far(&self, extent: &Extent, uniforms: &SetupUniforms) -> bool {
        let [base, scale] = [uniforms.viewport.depth_a, uniforms.viewport.depth_b].map(|bits| self.number(bits));
        let nearest = (self.constant(1, 0) - base) * extent.low(2);
        self.eye_plane.is_on() && scale.is_at_most(nearest.shrunk(EDGE_UNITS))
    }

    /// Bounds that hold the screen filter's disc, too.
    fn with_disc(
        &self,
        [low, high]: [Number; 2],
        center: Number,
        has_disc: bool,
        uniforms: &SetupUniforms,
    ) -> [Number; 2] {
        if !self.has_screen_filter || !has_disc {
            return [low, high];
        }
        let radius = self.number(uniforms.filter_radius);
        [low.min(center - radius), high.max(center + radius)]
    }

    /// The footprint in the rasterizer's format.
    fn footprint_of(&self, projection: &Projection, depths: &Depths, [columns, rows]: [Range<u64>; 2]) -> Footprint {
        let footprint = match self.raster {
            RasterFormat::Float(format) => self.footprint(format, projection, depths),
            RasterFormat::Fixed(coefficient) => {
                let per_pixel = u64::from(self.sampling.columns());
                let columns = columns.start / per_pixel..columns.end / per_pixel;
                let footprint = fixed_footprint::footprint(coefficient, projection, [columns, rows]);
                Footprint { band: depths.band(), ..footprint }
            }
        };
        let sight = if self.eye_plane.is_on() { footprint.sight } else { Sight::default() };
        Footprint { sight, ..footprint }
    }

    /// The footprint in a floating-point format.
    fn footprint(&self, format: Format, projection: &Projection, depths: &Depths) -> Footprint {
        let coefficient =
            |value: Number| if format == self.geometry { value.bits() } else { value.convert(format).bits() };
        let Projection { center, a, b, delta, m, limits } = *projection;
        // What changes with a pixel is `D`, or `s1` in its place.
        let slope = depths.slope(self.division, delta, if limits.is_turned { [a[1], a[0].negated()] } else { m });
        let plane = DepthPlane {
            center: coefficient(depths.center),
            slope: slope.map(coefficient),
            range: depths.range.map(coefficient),
            epsilon: coefficient(depths.epsilon),
        };
        Footprint {
            center: center.map(coefficient),
            ax: coefficient(a[0]),
            bx: coefficient(b[0]),
            ay: coefficient(a[1]),
            by: coefficient(b[1]),
            delta: delta.map_or(format.quiet_nan() as u32, coefficient),
            mx: coefficient(m[0]),
            my: coefficient(m[1]),
            shift: 0,
            sight: limits.floating(format),
            band: depths.band(),
            plane,
        }
    }

    /// Whether a difference is rounding alone, by the exponents of it and of its first term.
    fn is_cancelled(&self, [difference, term]: [Number; 2], rounding_bits: u32) -> bool {
        let resolution = u64::from(self.geometry.mantissa + 1 - rounding_bits);
        let exponent = difference.exponent_field();
        exponent == 0 || exponent + resolution < term.exponent_field()
    }

    /// The slant of what is projected, whose centre's reciprocal depth is `r`.
    fn slant(&self, origin: &Origin, tangents: [[Number; 3]; 2], lowered: i64, r: Number) -> Slant {
        let one = self.constant(1, 0);
        let [alpha, beta] = tangents.map(|[.., z]| z * r);
        let squared = alpha * alpha + beta * beta;
        let e = one - squared;
        let is_fine = self.geometry.mantissa >= FINE_MANTISSA_BITS;
        let clearance = if is_fine { CLEARANCE_FRACTION_BITS } else { COARSE_CLEARANCE_FRACTION_BITS };
        let is_whole = self.constant(1, clearance).is_below(e) && !origin.is_turned && lowered == 0;
        let reciprocal = (is_whole || !self.eye_plane.is_on()).then(|| recip(self.division, e));
        Slant { geometry: self.geometry, one, is_turned: origin.is_turned, alpha, beta, squared, is_whole, reciprocal }
    }

    /// How far a splat in camera space leans towards the eye.
    #[must_use]
    pub fn slant_of(&self, splat: &Splat, uniforms: &SetupUniforms) -> Slant {
        let origin = self.origin(splat, uniforms);
        let (tangents, lowered) = self.lowered(&origin);
        self.slant(&origin, tangents, lowered, recip(self.division, origin.center[2]))
    }
}

impl Model for Setup {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.datapath.in_ready(), out: self.datapath.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let accepted = inputs.input.as_ref().filter(|_| self.datapath.in_ready());
        let In { viewport, epsilon, near_plane, filter_radius, .. } = *inputs;
        let uniforms = SetupUniforms { viewport, epsilon, near_plane, filter_radius };
        let accepted = accepted.map(|splat| Token::from(self.setup(splat, &uniforms)));
        self.datapath.step(accepted, inputs.out_ready);
    }
}
