//! Which samples a moving splat may reach: those within the hull of its octagons at both ends of its life.

use super::instant::Instant;
use super::life::Life;
use super::{MotionSetup, MotionUniforms, Moving};
use crate::number::Number;
use crate::splat::setup::bounds;
use pointcore_contract::splat::records::{ImageDiagonals, ImageRectangle};
use pointcore_contract::{Format, Sampling};

/// Beyond every image, px.
const FARTHEST: f32 = 8191.0;
/// Beyond every sum of a column and a row.
const FARTHEST_SUM: f32 = 16383.0;
/// Bits of a sum.
const SUM_BITS: u32 = 14;
/// What rounding may move a limit along a diagonal by, px, in a format as precise as `f32`, and in others.
const ROUNDING: [f32; 2] = [0.125, 0.5];

/// Rectangle and diagonals; `None` where there is no sample.
pub(super) fn octagon(
    unit: &MotionSetup,
    moving: &Moving,
    life: &Life,
    uniforms: &MotionUniforms,
) -> Option<(ImageRectangle, ImageDiagonals)> {
    let ends = [life.begin, life.end].map(|time| Instant::of(unit, moving, time, uniforms));
    let [columns, rows] = [0, 1].map(|axis| {
        let [[begin_low, begin_high], [end_low, end_high]] = [0, 1].map(|end| within(unit, &ends[end], axis));
        let hull = [begin_low.min(end_low), begin_high.max(end_high)];
        bounds::samples(unit.geometry, unit.config.sampling, unit.per_pixel[axis], unit.edges[axis], hull)
    });
    if columns.is_empty() || rows.is_empty() {
        return None;
    }
    let bounds = ImageRectangle {
        left: columns.start as u16,
        right: (columns.end - 1) as u16,
        top: rows.start as u16,
        bottom: (rows.end - 1) as u16,
    };
    let diagonals = diagonals(unit, &ends);
    let is_empty = diagonals.first_sum > diagonals.last_sum || diagonals.first_difference > diagonals.last_difference;
    (!is_empty).then_some((bounds, diagonals))
}

/// Bounds along an axis at an instant, within all images; everything of a splat that reaches the eye plane.
fn within(unit: &MotionSetup, instant: &Instant, axis: usize) -> [Number; 2] {
    let (zero, farthest) = (unit.number(0), unit.one().of(FARTHEST));
    if !instant.is_whole {
        return [zero, farthest];
    }
    let [low, high] = extent(unit, instant, axis);
    [low.max(zero), high.min(farthest)]
}

/// Bounds along an axis at an instant at which all of the splat lies before the eye.
fn extent(unit: &MotionSetup, instant: &Instant, axis: usize) -> [Number; 2] {
    reach(unit, instant, [instant.center, instant.a, instant.b].map(|vector| vector[axis]))
}

/// Bounds of center and tangents along any direction at such an instant.
fn reach(unit: &MotionSetup, instant: &Instant, [center, a, b]: [Number; 3]) -> [Number; 2] {
    let Instant { alpha, beta, reciprocal: g, .. } = *instant;
    let t = (a * alpha + b * beta) * g;
    let h = unit.sqrt(t * t + (a * a + b * b) * g);
    let middle = center - t;
    [middle - h, middle + h]
}

/// The least and the largest place of a sample in its pixel along sum and difference.
const fn places(sampling: Sampling) -> [[f32; 2]; 2] {
    match sampling {
        Sampling::Center => [[1.0, 1.0], [0.0, 0.0]],
        Sampling::Flipquad => [[0.375, 0.625], [-0.625, 0.625]],
    }
}

/// Limits of the hull of both octagons: every point of the splat goes from a place in one to a place in the other, along a line. None where one is
/// not known, or too coarsely.
fn diagonals(unit: &MotionSetup, ends: &[Instant; 2]) -> ImageDiagonals {
    let largest = (1 << unit.config.diagonal_bits()) - 1;
    let mantissa = unit.geometry.mantissa;
    if mantissa < Format::F24.mantissa || !ends.iter().all(|end| end.is_whole) {
        return ImageDiagonals { first_sum: 0, last_sum: largest, first_difference: 0, last_difference: largest };
    }
    let along = |[x, y]: [Number; 2], is_sum: bool| if is_sum { x + y } else { x - y };
    let hull = |is_sum: bool| {
        let [begin, end] = [0, 1].map(|end: usize| {
            let instant = &ends[end];
            reach(unit, instant, [instant.center, instant.a, instant.b].map(|vector| along(vector, is_sum)))
        });
        [begin[0].min(end[0]), begin[1].max(end[1])]
    };
    let rounding = ROUNDING[usize::from(mantissa < Format::F32.mantissa)];
    let limits = |[low, high]: [Number; 2], [least, most]: [f32; 2], below: f32| {
        let (zero, farthest) = (unit.number(0), low.of(FARTHEST_SUM));
        let [first, last] = [1.0 - most - rounding, rounding - least].map(|offset| low.of(below + offset));
        let first = (low + first).max(zero).min(farthest).to_fixed(SUM_BITS, 0);
        let last = (high + last).min(farthest).max(zero).to_fixed(SUM_BITS, 0);
        [first, last].map(|limit| limit.min(largest.into()) as u16)
    };
    let [of_sum, of_difference] = places(unit.config.sampling);
    let below = f32::from((1_u16 << unit.config.row_bits()) - 1);
    let [first_sum, last_sum] = limits(hull(true), of_sum, 0.0);
    let [first_difference, last_difference] = limits(hull(false), of_difference, below);
    ImageDiagonals { first_sum, last_sum, first_difference, last_difference }
}
