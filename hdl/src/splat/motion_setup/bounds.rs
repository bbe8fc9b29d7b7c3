//! Samples within the hull of a moving splat's bounds at both ends of its life: a rectangle without the corners that diagonals cut off.

use super::instant::Instant;
use super::life::Life;
use super::{Frame, Moving};
use crate::compiler::{Type, Value, name};
use crate::splat::setup::axes::{BOUND_MAX, Grid, samples as samples_between};
use crate::units::values::Values;
use pointcore_contract::splat::records::{ImageDiagonals, ImageRectangle};
use pointcore_contract::{Fixed, Format, Signedness};

/// A limit in pixels, and beyond every one.
const SUM: Fixed = Fixed { width: 14, fraction: 0, signed: Signedness::Unsigned };
const FARTHEST: f64 = 16383.0;
/// Bits of a limit with its sign and a carry.
const LIMIT_BITS: u32 = SUM.width + 2;
/// What limits are wider by at begin and end.
const MARGIN: [u64; 2] = [2, 1];

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
    let extents = [0, 1].map(|end: usize| [0, 1].map(|axis| extent(frame, &instants[end], axis)));
    let grids = [
        Grid { pixels: config.width, columns: config.columns_a_pixel(), bits: config.column_bits() },
        Grid { pixels: config.height, columns: 1, bits: config.row_bits() },
    ];
    let [(left, right, has_columns), (top, bottom, has_rows)] = [0, 1].map(|axis: usize| {
        let [[begin_low, begin_high], [end_low, end_high]] =
            [0, 1].map(|end: usize| within(frame, instants[end].whole, extents[end][axis]));
        let hull = [begin_low.min(end_low), begin_high.max(end_high)];
        samples_between(config, frame.program, hull, grids[axis])
    });
    let (diagonals, has_diagonals) = diagonals(frame, instants[0].whole & instants[1].whole, extents);
    let bounds = ImageRectangle { left, right, top, bottom };
    Octagon { bounds, diagonals, occupied: has_columns & has_rows & has_diagonals }
}

/// Bounds along an axis at an instant at which all of the splat lies before the eye.
fn extent(frame: &Frame, instant: &Instant, axis: usize) -> [Value; 2] {
    let Instant { alpha, beta, reciprocal: g, .. } = *instant;
    let (center, a, b) = (instant.center[axis], instant.a[axis], instant.b[axis]);
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

/// Limits along the diagonals, of what both instants reach along both axes, and whether they leave a pixel. Formats less precise than `f24`
/// have none.
fn diagonals(frame: &Frame, whole: Value, [begin, end]: [[[Value; 2]; 2]; 2]) -> (ImageDiagonals<Values>, Value) {
    let config = frame.config;
    let (bits, program) = (config.diagonal_bits(), frame.program);
    let [open, largest] = [0, (1 << bits) - 1].map(|value| program.lit(bits, value));
    if frame.format.mantissa < Format::F24.mantissa {
        let record =
            ImageDiagonals { first_sum: open, last_sum: largest, first_difference: open, last_difference: largest };
        return (record, program.lit(1, 1));
    }
    let sum = |[x, y]: [[Value; 2]; 2]| [x[0] + y[0], x[1] + y[1]];
    let difference = |[x, y]: [[Value; 2]; 2]| [x[0] - y[1], x[1] - y[0]];
    let signed = |value: u64| program.constant(Type::Signed(LIMIT_BITS), value);
    let integer = |limit: Value| limit.to_fixed(SUM).resize(LIMIT_BITS).reinterpret(Type::Signed(LIMIT_BITS));
    let farthest = frame.constant(FARTHEST);
    let limits = |first: Value, last: Value| {
        let first = integer(first.max(frame.zero).min(farthest)) - signed(MARGIN[0]);
        let last = integer(last.min(farthest).max(frame.zero)) + signed(MARGIN[1]);
        let most = signed((1 << bits) - 1);
        let [first, last] = [first.max(signed(0)), last].map(|limit| limit.min(most).bits(bits - 1, 0));
        [whole.mux(first, open), whole.mux(last, largest)]
    };
    let ([begin_sum, end_sum], [begin_difference, end_difference]) =
        ([begin, end].map(sum), [begin, end].map(difference));
    let [first_sum, last_sum] = limits(begin_sum[0].min(end_sum[0]), begin_sum[1].max(end_sum[1]));
    let below = frame.constant(f64::from((1_u32 << config.row_bits()) - 1));
    let [first_difference, last_difference] =
        limits(begin_difference[0].min(end_difference[0]) + below, begin_difference[1].max(end_difference[1]) + below);
    name!(first_sum, last_sum, first_difference, last_difference);
    let occupied = first_sum.le(last_sum) & first_difference.le(last_difference);
    (ImageDiagonals { first_sum, last_sum, first_difference, last_difference }, occupied)
}
