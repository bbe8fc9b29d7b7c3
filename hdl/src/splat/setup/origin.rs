//! The origin of a footprint: a splat's projected centre, or the vanishing point of a tangent; golden twin:
//! `pointcore_golden::splat::setup::origin`.

use super::exponent::Exponents;
use super::scaling;
use crate::compiler::{Program, Type, Value, name};
use crate::units::values::Values;
use pointcore_contract::Format;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::Splat;
use pointcore_contract::splat::units::setup::PORTS;

/// A centre that lies this many powers of two farther aside than away is no origin.
const fn aside(format: Format) -> u64 {
    if format.mantissa < Format::F32.mantissa { 4 } else { 10 }
}

/// What is projected as centre and tangents.
#[derive(Clone, Copy)]
pub(super) struct Origin {
    pub center: [Value; 3],
    pub tangents: [[Value; 3]; 2],
    /// What the part for the eye plane knows of the splat.
    pub eye: Option<Eye>,
}

/// How a splat lies to near and eye plane.
#[derive(Clone, Copy)]
pub(super) struct Eye {
    center: [Value; 3],
    /// Twice the longer of both tangents along each axis.
    reach: [Value; 3],
    /// Some of it may lie beyond the near plane.
    pub reaches_near: Value,
    /// The origin is the centre, and lies beyond the near plane.
    pub centered: Value,
    /// A tangent is in the centre's place.
    pub turned: Value,
    /// It is the second one.
    pub swapped: Value,
    /// Places by which tangents are shorter than they should be.
    pub lowered: Value,
}

impl Eye {
    pub fn high(&self, axis: usize) -> Value {
        self.center[axis] + self.reach[axis]
    }

    pub fn low(&self, axis: usize) -> Value {
        self.center[axis] - self.reach[axis]
    }
}

fn choose(condition: Value, when_true: [Value; 3], when_false: [Value; 3]) -> [Value; 3] {
    std::array::from_fn(|i| condition.mux(when_true[i], when_false[i]))
}

impl Origin {
    pub fn new(config: &Config, program: &Program, splat: &Splat<Values>) -> Self {
        let format = config.geometry;
        let vector = |vector: [Value; 3]| vector.map(|part| part.as_float(format));
        let (center, tangents) = (vector(splat.center), splat.tangents.map(vector));
        if !config.eye_plane.is_on() {
            return Self { center, tangents, eye: None };
        }
        let exponents = Exponents { program, format };
        let near = program.uniform(PORTS.near_plane.name, Type::Float(format));
        let [first, second] = tangents;
        let farther: [Value; 3] = std::array::from_fn(|i| first[i].abs().max(second[i].abs()));
        let reach = farther.map(|part| exponents.raise_far(part, exponents.lit(1), exponents.lit(0)));

        let beyond_near = near.lt(center[2]);
        let swapped = first[2].abs().lt(second[2].abs());
        let sideways = exponents.of(center[0]).max(exponents.of(center[1]));
        let is_aside = (exponents.of(center[2]) + exponents.lit(aside(format))).lt(sideways);
        let turned = center[2].lt(farther[2]) & (!beyond_near | is_aside);
        let (leading, other) = (choose(swapped, second, first), choose(swapped, first, second));
        let origin = choose(turned, leading, center);
        let tangents = [choose(turned, other, first), choose(turned, center, second)];

        let lowered = scaling::places(&exponents, origin[2], &tangents);
        let none = exponents.lit(0);
        let tangents = tangents.map(|tangent| tangent.map(|part| exponents.raise(part, none, lowered)));
        let centered = beyond_near & !turned;
        let reaches_near = beyond_near | near.lt(center[2] + reach[2]);
        name!(beyond_near, swapped, turned, lowered, reaches_near);
        let eye = Eye { center, reach, reaches_near, centered, turned, swapped, lowered };
        Self { center: origin, tangents, eye: Some(eye) }
    }
}
