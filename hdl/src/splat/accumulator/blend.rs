//! What the accumulator makes of a pixel and a sample: depth test, sums, and the choice among them (eq. 5.8 to 5.12).

use pointcore_contract::Format;
use pointcore_contract::splat::config::{DEPTH_SUM_BITS, WEIGHT_SUM_BITS};
use pointcore_contract::splat::records::{Pixel, attribute_name};
use pointcore_contract::splat::units::depth_test::PORTS;
use pointcore_contract::splat::{AttributeFormat, Config};

use super::behind::{self, Outcome};
use super::sample::Contribution;
use crate::float::{Operator, add};
use crate::splat::depth_test;
use crate::units::operator::Placed;
use crate::units::ports::WordPort;
use crate::units::wires::Wires;
use rtl::{Expr, Module, bit, cat, lit};

/// Cycles in which pixels are read and a sample's slot is chosen.
pub(super) const CHOICE: u32 = 2;

/// A value from stage 3 as it is in stage `3 + count`.
pub(super) fn delay(m: &mut Module, name: &str, value: Expr, count: u32) -> Expr {
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
pub(super) enum Adder {
    /// By an operator of so many stages, and a choice behind it.
    Float { format: Format, operator: Operator },
    /// As integers.
    Fixed,
}

impl Adder {
    pub fn new(attribute: AttributeFormat, cycles: u32) -> Self {
        match attribute {
            AttributeFormat::Float(format) => Self::Float { format, operator: add::module(format, cycles) },
            AttributeFormat::Fixed(_) => Self::Fixed,
        }
    }

    /// The sum of what is there in stage 3, as it is in stage `3 + cycles`.
    pub fn sum(&self, m: &mut Module, name: &str, [stored, contribution]: [Expr; 2], cycles: u32) -> Expr {
        let (sum, cycles) = match self {
            Self::Float { format, operator } => {
                let add = Placed::new(m, &format!("add_{name}"), operator.module.clone());
                add.feed(m, bit(true), [stored, contribution]);
                let sum = add.result(m);
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
    pub pixel: Pixel<Wires>,
}

/// Whether the pixel hides the sample, and whether the sample hides the pixel.
fn compare(m: &mut Module, config: &Config, sample: &Contribution<Wires>, stored: &Pixel<Wires>) -> [Expr; 2] {
    let test = m.instance("depth_test", depth_test::module(config));
    PORTS.weight.feed_word(m, test, stored.weight);
    PORTS.depth.feed_word(m, test, stored.depth);
    PORTS.depth_low.feed_word(m, test, sample.depth_low);
    PORTS.depth_high.feed_word(m, test, sample.depth_high);
    [PORTS.fail, PORTS.pass].map(|port| {
        let outcome = port.word_of(m, test);
        delay(m, &format!("late_{}", port.name), outcome, config.accumulate_stages - CHOICE - depth_test::LATENCY)
    })
}

/// Compares and adds: `sample` and `stored` are those of stage 3.
pub(super) fn blend(m: &mut Module, config: &Config, sample: &Contribution<Wires>, stored: &Pixel<Wires>) -> Blend {
    let cycles = config.accumulate_stages - CHOICE;
    let [fail, pass] = compare(m, config, sample, stored);

    let weight_sum = stored.weight.add_carry(sample.weight.zext(WEIGHT_SUM_BITS));
    let weight_sum = delay(m, "weight_sum", weight_sum, cycles);
    let late_weight = delay(m, "weight", sample.weight, cycles);
    let depth_sum = stored.depth + sample.weighted_depth.zext(DEPTH_SUM_BITS);
    let depth_sum = delay(m, "depth_sum", depth_sum, cycles);
    let late_depth = delay(m, "depth", sample.weighted_depth, cycles);
    let mut pixel = Pixel {
        weight: pass.mux(late_weight.zext(WEIGHT_SUM_BITS), weight_sum.trunc(WEIGHT_SUM_BITS)),
        depth: pass.mux(late_depth.zext(DEPTH_SUM_BITS), depth_sum),
        ..Pixel::default()
    };

    // The cardinal attributes are those of the largest weight.
    let mut stronger = pass;
    if config.cardinal > 0 {
        let is_stronger = delay(m, "stronger", stored.peak.lt(sample.weight), cycles);
        stronger = m.wire("selected", pass | is_stronger);
        let late_peak = delay(m, "peak", stored.peak, cycles);
        pixel.peak = stronger.mux(late_weight, late_peak);
    }
    let adder = Adder::new(config.attribute, cycles);
    for place in 0..config.attributes() as usize {
        let name = attribute_name(config, place);
        let (contribution, stored) = (sample.attributes[place], stored.attributes[place]);
        let late = delay(m, &name, contribution, cycles);
        pixel.attributes[place] = if place < config.continuous as usize {
            let sum = adder.sum(m, &name, [stored, contribution], cycles);
            pass.mux(late.sext(sum.width()), sum)
        } else {
            let late_stored = delay(m, &format!("stored_{name}"), stored, cycles);
            stronger.mux(late, late_stored)
        };
    }
    let overflows = weight_sum.msb();
    if config.has_motion() {
        let pixel = behind::pixel(m, config, sample, stored, Outcome { fail, pass, blended: pixel });
        return Blend { writes: (fail | pass) | !overflows, pixel };
    }
    Blend { writes: !fail & (pass | !overflows), pixel }
}
