//! Which columns and rows of samples may lie inside a splat.

use super::super::parts::division::sqrt;
use super::Slant;
use super::origin::Extent;
use crate::number::Number;
use pointcore_contract::splat::Division;
use pointcore_contract::{Format, Sampling};
use std::ops::Range;

/// Bounds as fixed-point numbers: 13 integer bits hold every image edge.
pub(super) const BOUND_BITS: u32 = 21;
/// Fraction bits of the bounds.
pub(super) const BOUND_FRACTION_BITS: u32 = 8;
/// The largest bound in pixels before the conversion.
const BOUND_MAX_PX: u64 = 8191;
/// One of [`BOUND_FRACTION_BITS`].
pub(super) const PIXEL: u64 = 1 << BOUND_FRACTION_BITS;
/// What bounds are wider by at either end, in units of [`BOUND_FRACTION_BITS`].
const FIRST_MARGIN: u64 = 1;
const LAST_MARGIN: u64 = 2;
/// Units in the last place that roundings may move a box's projected edge by, and more.
pub(super) const EDGE_UNITS: u64 = 16;

/// A splat's projection on one axis of the image.
#[derive(Clone, Copy)]
pub(super) struct Shadow {
    pub center: Number,
    pub a: Number,
    pub b: Number,
}

/// The ellipse of a splat before the eye along an axis: its middle, towards smaller coordinates from the centre, and its half, squared.
#[derive(Clone, Copy)]
pub(super) struct Span {
    pub middle: Number,
    pub squared: Number,
}

impl Shadow {
    /// What the splat's ellipse spans.
    pub fn span(&self, slant: &Slant, f: Number) -> Span {
        let Self { a, b, .. } = *self;
        let middle = (a * slant.alpha + b * slant.beta) * f;
        Span { middle, squared: middle * middle + (a * a + b * b) * f }
    }

    /// Bounds of a splat before the eye, from its ellipse.
    pub fn of_ellipse(&self, division: Division, span: Span) -> [Number; 2] {
        let (middle, h) = (self.center - span.middle, sqrt(division, span.squared));
        [middle - h, middle + h]
    }
}

/// Bounds of what a box shows before the eye. One that lies on one side of the axis is nowhere nearer to it than where it is deepest, at the
/// reciprocal depth `f`; of other sides nothing is known.
pub(super) fn of_box(extent: &Extent, axis: usize, f: Number, [scale, origin]: [Number; 2]) -> [Number; 2] {
    let zero = scale.of(0.0);
    let (low, high) = (extent.low(axis), extent.high(axis));
    let (is_right, is_left) = (zero.is_below(low), high.is_below(zero));
    let edge = ((scale * f) * if is_right { low } else { high }).shrunk(EDGE_UNITS) + origin;
    let is_mirrored = scale.is_negative();
    let begins = if is_mirrored { is_left } else { is_right };
    let ends = if is_mirrored { is_right } else { is_left };
    let farthest = Number::from_fixed(scale.format(), BOUND_MAX_PX, BOUND_BITS, 0);
    [if begins { edge } else { zero }, if ends { edge } else { farthest }]
}

/// Samples between two bounds along an axis, on which a pixel has so many; all of a pixel's, or none.
pub(in crate::splat) fn samples(
    format: Format,
    sampling: Sampling,
    per_pixel: u32,
    edge: u64,
    [low, high]: [Number; 2],
) -> Range<u64> {
    let zero = Number::new(format, 0);
    let farthest = Number::from_fixed(format, BOUND_MAX_PX, BOUND_BITS, 0);
    let low = low.max(zero).to_fixed(BOUND_BITS, BOUND_FRACTION_BITS);
    let high = high.min(farthest).max(zero).to_fixed(BOUND_BITS, BOUND_FRACTION_BITS);
    // From its corner, the nearest and farthest of a pixel's samples.
    let (nearest, farthest) = match sampling {
        Sampling::Center => (PIXEL / 2, PIXEL / 2),
        Sampling::Flipquad => (0, PIXEL * 5 / 8),
    };
    let first = (low + (PIXEL - 1) - farthest - FIRST_MARGIN) / PIXEL;
    let past = (high + PIXEL - nearest + LAST_MARGIN) / PIXEL;
    let samples = u64::from(per_pixel);
    first * samples..(past * samples).min(edge)
}
