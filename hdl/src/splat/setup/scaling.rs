//! `A`, `B`, `Δ` and `m` times one power of two, by exponents alone, so that no square of theirs overflows or vanishes; golden twin:
//! `pointcore_golden::splat::setup::scaling`.

use super::exponent::{Exponents, ONE};
use crate::compiler::{Value, name};

/// Lengths and `m` stay below this power of two.
const FARTHEST: u64 = 100;
/// Tangents stay below this power of two, measured in the centre's depth.
const LONGEST: u64 = 60;

/// A footprint's coefficients.
pub(super) struct Scaled {
    /// `A_x`, `A_y`.
    pub a: [Value; 2],
    /// `B_x`, `B_y`.
    pub b: [Value; 2],
    /// `Δ`.
    pub delta: Value,
    /// `m_x`, `m_y`.
    pub m: [Value; 2],
    /// `Δ` of tangents that are about one long, and its first term.
    pub of_units: [Value; 2],
    /// A tangent is so short that it has lost digits to the range of exponents.
    pub vanishing: Value,
}

/// A tangent with a smaller biased exponent has terms that vanished.
const VANISHING: u64 = 32;

/// By how many places tangents are made shorter.
pub(super) fn places(exponents: &Exponents, depth: Value, tangents: &[[Value; 3]; 2]) -> Value {
    let parts = tangents.iter().flatten().map(|part| exponents.of(*part));
    let longest = parts.reduce(Value::max).expect("there are six");
    exponents.less(longest, exponents.of(depth) + exponents.lit(LONGEST))
}

/// What is common to both tangents.
#[derive(Clone, Copy)]
pub(super) struct Common {
    /// By how many places they are too short, if they may be.
    pub lowered: Option<Value>,
    /// What depth changes with `u_z`.
    pub depth: Value,
}

/// Of tangents in pixels and their depths relative to the centre's.
pub(super) fn scaled(
    exponents: &Exponents,
    a: [Value; 2],
    b: [Value; 2],
    slopes: [Value; 2],
    common: Common,
) -> Scaled {
    let one = exponents.lit(ONE);
    let [a_exponent, b_exponent] = [a, b].map(|[x, y]| exponents.of(x).max(exponents.of(y)));
    let [a_x, a_y] = a.map(|length| exponents.raise(length, one, a_exponent));
    let [b_x, b_y] = b.map(|length| exponents.raise(length, one, b_exponent));
    let diagonal = a_x * b_y;
    let unit_delta = diagonal - b_x * a_y;

    let [alpha, beta] = slopes;
    let (a_lean, b_lean) = (a_exponent + exponents.of(beta), b_exponent + exponents.of(alpha));
    let m_exponent = a_lean.max(b_lean);
    let unit_beta = exponents.raise(beta, a_exponent + one, m_exponent);
    let unit_alpha = exponents.raise(alpha, b_exponent + one, m_exponent);
    let unit_m = [unit_beta * a_y - unit_alpha * b_y, unit_alpha * b_x - unit_beta * a_x];

    // All of these with 254 more, so that none is negative.
    let lower = |value: Value| common.lowered.map_or(value, |lowered| value + lowered);
    let (area, slope) = (lower(a_exponent + b_exponent), lower(m_exponent));
    let of_delta = area + exponents.of(unit_delta);
    let of_lengths = a_exponent.max(b_exponent) + exponents.lit(2 * ONE - FARTHEST);
    let farthest = exponents.less(of_delta, exponents.lit(FARTHEST)).max(of_lengths);
    let of_near = exponents.less(of_delta + one, exponents.of(common.depth));
    let largest = of_near.max(farthest).max(slope + exponents.lit(ONE - FARTHEST));
    name!(a_exponent, b_exponent, m_exponent, largest, unit_delta);
    let length = |value: Value| exponents.raise(value, exponents.lit(3 * ONE), largest);
    Scaled {
        a: a.map(length),
        b: b.map(length),
        delta: exponents.raise(unit_delta, area + one, largest),
        m: unit_m.map(|m| exponents.raise(m, slope + one, largest)),
        of_units: [unit_delta, diagonal],
        vanishing: a_exponent.min(b_exponent).lt(exponents.lit(VANISHING)),
    }
}
