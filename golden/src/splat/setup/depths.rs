//! Depth of a splat: at its centre, over the splat, the band that counts as its surface (eqs. 5.8, 5.9), and where it meets near and far
//! plane.

use super::super::parts::division::{recip, sqrt};
use super::super::uniforms::SetupUniforms;
use super::Slant;
use crate::number::Number;
use pointcore_contract::splat::Division;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::Band;

/// Depths of a splat.
pub(super) struct Depths {
    zero: Number,
    one: Number,
    /// The uniform `depth_a`.
    base: Number,
    /// `b`: the depth is `depth_a + b·u_z/z`.
    pub scale: Number,
    /// At the origin, or where a splat's plane has no depth: at the vanishing point.
    pub center: Number,
    middle: Number,
    pub range: [Number; 2],
    pub epsilon: Number,
    /// The origin is the centre, and lies before the far plane.
    pub is_center_before_far: bool,
    /// All of the splat lies beyond the near plane, and before the far one.
    is_within: [bool; 2],
}

impl Depths {
    /// Of a splat whose origin's reciprocal depth is `r`, and which is its centre, beyond the near plane, or not.
    pub fn new(division: Division, r: Number, slant: &Slant, is_centered: bool, uniforms: &SetupUniforms) -> Self {
        let number = |bits| Number::new(slant.geometry, bits);
        let (zero, one) = (number(0), slant.one);
        let base = number(uniforms.viewport.depth_a);
        let scale = number(uniforms.viewport.depth_b) * r;
        let center = base + scale;
        let reach = sqrt(division, slant.squared);
        let range = slant.reciprocal.map(|f| (center + scale * (slant.squared * f), scale.abs() * (reach * f)));
        let beyond_near = range.filter(|(depth, half)| zero.is_at_most(*depth - *half));
        let before_far = range.filter(|(depth, half)| (*depth + *half).is_at_most(one));
        let at_center = if is_centered { (center, scale.abs().min(one)) } else { (zero, one) };
        let (middle, half) = beyond_near.unwrap_or(at_center);
        let range = beyond_near.map_or([zero, one], |(depth, half)| [depth - half, depth + half]);
        let epsilon = half * number(uniforms.epsilon.scale) + number(uniforms.epsilon.bias);
        let is_center_before_far = center.is_at_most(one) && !slant.is_turned;
        let center = if slant.is_turned { base } else { center };
        let is_within = [beyond_near.is_some(), before_far.is_some()];
        Self { zero, one, base, scale, center, middle, range, epsilon, is_center_before_far, is_within }
    }

    pub fn band(&self) -> Band {
        let fixed = |depth: Number| depth.max(self.zero).to_fixed(DEPTH_BITS, DEPTH_BITS) as u32;
        let Self { middle, epsilon, .. } = *self;
        Band { depth: fixed(middle), low: fixed(middle - epsilon), high: fixed(middle + epsilon) }
    }

    /// By the pixel over the plane, where `u_z/z = D/Δ`; level without a `Δ`.
    pub fn slope(&self, division: Division, delta: Option<Number>, m: [Number; 2]) -> [Number; 2] {
        delta.map_or([self.zero; 2], |delta| {
            let scale = self.scale * recip(division, delta);
            m.map(|m| scale * m)
        })
    }

    /// `D` at near and far plane, where depths are 0 and 1; none where no sample lies beyond.
    pub fn limits(&self, division: Division, delta: Number) -> [Option<Number>; 2] {
        let by_depth = delta * recip(division, self.scale);
        let limits = [by_depth * self.base.negated(), by_depth * (self.one - self.base)];
        [0, 1].map(|plane| (!self.is_within[plane]).then_some(limits[plane]))
    }
}
