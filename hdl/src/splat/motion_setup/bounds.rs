//! Samples within the hull of a moving splat's bounds at both ends of its life.

use super::instant::Instant;
use super::life::Life;
use super::{Frame, Moving};
use crate::compiler::Value;
use crate::splat::setup::axes::{BOUND_MAX, Grid, samples as samples_between};

/// Samples along an axis.
pub(super) struct Span {
    pub first: Value,
    pub last: Value,
    /// There is one.
    pub occupied: Value,
}

/// Columns and rows of samples.
pub(super) fn samples(frame: &Frame, moving: &Moving, life: &Life) -> [Span; 2] {
    let config = frame.config;
    let instants = [life.begin, life.end].map(|time| Instant::new(frame, moving, time));
    let grids = [
        Grid { pixels: config.width, columns: config.sampling.columns(), bits: config.column_bits() },
        Grid { pixels: config.height, columns: 1, bits: config.row_bits() },
    ];
    [0, 1].map(|axis: usize| {
        let [[begin_low, begin_high], [end_low, end_high]] =
            [0, 1].map(|end: usize| within(frame, &instants[end], axis));
        let hull = [begin_low.min(end_low), begin_high.max(end_high)];
        let (first, last, occupied) = samples_between(config, frame.program, hull, grids[axis]);
        Span { first, last, occupied }
    })
}

/// Bounds along an axis at an instant, within all images; everything of a splat that reaches the eye plane.
fn within(frame: &Frame, instant: &Instant, axis: usize) -> [Value; 2] {
    let Instant { alpha, beta, reciprocal: g, whole, .. } = *instant;
    let (center, a, b) = (instant.center[axis], instant.a[axis], instant.b[axis]);
    let t = (a * alpha + b * beta) * g;
    let h = frame.sqrt(t * t + (a * a + b * b) * g);
    let middle = center - t;
    let farthest = frame.constant(BOUND_MAX);
    [whole.mux((middle - h).max(frame.zero), frame.zero), whole.mux((middle + h).min(farthest), farthest)]
}
