//! A sample's contributions (thesis eq. 5.10); golden twin: `pointcore_golden::splat::weighting`.

use crate::compiler::{BLOCK_MEMORY_LEVELS, CompileError, Datapath, Options, Program, Type, Value, name};
use crate::units::datapath;
use crate::units::values::Terms;
use pointcore_contract::splat::config::WEIGHT_BITS;
use pointcore_contract::splat::records::{Band, Sample, WeightedSample};
use pointcore_contract::splat::{AttributeFormat, Config, units};

/// Multiplies depth and continuous attributes by the kernel weight.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("splat_weighting", "Weighted depth and attributes of a sample.");
    let Sample { place, band, time, mut attributes } = Sample::inputs(&program, config);
    let weight = place.weight;
    let factor = match config.attribute {
        AttributeFormat::Float(format) => weight.to_float(format, WEIGHT_BITS),
        // A bit more: its sign. The product then has a bit that is its sign's once more.
        AttributeFormat::Fixed(_) => weight.zext(WEIGHT_BITS + 1).reinterpret(Type::Signed(WEIGHT_BITS + 1)),
    };
    name!(factor);
    let contribution = |attribute: Value| match config.attribute {
        AttributeFormat::Float(format) => factor * attribute.as_float(format),
        AttributeFormat::Fixed(fraction) => {
            let product = factor * attribute.reinterpret(Type::Signed(fraction.width()));
            product.resize(fraction.contribution().width)
        }
    };
    let weighted_depth = weight * band.depth;
    let continuous = &mut attributes[..config.continuous as usize];
    continuous.iter_mut().for_each(|attribute| *attribute = contribution(*attribute));
    let Band { low: depth_low, high: depth_high, .. } = band;
    WeightedSample { place, weighted_depth, depth_low, depth_high, time, attributes }.outputs(&program, config);
    // The rasterizer shows what it has out of block memory.
    let options = Options { input_levels: BLOCK_MEMORY_LEVELS, ..options.clone() };
    datapath::unit(&units::weighting::UNIT, config, &program, &options)
}
