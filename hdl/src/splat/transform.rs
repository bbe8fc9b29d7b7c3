//! Transform (thesis table 5.1, top); golden twin: `pointcore_golden::splat::transform`.

use crate::compiler::{CompileError, Datapath, Options, Program, Type, Value, name};
use crate::units::datapath::{self, dot};
use crate::units::values::Terms;
use pointcore_contract::Format;
use pointcore_contract::splat::records::{ModelView, Motion, Splat};
use pointcore_contract::splat::units::{self, transform::PORTS};
use pointcore_contract::splat::{AttributeFormat, Config};
use std::array::from_fn;

/// World space to camera space; drops splats whose centre is not beyond the near plane, and makes attributes finite.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let format = config.geometry;
    let program = Program::new("splat_transform", "World space to camera space.");
    let splat = Splat::inputs(&program, config);
    let ModelView { rows } = ModelView::uniforms(&program, config, format);
    let near = program.uniform(PORTS.near_plane.name, Type::Float(format));

    let rotate = |vector: [Value; 3]| {
        let vector = vector.map(|component| component.as_float(format));
        rows.map(|[x, y, z, _]| dot(&[x, y, z], &vector))
    };
    let turned = rotate(splat.center);
    let center: [_; 3] = from_fn(|i| turned[i] + rows[i][3]);
    let tangents = splat.tangents.map(rotate);
    let [[v1_x, v1_y, v1_z], [v2_x, v2_y, v2_z]] = tangents;
    let [u_x, u_y, u_z] = center;
    name!(u_x, u_y, u_z, v1_x, v1_y, v1_z, v2_x, v2_y, v2_z);
    let visible = if config.has_motion() {
        // It may come from anywhere: setup knows when it is seen.
        is_number(&program, format, u_z) & is_number(&program, format, near)
    } else {
        let mut visible = near.lt(u_z);
        if config.eye_plane.is_on() {
            // Twice the longer one is more than both tangents together, and exact.
            let longer = v1_z.abs().max(v2_z.abs());
            visible = visible | near.lt(u_z + twice(&program, format, longer));
        }
        visible
    };
    program.keep_if(splat.end | visible);

    let mut attributes = splat.attributes;
    if let AttributeFormat::Float(format) = config.attribute {
        let continuous = &mut attributes[..config.continuous as usize];
        continuous.iter_mut().for_each(|attribute| *attribute = finite(&program, format, *attribute));
    }
    let motion = if config.has_motion() {
        Motion { way: rotate(splat.motion.way), part: splat.motion.part }
    } else {
        Motion::default()
    };
    Splat { end: splat.end, center, tangents, motion, attributes }.outputs(&program, config);
    datapath::unit(&units::transform::UNIT, config, &program, &options.with_interval(config.transform_interval))
}

/// The sign, the exponent and the fraction of a number.
fn parts(format: Format, number: Value) -> [Value; 3] {
    let Format { exponent, mantissa, .. } = format;
    let sign = exponent + mantissa;
    [number.bits(sign, sign), number.bits(sign - 1, mantissa), number.bits(mantissa - 1, 0)]
}

/// Whether it is a number, or infinite.
fn is_number(program: &Program, format: Format, number: Value) -> Value {
    let [_, exponent, fraction] = parts(format, number);
    !exponent.eq(program.lit(format.exponent, format.exponent_max())) | fraction.eq(program.lit(format.mantissa, 0))
}

/// Twice a magnitude, by its exponent: zero of a subnormal one.
fn twice(program: &Program, format: Format, magnitude: Value) -> Value {
    let (bits, mantissa) = (format.exponent, format.mantissa);
    let [_, exponent, fraction] = parts(format, magnitude);
    let is = |value: u64| exponent.eq(program.lit(bits, value));
    let largest = format.exponent_max();
    let raised = is(largest).mux(exponent, exponent + program.lit(bits, 1));
    let fraction = is(largest - 1).mux(program.lit(mantissa, 0), fraction);
    let double = program.lit(1, 0).cat(raised).cat(fraction);
    is(0).mux(program.lit(format.width(), 0), double).reinterpret(Type::Float(format))
}

/// A number as it is, the largest of its sign instead of an infinity, zero instead of a NaN.
fn finite(program: &Program, format: Format, number: Value) -> Value {
    let [sign, exponent, fraction] = parts(format, number);
    let special = exponent.eq(program.lit(format.exponent, format.exponent_max()));
    let infinite = fraction.eq(program.lit(format.mantissa, 0));
    let largest = sign.cat(program.lit(format.width() - 1, format.infinity() - 1));
    let replacement = infinite.mux(largest, program.lit(format.width(), 0));
    special.mux(replacement, number)
}
