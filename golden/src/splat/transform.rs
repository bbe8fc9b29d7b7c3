//! Transform unit: model-view transformation (thesis 5.4.1, table 5.1).
//!
//! A datapath of interval `transform_interval`, in the geometry format. Splats that do not reach beyond the near plane are dropped, without
//! the part for the eye plane all whose centre does not lie beyond it; where splats may move, none but those that are nowhere. Attributes become finite.

use super::attribute::Arithmetic;
use super::uniforms::TransformUniforms;
use crate::datapath::{Datapath, Token};
use crate::number::Number;
use crate::unit::Model;
use pointcore_contract::Format;
use pointcore_contract::splat::records::{Attributes, Motion, Splat};
pub use pointcore_contract::splat::units::transform::{In, Out};
use pointcore_contract::splat::{Config, Feature};

/// The transform unit.
#[derive(Clone, Debug)]
pub struct Transform {
    continuous: usize,
    geometry: Format,
    eye_plane: Feature,
    attribute: Arithmetic,
    has_motion: bool,
    datapath: Datapath<Splat>,
}

impl Transform {
    /// The unit with a pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        Self {
            continuous: config.continuous as usize,
            geometry: config.geometry,
            eye_plane: config.eye_plane,
            attribute: Arithmetic(config.attribute),
            has_motion: config.has_motion(),
            datapath: Datapath::new(latency, config.transform_interval),
        }
    }

    /// The splat in camera space; `None` if it does not reach beyond the near plane.
    #[must_use]
    pub fn transform(&self, splat: &Splat, uniforms: &TransformUniforms) -> Option<Splat> {
        if splat.end {
            return Some(Splat { end: true, ..Splat::default() });
        }
        let number = |bits| Number::new(self.geometry, bits);
        let matrix = uniforms.model_view.rows.map(|row| row.map(number));
        let rotate = |[x, y, z]: [Number; 3]| matrix.map(|m| m[0] * x + m[1] * y + m[2] * z);
        let rotated = rotate(splat.center.map(number));
        let center = [0, 1, 2].map(|i| rotated[i] + matrix[i][3]);
        let [a1, a2] = splat.tangents.map(|tangent| rotate(tangent.map(number)));

        let turned = |Motion { way, part }| Motion { way: rotate(way.map(number)).map(Number::bits), part };

        let near = number(uniforms.near_plane);
        // More than both tangents together bring it forward, and exact: none is dropped for a rounding.
        let reach = a1[2].abs().max(a2[2].abs()).raised(1);
        let reaches_beyond = self.eye_plane.is_on() && near.is_below(center[2] + reach);
        // Of one that moves, setup knows when it is seen.
        let may_come = self.has_motion && center[2].is_at_most(near);
        (near.is_below(center[2]) || reaches_beyond || may_come).then(|| Splat {
            center: center.map(Number::bits),
            tangents: [a1, a2].map(|tangent| tangent.map(Number::bits)),
            motion: if self.has_motion { turned(splat.motion) } else { Motion::default() },
            attributes: self.finite(splat.attributes),
            end: false,
        })
    }

    /// Attributes as numbers, of which every later sum is one.
    fn finite(&self, mut attributes: Attributes) -> Attributes {
        for bits in &mut attributes[..self.continuous] {
            *bits = self.attribute.finite(*bits);
        }
        attributes
    }
}

impl Model for Transform {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.datapath.in_ready(), out: self.datapath.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let accepted = inputs.input.as_ref().filter(|_| self.datapath.in_ready());
        let uniforms = TransformUniforms { model_view: inputs.model_view, near_plane: inputs.near_plane };
        let accepted = accepted.map(|splat| Token::from(self.transform(splat, &uniforms)));
        self.datapath.step(accepted, inputs.out_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::records::ModelView;
    use pointcore_contract::splat::{AttributeFormat, Fraction};

    #[test]
    fn moves_centers_and_rotates_tangents() {
        let bits = f32::to_bits;
        let unit = Transform::new(&Config::default(), 1);
        // A quarter turn about z and 3 along it.
        let model_view = [[0.0, -1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 3.0]].map(|row| row.map(bits));
        let uniforms = TransformUniforms { model_view: ModelView { rows: model_view }, near_plane: bits(1.0) };
        let tangents = [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]].map(|tangent| tangent.map(bits));
        let splat = |z: f32| Splat { center: [bits(1.0), bits(2.0), bits(z)], tangents, ..Splat::default() };
        let moved = unit.transform(&splat(5.0), &uniforms).expect("it lies beyond the near plane");
        assert_eq!(moved.center.map(f32::from_bits), [-2.0, 1.0, 8.0]);
        assert_eq!(moved.tangents.map(|tangent| tangent.map(f32::from_bits)), [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        assert_eq!(unit.transform(&splat(-2.0), &uniforms), None, "at the near plane");
        let leaning = |z: f32| Splat { tangents: [tangents[0], [1.0, 0.0, 3.0].map(bits)], ..splat(z) };
        let (is_on, is_off) = (unit, Transform::new(&Config { eye_plane: Feature::Off, ..Config::default() }, 1));
        for (z, reaches) in [(-7.9, true), (-8.0, false)] {
            assert_eq!(is_on.transform(&leaning(z), &uniforms).is_some(), reaches, "twice its reach is 6: {z}");
            assert_eq!(is_off.transform(&leaning(z), &uniforms), None);
        }
        let unit = is_on;
        assert_eq!(unit.transform(&splat(f32::NAN), &uniforms), None, "is nowhere");
    }

    #[test]
    fn attributes_become_finite() {
        let unit = Transform::new(&Config { continuous: 6, cardinal: 1, ..Config::default() }, 1);
        let attributes = |values: [u32; 7]| std::array::from_fn(|i| values.get(i).copied().unwrap_or(0));
        let given = attributes([0x7c00, 0xfc00, 0x7e00, 0xfc01, 0xfbff, 0x8001, 0x7c00]);
        let passed = attributes([0x7bff, 0xfbff, 0, 0, 0xfbff, 0x8001, 0x7c00]);
        assert_eq!(unit.finite(given), passed, "a cardinal one is no number");
        let attribute = AttributeFormat::Fixed(Fraction::Sixteen);
        let fixed = Transform::new(&Config { continuous: 6, cardinal: 1, attribute, ..Config::default() }, 1);
        assert_eq!(fixed.finite(given), given, "every fraction is finite");
    }
}
