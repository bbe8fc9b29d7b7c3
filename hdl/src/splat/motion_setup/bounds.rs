//! Samples within the hull of a moving splat's octagons at both ends of its life.

use super::instant::Instant;
use super::life::Life;
use super::{Frame, Moving};
use crate::compiler::{Value, name};
use crate::splat::setup::axes::{BOUND_MAX, Grid, samples as samples_between};
use crate::units::values::Values;
use pointcore_contract::splat::records::{ImageDiagonals, ImageRectangle};
use pointcore_contract::{Fixed, Format, Sampling, Signedness};

/// A limit in pixels, and beyond every one.
const SUM: Fixed = Fixed { width: 14, fraction: 0, signed: Signedness::Unsigned };
const FARTHEST: f64 = 16383.0;
/// What rounding may move a limit along a diagonal by, px: in `f32`, and in coarser formats.
const FINE_ROUNDING: f64 = 0.125;
const COARSE_ROUNDING: f64 = 0.5;

/// What a splat may reach.
pub(super) struct Octagon {
    pub bounds: ImageRectangle<Values>,
    pub diagonals: ImageDiagonals<Values>,
    /// There is a sample.
    pub occupied: Value,
}

/// Rectangle and diagonals.
pub(super) fn octagon(frame: &Frame, moving: &Moving, life: &Life) -> Octagon {
    let config = frame.config;
    let instants = [life.begin, life.end].map(|time| Instant::new(frame, moving, time));
    let extents = [0, 1].map(|end: usize| {
        let Instant { center, a, b, .. } = instants[end];
        [0, 1].map(|axis: usize| extent(frame, &instants[end], [center[axis], a[axis], b[axis]]))
    });
    let grids = [
        Grid { pixels: config.width, columns: config.sampling.columns(), bits: config.column_bits() },
        Grid { pixels: config.height, columns: 1, bits: config.row_bits() },
    ];
    let [(left, right, has_columns), (top, bottom, has_rows)] = [0, 1].map(|axis: usize| {
        let [[begin_low, begin_high], [end_low, end_high]] =
            [0, 1].map(|end: usize| within(frame, instants[end].whole, extents[end][axis]));
        let hull = [begin_low.min(end_low), begin_high.max(end_high)];
        samples_between(config, frame.program, hull, grids[axis])
    });
    let (diagonals, has_diagonals) = diagonals(frame, &instants);
    let bounds = ImageRectangle { left, right, top, bottom };
    Octagon { bounds, diagonals, occupied: has_columns & has_rows & has_diagonals }
}

/// Bounds of center and tangents along a direction at an instant at which all of the splat lies before the eye.
fn extent(frame: &Frame, instant: &Instant, [center, a, b]: [Value; 3]) -> [Value; 2] {
    let Instant { alpha, beta, reciprocal: g, .. } = *instant;
    let t = (a * alpha + b * beta) * g;
    let h = frame.sqrt(t * t + (a * a + b * b) * g);
    let middle = center - t;
    [middle - h, middle + h]
}

/// Bounds within all images; everything of a splat that reaches the eye plane.
fn within(frame: &Frame, whole: Value, [low, high]: [Value; 2]) -> [Value; 2] {
    let farthest = frame.constant(BOUND_MAX);
    [whole.mux(low.max(frame.zero), frame.zero), whole.mux(high.min(farthest), farthest)]
}

/// Limits along the diagonals, of what both instants reach along them, and whether they leave a pixel. Formats less precise than `f24` have none.
fn diagonals(frame: &Frame, instants: &[Instant; 2]) -> (ImageDiagonals<Values>, Value) {
    let config = frame.config;
    let (bits, program) = (config.diagonal_bits(), frame.program);
    let [open, largest] = [0, (1 << bits) - 1].map(|value| program.lit(bits, value));
    if frame.format.mantissa < Format::F24.mantissa {
        let record =
            ImageDiagonals { first_sum: open, last_sum: largest, first_difference: open, last_difference: largest };
        return (record, program.lit(1, 1));
    }
    let whole = instants[0].whole & instants[1].whole;
    let hull = |along: fn(Value, Value) -> Value| {
        let [begin, end] = [0, 1].map(|end: usize| {
            let Instant { center, a, b, .. } = instants[end];
            extent(frame, &instants[end], [center, a, b].map(|[x, y]| along(x, y)))
        });
        [begin[0].min(end[0]), begin[1].max(end[1])]
    };
    let rounding = if frame.format.mantissa < Format::F32.mantissa { COARSE_ROUNDING } else { FINE_ROUNDING };
    let farthest = frame.constant(FARTHEST);
    // Of the pixels whose samples' places, from the least to the most, may lie between both; `below` makes differences positive.
    let limits = |[low, high]: [Value; 2], [least, most]: [f64; 2], below: f64| {
        let first = low + frame.constant(below + 1.0 - most - rounding);
        let last = high + frame.constant(below + rounding - least);
        let within = |limit: Value| limit.to_fixed(SUM).min(program.lit(SUM.width, (1 << bits) - 1)).bits(bits - 1, 0);
        let first = within(first.max(frame.zero).min(farthest));
        let last = within(last.min(farthest).max(frame.zero));
        [whole.mux(first, open), whole.mux(last, largest)]
    };
    let [of_sum, of_difference] = match config.sampling {
        Sampling::Center => [[1.0; 2], [0.0; 2]],
        Sampling::Flipquad => [[0.375, 0.625], [-0.625, 0.625]],
    };
    let [first_sum, last_sum] = limits(hull(|x, y| x + y), of_sum, 0.0);
    let below = f64::from((1_u32 << config.row_bits()) - 1);
    let [first_difference, last_difference] = limits(hull(|x, y| x - y), of_difference, below);
    name!(first_sum, last_sum, first_difference, last_difference);
    let occupied = first_sum.le(last_sum) & first_difference.le(last_difference);
    (ImageDiagonals { first_sum, last_sum, first_difference, last_difference }, occupied)
}
