//! A splat along the axes of the image: its projection and the samples within its bounds.

use super::exponent::Exponents;
use super::origin::{Eye, Origin};
use crate::compiler::{Program, Type, Value, name};
use crate::splat::parts::division::{recip, sqrt};
use crate::units::values::Uniforms;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{AXES, Viewport};
use pointcore_contract::splat::units::setup::PORTS;
use pointcore_contract::{Fixed, Format, Sampling, Signedness};

/// Where bounds saturate, in px: beyond every image.
pub(in crate::splat) const BOUND_MAX: f64 = 8191.0;
/// Units in the last place by which the projection of a box's edge is moved towards the axis: more than it is rounded by.
pub(super) const EDGE_UNITS: u64 = 16;
/// Bounds are rounded to pixels from so many fraction bits.
const BOUND: Fixed = Fixed { width: 21, fraction: 8, signed: Signedness::Unsigned };

/// What rounds bounds with 8 fraction bits to the first and one past the last pixel with a sample within 1/256 px of them:
/// `(bound + offset) >> 8`.
const fn offsets(sampling: Sampling) -> (u64, u64) {
    match sampling {
        // ceil(low − ½ − 1/256) and 1 + floor(high − ½ + 2/256).
        Sampling::Center => (126, 130),
        // A pixel's samples reach from its edge to ⅝: ceil(low − ⅝ − 1/256) and 1 + floor(high + 2/256).
        Sampling::Flipquad => (94, 258),
    }
}

/// Smallest `e` for which a splat counts as wholly in front of the eye; below, its bounds would be rounding.
pub(in crate::splat) const fn clearance(format: Format) -> f64 {
    if format.mantissa < Format::F32.mantissa { 1.0 / 32.0 } else { 1.0 / 4096.0 }
}

/// One image axis: projected centre, the tangents' components, and the pixels within the bounds.
pub(super) struct Axis {
    /// Sign of the image's scale.
    pub mirrored: Value,
    pub center: Value,
    pub a: Value,
    pub b: Value,
    /// Of the ellipse: its middle, towards smaller coordinates from the centre, and its half, squared.
    pub middle: Value,
    pub squared: Value,
    pub first: Value,
    pub last: Value,
    pub occupied: Value,
}

/// The samples of an image along an axis.
#[derive(Clone, Copy)]
pub(in crate::splat) struct Grid {
    /// Pixels of the image.
    pub pixels: u32,
    /// Columns of samples to a pixel.
    pub columns: u32,
    /// Bits of a sample's index.
    pub bits: u32,
}

/// What the axes and the depth share.
pub(super) struct Frame<'a> {
    pub config: &'a Config,
    pub program: &'a Program,
    pub origin: Origin,
    pub viewport: Uniforms<'a, Viewport>,
    pub one: Value,
    /// `1/u_z`.
    pub r: Value,
    pub alpha: Value,
    pub beta: Value,
    /// `α² + β²`.
    pub q: Value,
    /// `1/e` with `e = 1 − q`; of a splat that is not whole, the reciprocal depth of where it is deepest.
    pub f: Value,
    /// The splat lies wholly in front of the eye; none where every splat is taken to.
    pub whole: Option<Value>,
    /// Radius of the screen filter, where there is one.
    pub filter_radius: Option<Value>,
}

impl<'a> Frame<'a> {
    pub fn new(config: &'a Config, program: &'a Program, origin: Origin) -> Self {
        let format = config.geometry;
        let one = program.float(format, 1.0);
        let [[_, _, v1_z], [_, _, v2_z]] = origin.tangents;
        let r = recip(config.division, origin.center[2]);
        let alpha = v1_z * r;
        let beta = v2_z * r;
        let q = alpha * alpha + beta * beta;
        let e = one - q;
        let whole = origin.eye.map(|Eye { turned, lowered, .. }| {
            let exponents = Exponents { program, format };
            let before_eye = program.float(format, clearance(format)).lt(e);
            (before_eye & !turned & lowered.eq(exponents.lit(0))).named("whole")
        });
        let divisor = origin.eye.zip(whole).map_or(e, |(eye, whole)| whole.mux(e, eye.high(2)));
        let f = recip(config.division, divisor);
        name!(r, alpha, beta, q, e, f);
        let has_filter = config.screen_filter.is_on();
        let filter_radius = has_filter.then(|| program.uniform(PORTS.filter_radius.name, Type::Float(format)));
        let viewport = Uniforms::new(program, config, format);
        Self { config, program, origin, viewport, one, r, alpha, beta, q, f, whole, filter_radius }
    }

    pub fn exponents(&self) -> Exponents<'_> {
        Exponents { program: self.program, format: self.config.geometry }
    }

    pub fn constant(&self, value: f64) -> Value {
        self.program.float(self.config.geometry, value)
    }

    pub fn sqrt(&self, value: Value) -> Value {
        sqrt(self.config.division, self.program, self.config.geometry, value)
    }

    /// The splat along `axis`, 0 for x; `shown` says whether its filter's disc is drawn, where that is a question.
    pub fn axis(&self, axis: usize, grid: Grid, shown: Option<Value>) -> Axis {
        let [tangent1, tangent2] = self.origin.tangents.map(|tangent| tangent[axis]);
        let scale = self.viewport.declare(|viewport| viewport.scale[axis]);
        let image_origin = self.viewport.declare(|viewport| viewport.origin[axis]);
        let v = self.origin.center[axis] * self.r;
        let a = scale * (tangent1 * self.r - v * self.alpha);
        let b = scale * (tangent2 * self.r - v * self.beta);
        let center = scale * v + image_origin;

        let t = (a * self.alpha + b * self.beta) * self.f;
        let squared = t * t + (a * a + b * b) * self.f;
        let h = self.sqrt(squared);
        let middle = center - t;
        let (mut low, mut high) = (middle - h, middle + h);
        name!(in AXES[axis]; v, a, b, center, t, h, low, high);
        if let (Some(whole), Some(eye)) = (self.whole, self.origin.eye) {
            let [box_low, box_high] = self.box_bounds(eye, axis, scale, image_origin);
            (low, high) = (whole.mux(low, box_low), whole.mux(high, box_high));
        }
        if let Some(radius) = self.filter_radius {
            let (disc_low, disc_high) = (low.min(center - radius), high.max(center + radius));
            let drawn = |disc, without| shown.map_or(disc, |shown| shown.mux(disc, without));
            (low, high) = (drawn(disc_low, low), drawn(disc_high, high));
        }
        let (first, last, occupied) = samples(self.config, self.program, [low, high], grid);
        name!(in AXES[axis]; first, last, occupied);
        let top = self.config.geometry.width() - 1;
        Axis { mirrored: scale.bits(top, top), center, a, b, middle: t, squared, first, last, occupied }
    }

    /// Bounds of what a splat's box shows before the eye, with `f` for where that is deepest.
    fn box_bounds(&self, eye: Eye, axis: usize, scale: Value, image_origin: Value) -> [Value; 2] {
        let (zero, exponents) = (self.constant(0.0), self.exponents());
        let (box_low, box_high) = (eye.low(axis), eye.high(axis));
        let (right, left) = (zero.lt(box_low), box_high.lt(zero));
        let projected = (scale * self.f) * right.mux(box_low, box_high);
        let edge = exponents.shrunk(projected, EDGE_UNITS) + image_origin;
        let mirrored = exponents.sign(scale);
        let (begins, ends) = (mirrored.mux(left, right), mirrored.mux(right, left));
        [begins.mux(edge, zero), ends.mux(edge, self.constant(BOUND_MAX))]
    }
}

/// First and last row or column of samples between two bounds, `columns` to a pixel, and whether there is one; a NaN widens the bounds.
pub(in crate::splat) fn samples(
    config: &Config,
    program: &Program,
    [low, high]: [Value; 2],
    Grid { pixels, columns, bits }: Grid,
) -> (Value, Value, Value) {
    let sum_bits = BOUND.width + 1;
    let constant = |value| program.lit(sum_bits, value);
    let number = |value| program.float(config.geometry, value);
    let zero = number(0.0);
    let fraction = BOUND.fraction;
    let round = |bound: Value, offset| {
        let pixel = (bound.to_fixed(BOUND).resize(sum_bits) + constant(offset)) >> fraction;
        if columns == 1 { pixel } else { pixel.cat(program.lit(columns.ilog2(), 0)).resize(sum_bits) }
    };
    let (first_offset, past_offset) = offsets(config.sampling);
    let first = round(low.max(zero), first_offset);
    let past = round(high.min(number(BOUND_MAX)).max(zero), past_offset);
    let edge = constant(pixels.into());
    let past = past.min(edge);
    let last = past - constant(1);
    (first.resize(bits), last.resize(bits), first.lt(past))
}
