//! Depth of a splat: at its centre, over the splat, and the band that counts as its surface (eq. 5.8, 5.9).

use super::axes::Frame;
use crate::compiler::{Value, name};
use crate::units::values::{Uniforms, Values};
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::{Band, DepthPlane, EpsilonScale};
use pointcore_contract::{Fixed, Signedness};

/// Depths as the record holds them.
const DEPTH: Fixed = Fixed { width: DEPTH_BITS, fraction: DEPTH_BITS, signed: Signedness::Unsigned };

/// A splat's depth.
pub(super) struct Depth {
    pub zero: Value,
    one: Value,
    /// What depth changes with `u_z`.
    pub b: Value,
    pub center: Value,
    /// Middle and half of what the splat spans.
    spread: [Value; 2],
    /// The splat lies wholly beyond the near plane.
    beyond_near: Value,
    /// Middle of the band, and half of it.
    middle: Value,
    epsilon: Value,
}

impl Depth {
    pub fn new(frame: &Frame) -> Self {
        let Frame { one, r, q, f, ref viewport, .. } = *frame;
        let b = viewport.declare(|viewport| viewport.depth_b) * r;
        let center = viewport.declare(|viewport| viewport.depth_a) + b;
        let spread_middle = center + b * (q * f);
        let spread_half = b.abs() * (frame.sqrt(q) * f);
        let zero = frame.constant(0.0);
        let beyond_near = zero.le(spread_middle - spread_half);
        let beyond_near = frame.whole.map_or(beyond_near, |whole| whole & beyond_near).named("beyond_near");
        let middle = beyond_near.mux(spread_middle, center);
        let half = beyond_near.mux(spread_half, b.abs().min(one));
        let uniforms = Uniforms::<EpsilonScale>::new(frame.program, frame.config, frame.config.geometry);
        let epsilon = half * uniforms.declare(|epsilon| epsilon.scale) + uniforms.declare(|epsilon| epsilon.bias);
        name!(in "depth"; b, center, middle, half);
        name!(spread_middle, spread_half, epsilon);
        Self { zero, one, b, center, spread: [spread_middle, spread_half], beyond_near, middle, epsilon }
    }

    /// One depth for all fragments.
    pub fn band(&self) -> Band<Values> {
        let fixed = |depth: Value| depth.max(self.zero).to_fixed(DEPTH);
        let Self { middle, epsilon, .. } = *self;
        Band { depth: fixed(middle), low: fixed(middle - epsilon), high: fixed(middle + epsilon) }
    }

    /// A plane, by its slopes along both axes of the image; `round` takes numbers to the rasterizer's format.
    pub fn plane(&self, slope: [Value; 2], round: impl Fn(Value) -> Value) -> DepthPlane<Values> {
        let [middle, half] = self.spread;
        DepthPlane {
            center: round(self.center),
            slope: slope.map(&round),
            range: [
                round(self.beyond_near.mux(middle - half, self.zero)),
                round(self.beyond_near.mux(middle + half, self.one)),
            ],
            epsilon: round(self.epsilon),
        }
    }
}
