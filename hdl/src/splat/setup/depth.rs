//! Depth of a splat: at its centre, over the splat, and the band that counts as its surface (eq. 5.8, 5.9).

use super::axes::{EDGE_UNITS, Frame};
use crate::compiler::{Value, name};
use crate::splat::parts::division::recip;
use crate::units::values::{Uniforms, Values};
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::{Band, DepthPlane, EpsilonScale};
use pointcore_contract::{Fixed, Signedness};

/// Depths as the record holds them.
const DEPTH: Fixed = Fixed { width: DEPTH_BITS, fraction: DEPTH_BITS, signed: Signedness::Unsigned };

/// A splat and both planes.
#[derive(Clone, Copy)]
struct Planes {
    /// The uniform `depth_a`.
    base: Value,
    /// The origin is the centre, and lies between them.
    center_shown: Value,
    /// All of the splat lies beyond the near, and before the far plane.
    is_within: [Value; 2],
}

/// A splat's depth.
pub(super) struct Depth {
    pub zero: Value,
    one: Value,
    /// What depth changes with `u_z`.
    pub b: Value,
    pub center: Value,
    /// Some of the splat lies before the far plane.
    pub before_far: Value,
    /// What the part for near and far plane sees to.
    planes: Option<Planes>,
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
        let base = viewport.declare(|viewport| viewport.depth_a);
        let depth_b = viewport.declare(|viewport| viewport.depth_b);
        let b = depth_b * r;
        let center = base + b;
        let spread_middle = center + b * (q * f);
        let spread_half = b.abs() * (frame.sqrt(q) * f);
        let zero = frame.constant(0.0);
        let of_whole = |is: Value| frame.whole.map_or(is, |whole| whole & is);
        let beyond_near = of_whole(zero.le(spread_middle - spread_half)).named("beyond_near");
        let (mut at_center, mut half_at_center) = (center, b.abs().min(one));
        let mut before_far = center.le(one);
        let mut planes = None;
        if let Some(eye) = frame.origin.eye {
            at_center = eye.centered.mux(center, zero);
            half_at_center = eye.centered.mux(half_at_center, one);
            let center_before_far = before_far & !eye.turned;
            let nearest = frame.exponents().shrunk((one - base) * eye.low(2), EDGE_UNITS);
            before_far = center_before_far | depth_b.le(nearest);
            let all_before_far = of_whole((spread_middle + spread_half).le(one)).named("all_before_far");
            planes = Some(Planes {
                base,
                center_shown: eye.centered & center_before_far,
                is_within: [beyond_near, all_before_far],
            });
        }
        let middle = beyond_near.mux(spread_middle, at_center);
        let half = beyond_near.mux(spread_half, half_at_center);
        let uniforms = Uniforms::<EpsilonScale>::new(frame.program, frame.config, frame.config.geometry);
        let epsilon = half * uniforms.declare(|epsilon| epsilon.scale) + uniforms.declare(|epsilon| epsilon.bias);
        name!(in "depth"; b, center, middle, half);
        name!(spread_middle, spread_half, epsilon, before_far);
        let center = frame.origin.eye.map_or(center, |eye| eye.turned.mux(base, center));
        Self {
            zero,
            one,
            b,
            center,
            before_far,
            planes,
            spread: [spread_middle, spread_half],
            beyond_near,
            middle,
            epsilon,
        }
    }

    /// `D` at near and far plane, where depths are 0 and 1, and whether no sample lies beyond.
    pub fn limits(&self, frame: &Frame, delta: Value) -> Option<[(Value, Value); 2]> {
        let planes = self.planes?;
        let by_depth = delta * recip(frame.config.division, self.b);
        let near = by_depth * frame.exponents().negated(planes.base);
        let far = by_depth * (self.one - planes.base);
        Some([(planes.is_within[0], near), (planes.is_within[1], far)])
    }

    /// Whether the origin is a centre between near and far plane, where that is a question.
    pub fn center_shown(&self) -> Option<Value> {
        self.planes.map(|planes| planes.center_shown)
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
