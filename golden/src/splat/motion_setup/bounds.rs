//! Which samples a moving splat may reach: those within the hull of its bounds at both ends of its life.

use super::instant::Instant;
use super::life::Life;
use super::{MotionSetup, MotionUniforms, Moving};
use crate::number::Number;
use crate::splat::setup::bounds;
use std::ops::Range;

/// Beyond every image, px.
const FARTHEST: f32 = 8191.0;

/// Columns and rows of samples; `None` where there are none.
pub(super) fn samples(
    unit: &MotionSetup,
    moving: &Moving,
    life: &Life,
    uniforms: &MotionUniforms,
) -> Option<(Range<u64>, Range<u64>)> {
    let ends = [life.begin, life.end].map(|time| Instant::of(unit, moving, time, uniforms));
    let [columns, rows] = [0, 1].map(|axis| {
        let [[begin_low, begin_high], [end_low, end_high]] = [0, 1].map(|end| within(unit, &ends[end], axis));
        let hull = [begin_low.min(end_low), begin_high.max(end_high)];
        bounds::samples(unit.geometry, unit.sampling, axis, unit.edges[axis], hull)
    });
    (!columns.is_empty() && !rows.is_empty()).then_some((columns, rows))
}

/// Bounds along an axis at an instant, within all images; everything of a splat that reaches the eye plane.
fn within(unit: &MotionSetup, instant: &Instant, axis: usize) -> [Number; 2] {
    let Instant { alpha, beta, reciprocal: g, .. } = *instant;
    let (zero, farthest) = (unit.number(0), unit.one().of(FARTHEST));
    if !instant.is_whole {
        return [zero, farthest];
    }
    let (center, a, b) = (instant.center[axis], instant.a[axis], instant.b[axis]);
    let t = (a * alpha + b * beta) * g;
    let h = unit.sqrt(t * t + (a * a + b * b) * g);
    let middle = center - t;
    [(middle - h).max(zero), (middle + h).min(farthest)]
}
