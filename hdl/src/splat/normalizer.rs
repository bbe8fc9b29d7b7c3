//! Normalization (thesis eq. 5.13); golden twin: `pointcore_golden::splat::normalizer`.

use super::parts::division::recip;
use crate::compiler::{CompileError, Datapath, Options, Program, Type, Value, name};
use crate::units::datapath;
use crate::units::values::{Terms, Uniforms, Values};
use pointcore_contract::splat::config::{DEPTH_BITS, WEIGHT_BITS};
use pointcore_contract::splat::motion::{BIN_PARTS, SHUTTER, TIME_BITS};
use pointcore_contract::splat::records::{
    ATTRIBUTES, Bin, FinishedPixel, Fragment, LOCAL_BITS, PlacedPixel, Seen, Shutter,
};
use pointcore_contract::splat::{AttributeFormat, Config, Fraction, units};
use pointcore_contract::{Fixed, Format};

/// Cycles that a bin takes, in which its nearest surface and the rest are divided.
const SURFACES_A_BIN: u32 = 2;

/// Divides a pixel's sums by its weight and states its place in the image.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("splat_normalizer", "A finished pixel's sums divided by its weight.");
    let FinishedPixel { end, placed } = FinishedPixel::inputs(&program, config);
    let PlacedPixel { tile, pixel, value: sums } = placed;
    let (column_bits, bin_bits) = (config.tile_column_bits(), config.bin_bits());
    let column = tile.bits(column_bits - 1, bin_bits).cat(pixel.bits(LOCAL_BITS - 1, 0));
    let row = tile.bits(config.tile_bits() - 1, column_bits).cat(pixel.bits(2 * LOCAL_BITS - 1, LOCAL_BITS));
    let (depth, attributes) = surface(config, &program, sums.weight, sums.depth, sums.attributes);
    let seen = if config.has_motion() { seen(config, &program, tile, &sums.bin) } else { Seen::default() };
    Fragment { end, column, row, depth, attributes, seen }.outputs(&program, config);
    let interval = if config.has_motion() { SURFACES_A_BIN } else { 1 };
    datapath::unit(&units::normalizer::UNIT, config, &program, &options.with_interval(interval))
}

/// Depth and attributes of sums of this weight.
fn surface(
    config: &Config,
    program: &Program,
    weight: Value,
    depth: Value,
    mut attributes: [Value; ATTRIBUTES],
) -> (Value, [Value; ATTRIBUTES]) {
    let scale = recip(config.division, weight.to_float(config.geometry, WEIGHT_BITS));
    let depth = depth.to_float(config.geometry, WEIGHT_BITS + DEPTH_BITS) * scale;
    name!(scale);
    let normalized = |sum: Value| match config.attribute {
        AttributeFormat::Float(format) => (sum.as_float(format).convert(config.geometry) * scale).convert(format),
        AttributeFormat::Fixed(fraction) => divided(program, config.geometry, fraction, sum, scale),
    };
    let continuous = &mut attributes[..config.continuous as usize];
    continuous.iter_mut().for_each(|attribute| *attribute = normalized(*attribute));
    (depth, attributes)
}

/// For how long a bin sees its nearest surface, for how long the rest besides, and the rest itself.
fn seen(config: &Config, program: &Program, tile: Value, bin: &Bin<Values>) -> Seen<Values> {
    let (bits, time_bits) = (config.bin_bits(), config.bin_time_bits());
    let shutter = Uniforms::<Shutter>::of(program, config, Type::Unsigned(SHUTTER.width));
    let counts: Vec<_> =
        (0..config.time_bins as usize).map(|bin| shutter.declare(|shutter| shutter.weight[bin])).collect();
    let counts = datapath::pick(tile, counts);
    let length = program.lit(time_bits + 1, 1 << (time_bits - 1));
    let less = |from: Value, what: Value| from.lt(what).mux(program.lit(time_bits + 1, 0), from - what);
    let part_bits = time_bits - 1 - BIN_PARTS.ilog2();
    // How many parts of the bin a span touches without anything being seen there.
    let missed = |[early, late]: [Value; 2], parts: Value| {
        let exceeds = |time: Value, parts: u32| program.lit(time_bits, u64::from(parts) << part_bits).lt(time);
        let missed = (0..BIN_PARTS).map(|part| {
            let is_touched = exceeds(late, part) & exceeds(early, BIN_PARTS - 1 - part);
            (is_touched & !parts.bits(part, part)).zext(BIN_PARTS.ilog2() + 1)
        });
        sum(&missed.collect::<Vec<_>>())
    };
    let time = |span: [Value; 2], parts: Value| {
        let [early, late] = span.map(|time| time.zext(time_bits + 1));
        less(early + late, length + (missed(span, parts).zext(time_bits + 1) << part_bits))
    };
    let (nearest, any) = (time(bin.nearest, bin.nearest_parts), time(bin.any, bin.any_parts));
    let largest = program.lit(time_bits + 1 + SHUTTER.width, (1 << TIME_BITS) - 1);
    let share = |time: Value| ((time * counts) >> SHUTTER.fraction).min(largest).bits(TIME_BITS - 1, 0);
    let (depth, attributes) = surface(config, program, bin.weight, bin.depth, bin.attributes);
    let number = if bits > 0 { tile.bits(bits - 1, 0) } else { Value::default() };
    Seen { bin: number, share: share(nearest), rest_share: share(less(any, nearest)), depth, attributes }
}

/// The sum of several values of a width, as a tree.
fn sum(values: &[Value]) -> Value {
    match values {
        [value] => *value,
        _ => {
            let (left, right) = values.split_at(values.len() / 2);
            sum(left) + sum(right)
        }
    }
}

/// A fixed-point sum times `scale`, rounded to the nearest fraction: truncated with a bit more, which then rounds away from zero.
fn divided(program: &Program, geometry: Format, fraction: Fraction, sum: Value, scale: Value) -> Value {
    let Fixed { width, fraction: places, signed } = fraction.number();
    let sum = sum.reinterpret(Type::Signed(fraction.sum().width));
    let quotient = sum.to_float(geometry, fraction.sum().fraction) * scale;
    let halves = quotient.to_fixed(Fixed { width: width + 1, fraction: places + 1, signed });
    let wide = Type::Signed(width + 2);
    let is_positive = (!halves.bits(width, width)).zext(width + 2).reinterpret(wide);
    let nearest = (halves.resize(width + 2) + is_positive) >> 1;
    nearest.min(program.constant(wide, (1 << places) - 1)).resize(width)
}
