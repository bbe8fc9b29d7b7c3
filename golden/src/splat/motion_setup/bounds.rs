//! Which samples a moving splat may reach: those within the hull of its bounds at both ends of its life, a rectangle without the corners that
//! diagonals cut off.

use super::instant::Instant;
use super::life::Life;
use super::{MotionSetup, MotionUniforms, Moving};
use crate::number::Number;
use crate::splat::setup::bounds;
use pointcore_contract::Format;
use pointcore_contract::splat::records::{ImageDiagonals, ImageRectangle};

/// Beyond every image, px.
const FARTHEST: f32 = 8191.0;
/// Beyond every sum of a column and a row.
const FARTHEST_SUM: f32 = 16383.0;
/// Bits of a sum.
const SUM_BITS: u32 = 14;
/// Pixels by which limits along diagonals are wider than they come out, at their begin and at their end: for the place of samples within their pixel,
/// and for roundings.
const MARGIN: [u64; 2] = [2, 1];

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
    let Instant { alpha, beta, reciprocal: g, .. } = *instant;
    let (center, a, b) = (instant.center[axis], instant.a[axis], instant.b[axis]);
    let t = (a * alpha + b * beta) * g;
    let h = unit.sqrt(t * t + (a * a + b * b) * g);
    let middle = center - t;
    [middle - h, middle + h]
}

/// Limits of the hull of both boxes: every point of the splat goes from a place in one to a place in the other, along a line. None where one is
/// not known, or too coarsely.
fn diagonals(unit: &MotionSetup, ends: &[Instant; 2]) -> ImageDiagonals {
    let largest = (1 << unit.config.diagonal_bits()) - 1;
    if unit.geometry.mantissa < Format::F24.mantissa || !ends.iter().all(|end| end.is_whole) {
        return ImageDiagonals { first_sum: 0, last_sum: largest, first_difference: 0, last_difference: largest };
    }
    let boxes = [0, 1].map(|end: usize| [0, 1].map(|axis| extent(unit, &ends[end], axis)));
    let sums = boxes.map(|[x, y]| [x[0] + y[0], x[1] + y[1]]);
    let differences = boxes.map(|[x, y]| [x[0] - y[1], x[1] - y[0]]);
    let below = unit.one().of(f32::from((1_u16 << unit.config.row_bits()) - 1));
    let limits = |[begin, end]: [[Number; 2]; 2], from: Number| {
        let (zero, farthest) = (unit.number(0), from.of(FARTHEST_SUM));
        let first = (begin[0].min(end[0]) + from).max(zero).min(farthest).to_fixed(SUM_BITS, 0);
        let last = (begin[1].max(end[1]) + from).min(farthest).max(zero).to_fixed(SUM_BITS, 0);
        [first.saturating_sub(MARGIN[0]), last + MARGIN[1]].map(|limit| limit.min(largest.into()) as u16)
    };
    let [first_sum, last_sum] = limits(sums, unit.number(0));
    let [first_difference, last_difference] = limits(differences, below);
    ImageDiagonals { first_sum, last_sum, first_difference, last_difference }
}
