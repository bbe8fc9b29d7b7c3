//! Reciprocal by table and Newton steps `y ← y · (2 − m·y)`: no divider, and not always correctly rounded.

use super::div::recip_special;
use super::parts::delay;
use super::parts::newton::{
    INDEX_BITS, SEED_FRACTION, finish, floor, fraction_bits, iterate_fraction, steps, top_fraction,
};
use super::parts::operand::{Operand, exponent_width, normalize, precision};
use super::parts::pipe::{self, Operator, Pipe};
use super::parts::product::product;
use super::parts::round::Underflow;
use pointcore_contract::Format;
use rtl::{Expr, lit};

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(|pipe| reciprocal(pipe, format))
}

/// `1 / (1 + (2i + 1)/256)`, the middle of interval `i` of 128.
fn seeds() -> Vec<u128> {
    let one = f64::from(1 << SEED_FRACTION);
    (0..1 << INDEX_BITS).map(|index: u32| (one / (1.0 + f64::from(2 * index + 1) / 256.0)).round() as u128).collect()
}

/// Module `float_recip_newton`.
#[must_use]
pub fn module(format: Format, stages: u32) -> Operator {
    let summary = "Floating-point reciprocal by table and Newton steps.";
    pipe::operator("float_recip_newton", summary, stages, |pipe| reciprocal(pipe, format))
}

fn reciprocal(pipe: &mut Pipe, format: Format) -> Expr {
    pipe.module.variant("format", format);
    let (p, fraction) = (precision(format), fraction_bits(format));
    let a = Operand::input(pipe, format, "a");
    let special = recip_special(&a).carry(pipe);
    let [a] = normalize(pipe, format, [&a]);

    let exponent = lit(exponent_width(format), 2 * format.bias() as u128) - a.exponent;
    let mut exponent = pipe.carry("exponent", exponent);
    let mut m = pipe.carry("m", a.significand);
    let [index] = pipe.cut([("index", top_fraction(a.significand, INDEX_BITS))]);
    pipe.takes(3 * delay::LEVEL);
    let seed = pipe.module.lookup("seed", &seeds(), SEED_FRACTION + 1, index);
    let [mut y] = pipe.cut([("y", seed)]);
    for step in 0..steps(format) {
        let y_fraction = iterate_fraction(format, step);
        let mut iterate = pipe.carry("iterate", y);
        let current_m = pipe.arrive(&mut m);
        let my = product(pipe, current_m, y);
        let [my] = pipe.cut([("my", floor(my, p - 1 + y_fraction, fraction, fraction + 1))]);
        pipe.takes(delay::adder(fraction + 1));
        // Modulo 2^(F+1), where 2 is zero.
        let [e] = pipe.cut([("e", (lit(fraction + 1, 0) - my))]);
        let previous = pipe.arrive(&mut iterate);
        let ye = product(pipe, previous, e);
        [y] = pipe.cut([("y", floor(ye, y_fraction + fraction, fraction, fraction + 1))]);
    }
    let exponent = pipe.arrive(&mut exponent);
    finish(pipe, format, Underflow::Possible, special, exponent, y)
}
