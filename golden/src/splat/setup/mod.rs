//! Setup unit: projection, bounds and depth band of a splat (thesis tables 5.1 and 5.2, recentred as docs/splat.md derives).
//!
//! A datapath of interval `setup_interval`, in the geometry format; the footprint leaves it in the rasterizer's. Bounds are rounded
//! outwards to pixels; a splat that crosses the eye plane has the viewport for bounds, unless that part is left out. Dropped are splats
//! behind the far plane, splats without a pixel and, with culling, splats that face away. A splat seen edge-on has no `Δ` to speak of,
//! and draws its screen filter's disc at most.

pub(super) mod fixed_footprint;
#[cfg(test)]
mod tests;

use super::parts::division::{recip, sqrt};
use super::uniforms::SetupUniforms;
use crate::datapath::Datapath;
use crate::number::Number;
use crate::unit::Model;
use fixed_footprint::Projection;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::{Band, DepthPlane, Footprint, ImageRectangle, SetupSplat, Splat};
pub use pointcore_contract::splat::units::setup::{In, Out};
use pointcore_contract::splat::{Config, Division, Feature, RasterFormat};
use pointcore_contract::{Format, Sampling};
use std::ops::Range;

/// `e` up to this power of ½ counts as crossing the eye plane, in a format as precise as `f32`.
const CLEARANCE_FRACTION_BITS: u32 = 12;
/// The same in less precise ones, where bounds so near the eye plane would be rounding.
const COARSE_CLEARANCE_FRACTION_BITS: u32 = 5;
/// Fraction bits of `f32`.
const FINE_MANTISSA_BITS: u32 = 23;
/// Bits of a difference's precision that its terms' own rounding takes: a `Δ` that has cancelled to that is none.
const ROUNDING_BITS: u32 = 4;
/// Bounds as fixed-point numbers: 13 integer bits hold every image edge.
const BOUND_BITS: u32 = 21;
/// Fraction bits of the bounds.
const BOUND_FRACTION_BITS: u32 = 8;
/// The largest bound in pixels before the conversion.
const BOUND_MAX_PX: u64 = 8191;
/// One of [`BOUND_FRACTION_BITS`].
const PIXEL: u64 = 1 << BOUND_FRACTION_BITS;
/// What bounds are wider by at either end, in units of [`BOUND_FRACTION_BITS`].
const FIRST_MARGIN: u64 = 1;
const LAST_MARGIN: u64 = 2;

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
    datapath: Datapath<SetupSplat>,
}

/// Why a splat is dropped; of several reasons the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dropped {
    /// It lies behind the far plane.
    Far,
    /// No pixel of the image is within its bounds.
    Beside,
    /// It faces away from the eye, and is culled.
    Facing,
}

/// How far a splat leans towards the eye: what the bounds of both axes and the depth share.
#[derive(Clone, Copy, Debug)]
pub struct Slant {
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
        let [ux, uy, uz] = splat.center.map(|bits| self.number(bits));
        let [[a1x, a1y, _], [a2x, a2y, _]] = splat.tangents.map(|tangent| tangent.map(|bits| self.number(bits)));
        let [scale_x, scale_y] = uniforms.viewport.scale.map(|bits| self.number(bits));
        let [origin_x, origin_y] = uniforms.viewport.origin.map(|bits| self.number(bits));

        let r = recip(self.division, uz);
        let (vx, vy) = (ux * r, uy * r);
        let slant = self.slant(splat, r);
        let (alpha, beta) = (slant.alpha, slant.beta);
        let (ax, bx) = (scale_x * (a1x * r - vx * alpha), scale_x * (a2x * r - vx * beta));
        let (ay, by) = (scale_y * (a1y * r - vy * alpha), scale_y * (a2y * r - vy * beta));
        let (cx, cy) = (scale_x * vx + origin_x, scale_y * vy + origin_y);

        let columns = self.bounds(0, cx, ax, bx, &slant, uniforms);
        let rows = self.bounds(1, cy, ay, by, &slant, uniforms);
        let depths = self.depths(r, &slant, uniforms).ok_or(Dropped::Far)?;
        if columns.is_empty() || rows.is_empty() {
            return Err(Dropped::Beside);
        }
        let delta = ax * by - bx * ay;
        let is_edge_on = self.is_cancelled(delta, ax * by);
        if self.culling.is_on() && !is_edge_on && !is_front(delta, scale_x, scale_y) {
            return Err(Dropped::Facing);
        }
        let m = [beta * ay - alpha * by, alpha * bx - beta * ax];
        let delta = (!is_edge_on).then_some(delta);
        let projection = Projection { center: [cx, cy], a: [ax, ay], b: [bx, by], delta, m };
        let footprint = match self.raster {
            RasterFormat::Float(format) => self.footprint(format, &projection, &depths),
            RasterFormat::Fixed(coefficient) => {
                let per_pixel = u64::from(self.sampling.columns());
                let columns = columns.start / per_pixel..columns.end / per_pixel;
                let footprint = fixed_footprint::footprint(coefficient, &projection, [columns, rows.clone()]);
                Footprint { band: depths.band(), ..footprint }
            }
        };
        let bounds = ImageRectangle {
            left: columns.start as u16,
            right: (columns.end - 1) as u16,
            top: rows.start as u16,
            bottom: (rows.end - 1) as u16,
        };
        Ok(SetupSplat { end: false, footprint, attributes: splat.attributes, bounds })
    }

    /// The footprint in a floating-point format.
    fn footprint(&self, format: Format, projection: &Projection, depths: &Depths) -> Footprint {
        let coefficient =
            |value: Number| if format == self.geometry { value.bits() } else { value.convert(format).bits() };
        let Projection { center, a, b, delta, m } = *projection;
        let slope = depths.slope(self.division, delta, m);
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
            band: depths.band(),
            plane,
        }
    }

    /// Whether a difference is rounding alone, by the exponents of it and of its first term.
    fn is_cancelled(&self, difference: Number, term: Number) -> bool {
        let resolution = u64::from(self.geometry.mantissa + 1 - ROUNDING_BITS);
        let exponent = difference.exponent_field();
        exponent == 0 || exponent + resolution < term.exponent_field()
    }

    /// The slant of a splat in camera space, whose centre's reciprocal depth is `r`.
    fn slant(&self, splat: &Splat, r: Number) -> Slant {
        let [alpha, beta] = splat.tangents.map(|[.., z]| self.number(z) * r);
        let squared = alpha * alpha + beta * beta;
        let e = self.constant(1, 0) - squared;
        let is_fine = self.geometry.mantissa >= FINE_MANTISSA_BITS;
        let clearance = if is_fine { CLEARANCE_FRACTION_BITS } else { COARSE_CLEARANCE_FRACTION_BITS };
        let is_whole = self.constant(1, clearance).is_below(e);
        let reciprocal = (is_whole || !self.eye_plane.is_on()).then(|| recip(self.division, e));
        Slant { alpha, beta, squared, is_whole, reciprocal }
    }

    /// How far a splat in camera space leans towards the eye.
    #[must_use]
    pub fn slant_of(&self, splat: &Splat) -> Slant {
        self.slant(splat, recip(self.division, self.number(splat.center[2])))
    }

    /// Rows or columns of samples that may lie inside the splat; all of a pixel's, or none.
    fn bounds(
        &self,
        axis: usize,
        c: Number,
        a: Number,
        b: Number,
        slant: &Slant,
        uniforms: &SetupUniforms,
    ) -> Range<u64> {
        let edge = self.edges[axis];
        let Some(f) = slant.reciprocal else { return 0..edge };
        let t = (a * slant.alpha + b * slant.beta) * f;
        let h = sqrt(self.division, t * t + (a * a + b * b) * f);
        let (mut low, mut high) = ((c - t) - h, (c - t) + h);
        if self.has_screen_filter {
            let radius = self.number(uniforms.filter_radius);
            low = low.min(c - radius);
            high = high.max(c + radius);
        }
        let zero = self.number(0);
        let low = low.max(zero).to_fixed(BOUND_BITS, BOUND_FRACTION_BITS);
        let high = high.min(self.constant(BOUND_MAX_PX, 0)).max(zero).to_fixed(BOUND_BITS, BOUND_FRACTION_BITS);
        // From its corner, the nearest and farthest of a pixel's samples.
        let (nearest, farthest) = match self.sampling {
            Sampling::Center => (PIXEL / 2, PIXEL / 2),
            Sampling::Flipquad => (0, PIXEL * 5 / 8),
        };
        let first = (low + (PIXEL - 1) - farthest - FIRST_MARGIN) / PIXEL;
        let past = (high + PIXEL - nearest + LAST_MARGIN) / PIXEL;
        let samples = [u64::from(self.sampling.columns()), 1][axis];
        first * samples..(past * samples).min(edge)
    }

    /// Depth range and ε (eqs. 5.8, 5.9); `None` behind the far plane.
    fn depths(&self, r: Number, slant: &Slant, uniforms: &SetupUniforms) -> Option<Depths> {
        let (zero, one) = (self.number(0), self.constant(1, 0));
        let scale = self.number(uniforms.viewport.depth_b) * r;
        let center = self.number(uniforms.viewport.depth_a) + scale;
        if !center.is_at_most(one) {
            return None;
        }
        let reach = sqrt(self.division, slant.squared);
        let range = slant.reciprocal.map(|f| (center + scale * (slant.squared * f), scale.abs() * (reach * f)));
        let beyond_near = range.filter(|(depth, half)| zero.is_at_most(*depth - *half));
        let (middle, half) = beyond_near.unwrap_or((center, scale.abs().min(one)));
        let range = beyond_near.map_or([zero, one], |(depth, half)| [depth - half, depth + half]);
        let epsilon = half * self.number(uniforms.epsilon.scale) + self.number(uniforms.epsilon.bias);
        Some(Depths { zero, scale, center, middle, range, epsilon })
    }
}

/// Depths of a splat.
struct Depths {
    zero: Number,
    /// `b`: the depth is `depth_a + b·u_z/z`.
    scale: Number,
    center: Number,
    middle: Number,
    range: [Number; 2],
    epsilon: Number,
}

impl Depths {
    fn band(&self) -> Band {
        let fixed = |depth: Number| depth.max(self.zero).to_fixed(DEPTH_BITS, DEPTH_BITS) as u32;
        let Self { middle, epsilon, .. } = *self;
        Band { depth: fixed(middle), low: fixed(middle - epsilon), high: fixed(middle + epsilon) }
    }

    /// By the pixel over the plane, where `u_z/z = D/Δ`; level without a `Δ`.
    fn slope(&self, division: Division, delta: Option<Number>, m: [Number; 2]) -> [Number; 2] {
        delta.map_or([self.zero; 2], |delta| {
            let scale = self.scale * recip(division, delta);
            m.map(|m| scale * m)
        })
    }
}

/// Whether the eye sees the front: `Δ` has the sign of `⟨u, a1 × a2⟩`, unless the image is mirrored.
fn is_front(delta: Number, scale_x: Number, scale_y: Number) -> bool {
    delta.is_negative() ^ scale_x.is_negative() ^ scale_y.is_negative()
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
        let In { viewport, epsilon, filter_radius, .. } = *inputs;
        let uniforms = SetupUniforms { viewport, epsilon, filter_radius };
        let accepted = accepted.and_then(|splat| self.setup(splat, &uniforms));
        self.datapath.step(accepted, inputs.out_ready);
    }
}
