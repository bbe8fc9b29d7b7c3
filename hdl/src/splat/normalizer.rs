//! Normalization (thesis eq. 5.13); golden twin: `pointcore_golden::splat::normalizer`.

use super::parts::division::recip;
use crate::compiler::{CompileError, Datapath, Options, Program, Type, Value, name};
use crate::units::datapath;
use crate::units::values::Terms;
use pointcore_contract::splat::config::{DEPTH_BITS, WEIGHT_BITS};
use pointcore_contract::splat::records::{FinishedPixel, Fragment, LOCAL_BITS, PlacedPixel};
use pointcore_contract::splat::{AttributeFormat, Config, Fraction, units};
use pointcore_contract::{Fixed, Format};

/// Divides a pixel's sums by its weight and states its place in the image.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("splat_normalizer", "A finished pixel's sums divided by its weight.");
    let FinishedPixel { end, placed } = FinishedPixel::inputs(&program, config);
    let PlacedPixel { tile, pixel, value: sums } = placed;
    let scale = recip(config.division, sums.weight.to_float(config.geometry, WEIGHT_BITS));
    let depth = sums.depth.to_float(config.geometry, WEIGHT_BITS + DEPTH_BITS) * scale;
    name!(scale);

    let column_bits = config.tile_column_bits();
    let column = tile.bits(column_bits - 1, 0).cat(pixel.bits(LOCAL_BITS - 1, 0));
    let row = tile.bits(config.tile_bits() - 1, column_bits).cat(pixel.bits(2 * LOCAL_BITS - 1, LOCAL_BITS));

    let normalized = |sum: Value| match config.attribute {
        AttributeFormat::Float(format) => (sum.as_float(format).convert(config.geometry) * scale).convert(format),
        AttributeFormat::Fixed(fraction) => divided(&program, config.geometry, fraction, sum, scale),
    };
    let mut attributes = sums.attributes;
    let continuous = &mut attributes[..config.continuous as usize];
    continuous.iter_mut().for_each(|attribute| *attribute = normalized(*attribute));
    Fragment { end, column, row, depth, attributes }.outputs(&program, config);
    datapath::unit(&units::normalizer::UNIT, config, &program, options)
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
