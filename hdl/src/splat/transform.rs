//! Transform (thesis table 5.1, top); golden twin: `pointcore_golden::splat::transform`.

use crate::compiler::{CompileError, Datapath, Options, Program, Value, compile};
use crate::units::datapath::{Inputs, dot, uniform};
use pointcore_contract::Format;
use pointcore_contract::splat::{AttributeFormat, Config, ports::UNIFORMS, records};

/// World space to camera space; drops splats whose centre is not beyond the near plane, and makes attributes finite.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let format = config.geometry;
    let program = Program::new("splat_transform", "World space to camera space.");
    let record = records::splat(config);
    let splat = Inputs::new(&program, &record);
    let matrix: [_; 12] = std::array::from_fn(|i| uniform(&program, format, UNIFORMS[i]));
    let near = uniform(&program, format, "near_plane");
    let rows: [[_; 3]; 3] = std::array::from_fn(|row| std::array::from_fn(|column| matrix[4 * row + column]));

    let vector = |name: &str| ["x", "y", "z"].map(|axis| splat.float(format, &format!("{name}_{axis}")));
    let rotate = |name: &str| {
        let vector = vector(name);
        rows.each_ref().map(|row| dot(row, &vector))
    };
    let turned = rotate("center");
    let center: [_; 3] = std::array::from_fn(|i| turned[i] + matrix[4 * i + 3]);
    let (tangent1, tangent2) = (rotate("tangent1"), rotate("tangent2"));

    program.keep_if(splat.bits("end") | near.lt(center[2]));

    let [center_x, center_y, center_z] = center;
    let [tangent1_x, tangent1_y, tangent1_z] = tangent1;
    let [tangent2_x, tangent2_y, tangent2_z] = tangent2;
    let mut computed = vec![
        ("center_x", center_x),
        ("center_y", center_y),
        ("center_z", center_z),
        ("tangent1_x", tangent1_x),
        ("tangent1_y", tangent1_y),
        ("tangent1_z", tangent1_z),
        ("tangent2_x", tangent2_x),
        ("tangent2_y", tangent2_y),
        ("tangent2_z", tangent2_z),
    ];
    let names: Vec<String> = (0..config.continuous).map(|i| format!("attribute_{i}")).collect();
    if let AttributeFormat::Float(format) = config.attribute {
        computed.extend(names.iter().map(|name| (name.as_str(), finite(&program, format, splat.bits(name)))));
    }
    splat.output(&program, &record, &computed);
    compile(&program, &options.with_interval(config.transform_interval))
}

/// A number as it is, the largest of its sign instead of an infinity, zero instead of a NaN.
fn finite(program: &Program, format: Format, number: Value) -> Value {
    let [sign, exponent, fraction] = [
        number.bits(format.width() - 1, format.width() - 1),
        number.bits(format.width() - 2, format.mantissa),
        number.bits(format.mantissa - 1, 0),
    ];
    let special = exponent.eq(program.lit(format.exponent, format.exponent_max()));
    let infinite = fraction.eq(program.lit(format.mantissa, 0));
    let largest = sign.cat(program.lit(format.width() - 1, format.infinity() - 1));
    let replacement = infinite.mux(largest, program.lit(format.width(), 0));
    special.mux(replacement, number)
}
