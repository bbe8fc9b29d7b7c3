//! What the accumulator makes of a pixel and a sample: depth test, sums, and the choice among them (eq. 5.8 to 5.12).

use pointcore_contract::Format;
use pointcore_contract::splat::config::WEIGHT_SUM_BITS;
use pointcore_contract::splat::{AttributeFormat, Config, records};

use crate::float::{Operator, add};
use crate::splat::depth_test;
use crate::units::records::Record;
use rtl::{Expr, Module, bit, cat, lit};

/// Cycles in which pixels are read and a sample's slot is chosen.
const CHOICE: u32 = 2;

/// A value from stage 3 as it is in stage `3 + count`.
fn delay(m: &mut Module, name: &str, value: Expr, count: u32) -> Expr {
    (0..count).fold(value, |value, index| {
        let register = m.reg(&format!("{name}_{}", index + 4), value.width());
        m.next(register, value);
        register.expr()
    })
}

/// A sum as it is, or the largest number of its sign where it overflowed. What chooses is the exponent alone, and the choice merges
/// with the one that follows it into a look-up table a bit.
fn saturated(m: &mut Module, name: &str, format: Format, sum: Expr) -> Expr {
    let (top, mantissa) = (format.width() - 1, format.mantissa);
    let exponent = sum.bits(top - 1, mantissa);
    let overflows = m.wire(&format!("overflow_of_{name}"), exponent.all());
    let largest = lit(top, u128::from(format.infinity() - 1));
    cat([sum.bit(top), overflows.mux(largest, sum.trunc(top))])
}

/// How a contribution comes to a stored sum of attributes.
enum Adder {
    /// By an operator of so many stages, and a choice behind it.
    Float { format: Format, operator: Operator },
    /// As integers.
    Fixed,
}

impl Adder {
    fn new(attribute: AttributeFormat, cycles: u32) -> Self {
        match attribute {
            AttributeFormat::Float(format) => Self::Float { format, operator: add::module(format, cycles) },
            AttributeFormat::Fixed(_) => Self::Fixed,
        }
    }

    /// The sum of what is there in stage 3, as it is in stage `3 + cycles`.
    fn sum(&self, m: &mut Module, name: &str, [stored, contribution]: [Expr; 2], cycles: u32) -> Expr {
        let (sum, cycles) = match self {
            Self::Float { format, operator } => {
                let add = m.instance(&format!("add_{name}"), operator.module.clone());
                m.connect(add, "enable", bit(true));
                m.connect(add, "a", stored);
                m.connect(add, "b", contribution);
                let sum = m.out(add, "y");
                (saturated(m, name, *format, sum), cycles - operator.latency)
            }
            Self::Fixed => (stored + contribution.sext(stored.width()), cycles),
        };
        delay(m, &format!("sum_of_{name}"), sum, cycles)
    }
}

/// The pixel that a sample leaves behind, in the last stage.
pub(super) struct Blend {
    /// The sample changes the pixel.
    pub writes: Expr,
    /// Its new value.
    pub pixel: Record,
}

/// Compares and adds: `sample` and `stored` are those of stage 3.
pub(super) fn blend(m: &mut Module, config: &Config, sample: &Record, stored: &Record) -> Blend {
    let cycles = config.accumulate_stages - CHOICE;
    let test = m.instance("depth_test", depth_test::module(config));
    m.connect(test, "weight", stored.get("weight"));
    m.connect(test, "depth", stored.get("depth"));
    for name in ["depth_low", "depth_high"] {
        m.connect(test, name, sample.get(name));
    }
    let [fail, pass] = ["fail", "pass"].map(|name| {
        let outcome = m.out(test, name);
        delay(m, &format!("late_{name}"), outcome, cycles - depth_test::LATENCY)
    });

    let weight_bits = WEIGHT_SUM_BITS;
    let weight = sample.get("weight");
    let weight_sum = stored.get("weight").add_carry(weight.zext(weight_bits));
    let weight_sum = delay(m, "weight_sum", weight_sum, cycles);
    let late_weight = delay(m, "weight", weight, cycles);
    let weighted_depth = sample.get("weighted_depth");
    let depth_sum = stored.get("depth") + weighted_depth.zext(stored.get("depth").width());
    let depth_sum = delay(m, "depth_sum", depth_sum, cycles);
    let late_depth = delay(m, "depth", weighted_depth, cycles);
    let stronger = match config.cardinal {
        0 => pass,
        _ => {
            let stronger = delay(m, "stronger", stored.get("peak").lt(weight), cycles);
            m.wire("selected", pass | stronger)
        }
    };

    let adder = Adder::new(config.attribute, cycles);
    let pixel = Record::new(&records::pixel(config), |name| match name {
        "weight" => pass.mux(late_weight.zext(weight_bits), weight_sum.trunc(weight_bits)),
        "depth" => pass.mux(late_depth.zext(depth_sum.width()), depth_sum),
        "peak" => {
            let late_peak = delay(m, "peak", stored.get("peak"), cycles);
            stronger.mux(late_weight, late_peak)
        }
        attribute => {
            let late = delay(m, attribute, sample.get(attribute), cycles);
            if attribute.starts_with("cardinal") {
                let late_stored = delay(m, &format!("stored_{attribute}"), stored.get(attribute), cycles);
                return stronger.mux(late, late_stored);
            }
            let operands = [stored.get(attribute), sample.get(attribute)];
            let sum = adder.sum(m, attribute, operands, cycles);
            pass.mux(late.sext(sum.width()), sum)
        }
    });
    let overflows = weight_sum.msb();
    Blend { writes: !fail & (pass | !overflows), pixel }
}
