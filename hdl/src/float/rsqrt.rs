//! Reciprocal square root, correctly rounded by digit recurrence.
//!
//! For `m` in [1, 4), the root `y = 1/√m` in (1/2, 1] is approached from below by `Y_j` of `j` fraction bits, the first of
//! them one. With `w_j = 2^j · (1 − m·Y_j²)`, which lies in [0, 4), and `u_j = 2m·Y_{j−1} + m·2^−j`:
//!
//! - digit `j` is one iff `t = 2·w_{j−1} − u_j ≥ 0`, and then `w_j = t`, else `w_j = 2·w_{j−1}`;
//! - `u_{j+1} = u_j + 3m·2^−(j+1)` for digit one, `u_j − m·2^−(j+1)` for zero.
//!
//! Both are exact with `p − 1 + j` fraction bits. Except for `m = 1` the root has no finite expansion, so the sticky bit
//! is constant one; for `m = 1` all digits are ones and rounding gives the exact result.

use super::parts::delay;
use super::parts::operand::{Operand, exponent_width, normalize, precision};
use super::parts::pipe::{self, Operator, Pipe};
use super::parts::round::{Raw, Special, Underflow, round};
use super::sqrt::even_exponent;
use pointcore_contract::Format;
use rtl::{Expr, bit, cat, lit};

/// Pipeline registers by default.
#[must_use]
pub fn stages(format: Format) -> u32 {
    pipe::stages_for(|pipe| root(pipe, format))
}

/// Module `float_rsqrt`.
#[must_use]
pub fn module(format: Format, stages: u32) -> Operator {
    let summary = "Floating-point reciprocal square root, correctly rounded.";
    pipe::operator("float_rsqrt", summary, stages, |pipe| root(pipe, format))
}

fn root(pipe: &mut Pipe, format: Format) -> Expr {
    pipe.module.variant("format", format);
    let p = precision(format);
    let a = Operand::input(pipe, format, "a");
    let special = rsqrt_special(&a).carry(pipe);
    let [a] = normalize(pipe, format, [&a]);

    pipe.takes(delay::LEVEL);
    let (m, half) = even_exponent(format, &a);
    // The root's leading one stands for 1/2.
    let exponent = lit(exponent_width(format), (2 * format.bias() - 1) as u128) - half;
    let mut exponent = pipe.carry("exponent", exponent);
    let mut m = pipe.carry("m", m);
    pipe.cut([]);

    // Y_1 = 1/2: w_1 = 2 − m/2 with p fraction bits, u_2 = 5m/4 with p + 1.
    pipe.takes(delay::adder(p + 3));
    let first = pipe.arrive(&mut m);
    let mut triple = pipe.carry("triple", first.zext(p + 3) + (first.zext(p + 3) << 1));
    let [mut residual, mut threshold] = pipe.cut([
        ("residual", (lit(p + 2, 2 << p) - first.zext(p + 2))),
        ("threshold", ((first.zext(p + 4) << 2) + first.zext(p + 4))),
    ]);

    let mut root = bit(true);
    for digit in 2..=p + 1 {
        // Sign, three integer bits, p − 1 + digit fraction bits.
        let bits = p + digit + 3;
        pipe.takes(delay::adder(p + 2 + digit) + delay::LEVEL);
        let doubled = cat([residual, lit(2, 0)]).zext(bits);
        let difference = doubled - threshold.zext(bits);
        let reached = !difference.msb();
        let next_threshold = cat([threshold, bit(false)]);
        let raised = next_threshold + pipe.arrive(&mut triple).zext(bits);
        let lowered = next_threshold - pipe.arrive(&mut m).zext(bits);
        [residual, threshold, root] = pipe.cut([
            ("residual", reached.mux(difference, doubled).trunc(bits - 2)),
            ("threshold", reached.mux(raised, lowered)),
            ("root", cat([root, reached])),
        ]);
    }

    let significand = cat([root, bit(true)]);
    let exponent = pipe.arrive(&mut exponent);
    round(pipe, format, Underflow::Impossible, Raw { special, exponent, significand })
}

/// Special results of a reciprocal square root.
pub(super) fn rsqrt_special(operand: &Operand) -> Special {
    Special {
        sign: operand.sign,
        nan: operand.nan | (operand.sign & !operand.zero),
        infinite: operand.zero,
        zero: operand.infinite,
    }
}
