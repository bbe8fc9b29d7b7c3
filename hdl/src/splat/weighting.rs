//! A sample's contributions (thesis eq. 5.10); golden twin: `pointcore_golden::splat::weighting`.

use crate::compiler::{CompileError, Datapath, Options, Program, Type, compile};
use crate::units::datapath::Inputs;
use pointcore_contract::splat::config::WEIGHT_BITS;
use pointcore_contract::splat::{AttributeFormat, Config, records};

/// Multiplies depth and continuous attributes by the kernel weight.
///
/// # Errors
/// What the compiler rejects.
pub fn datapath(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = Program::new("splat_weighting", "Weighted depth and attributes of a sample.");
    let sample = Inputs::new(&program, &records::sample(config));
    let weight = sample.bits("weight");
    let factor = match config.attribute {
        AttributeFormat::Float(format) => weight.to_float(format, WEIGHT_BITS),
        // A bit more: its sign. The product then has a bit that is its sign's once more.
        AttributeFormat::Fixed(_) => weight.zext(WEIGHT_BITS + 1).reinterpret(Type::Signed(WEIGHT_BITS + 1)),
    };
    let contribution = |name| match config.attribute {
        AttributeFormat::Float(format) => factor * sample.float(format, name),
        AttributeFormat::Fixed(fraction) => {
            let product = factor * sample.bits(name).reinterpret(Type::Signed(fraction.width()));
            product.resize(fraction.contribution().width)
        }
    };
    let names: Vec<String> = (0..config.continuous).map(|i| format!("attribute_{i}")).collect();
    let mut computed = vec![("weighted_depth", weight * sample.bits("depth"))];
    computed.extend(names.iter().map(|name| (name.as_str(), contribution(name))));
    sample.output(&program, &records::weighted_sample(config), &computed);
    compile(&program, options)
}
