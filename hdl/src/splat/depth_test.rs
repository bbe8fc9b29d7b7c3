//! The ternary depth test against the normalized stored depth, cross-multiplied instead of divided (eq. 5.8, 5.9); golden
//! twin: `pointcore_golden::splat::depth_test`.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{DEPTH_BITS, DEPTH_SUM_BITS, WEIGHT_SUM_BITS};
use pointcore_contract::splat::units::depth_test::PORTS;

use crate::units::ports::WordPort;
use rtl::{Expr, Module};

/// Cycles from inputs to outputs.
pub(super) const LATENCY: u32 = 3;

/// A register that follows a value.
fn delayed(m: &mut Module, name: &str, value: Expr) -> Expr {
    let register = m.reg(name, value.width());
    m.next(register, value);
    register.expr()
}

/// `left · right` in two cycles, pieced together from products of halves, which fit hardware multipliers.
fn product(m: &mut Module, name: &str, left: Expr, right: Expr) -> Expr {
    let width = left.width() + right.width();
    let (left_half, right_half) = (left.width() / 2, right.width() / 2);
    let [low_left, high_left] = [left.trunc(left_half), left.bits(left.width() - 1, left_half)];
    let [low_right, high_right] = [right.trunc(right_half), right.bits(right.width() - 1, right_half)];
    let mut partial = |part: &str, left: Expr, right: Expr, place: u32| {
        delayed(m, &format!("{name}_{part}"), left * right).zext(width) << place
    };
    // The outer two do not overlap.
    let outer = partial("low_low", low_left, low_right, 0)
        | partial("high_high", high_left, high_right, left_half + right_half);
    let inner =
        [partial("high_low", high_left, low_right, left_half), partial("low_high", low_left, high_right, right_half)];
    let [first, second] = inner;
    delayed(m, name, outer + first + second)
}

/// The unit.
#[must_use]
pub fn module(_config: &Config) -> Module {
    let mut m = Module::new("splat_depth_test", "Compares a pixel's normalized depth with a splat's depth band.");
    let weight = PORTS.weight.declare_word(&mut m, WEIGHT_SUM_BITS);
    let depth = PORTS.depth.declare_word(&mut m, DEPTH_SUM_BITS);
    let low = PORTS.depth_low.declare_word(&mut m, DEPTH_BITS);
    let high = PORTS.depth_high.declare_word(&mut m, DEPTH_BITS);

    let arrived = delayed(&mut m, "arrived", depth);
    let stored = delayed(&mut m, "stored", arrived);
    let low_bound = product(&mut m, "low_bound", low, weight);
    let high_bound = product(&mut m, "high_bound", high, weight);
    // Of what was there before the reset nothing shows.
    PORTS.fail.event(&mut m, stored.lt(low_bound));
    PORTS.pass.event(&mut m, stored.gt(high_bound));
    m
}
