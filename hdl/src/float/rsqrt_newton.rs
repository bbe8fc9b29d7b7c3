//! Reciprocal square root by table and Newton steps `y ← y · (3 − m·y²)/2`: no digit recurrence, and not always correctly
//! rounded.

use super::parts::delay;
use super::parts::newton::{
    INDEX_BITS, SEED_FRACTION, finish, floor, fraction_bits, iterate_fraction, steps, top_fraction,
};
use super::parts::operand::{Operand, exponent_width, normalize, precision};
use super::parts::pipe::{self, Operator, Pipe};
use super::parts::product::product;
use super::parts::round::Underflow;
use super::rsqrt::rsqrt_special;
use super::sqrt::even_exponent;
use pointcore_contract::Format;
use rtl::{Expr, cat, lit};

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(|pipe| root(pipe, format))
}

/// `1/√c` for the middles `c` of 64 intervals of [1, 2), then of 64 of [2, 4).
fn seeds() -> Vec<u128> {
    let halves = 1 << (INDEX_BITS - 1);
    let one = f64::from(1 << SEED_FRACTION);
    let seed = |index: u32| {
        let (parity, interval) = (index / halves, index % halves);
        let middle = (1.0 + f64::from(2 * interval + 1) / f64::from(2 * halves)) * f64::from(1 + parity);
        (one / middle.sqrt()).round() as u128
    };
    (0..2 * halves).map(seed).collect()
}

/// Module `float_rsqrt_newton`.
#[must_use]
pub fn module(format: Format, stages: u32) -> Operator {
    let summary = "Floating-point reciprocal square root by table and Newton steps.";
    pipe::operator("float_rsqrt_newton", summary, stages, |pipe| root(pipe, format))
}

fn root(pipe: &mut Pipe, format: Format) -> Expr {
    pipe.module.variant("format", format);
    let (p, fraction) = (precision(format), fraction_bits(format));
    let a = Operand::input(pipe, format, "a");
    let special = rsqrt_special(&a).carry(pipe);
    let [a] = normalize(pipe, format, [&a]);

    pipe.takes(delay::LEVEL);
    let (m, half) = even_exponent(format, &a);
    let exponent = lit(exponent_width(format), 2 * format.bias() as u128) - half;
    let mut exponent = pipe.carry("exponent", exponent);
    let mut m = pipe.carry("m", m);
    let odd = !a.exponent.bit(0);
    let [index] = pipe.cut([("index", cat([odd, top_fraction(a.significand, INDEX_BITS - 1)]))]);
    pipe.takes(3 * delay::LEVEL);
    let seed = pipe.module.lookup("seed", &seeds(), SEED_FRACTION + 1, index);
    let [mut y] = pipe.cut([("y", seed)]);
    for step in 0..steps(format) {
        let y_fraction = iterate_fraction(format, step);
        let mut iterate = pipe.carry("iterate", y);
        let square = product(pipe, y, y);
        let [square] = pipe.cut([("square", floor(square, 2 * y_fraction, fraction, fraction + 1))]);
        let current_m = pipe.arrive(&mut m);
        let s = product(pipe, current_m, square);
        let [s] = pipe.cut([("s", floor(s, p - 1 + fraction, fraction, fraction + 1))]);
        pipe.takes(delay::adder(fraction + 2));
        let [u] = pipe.cut([("u", (lit(fraction + 2, 3 << fraction) - s.zext(fraction + 2)))]);
        let previous = pipe.arrive(&mut iterate);
        let yu = product(pipe, previous, u);
        [y] = pipe.cut([("y", floor(yu, y_fraction + fraction + 1, fraction, fraction + 1))]);
    }
    let exponent = pipe.arrive(&mut exponent);
    finish(pipe, format, Underflow::Impossible, special, exponent, y)
}
