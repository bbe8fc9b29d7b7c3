//! Reciprocals, square roots and ratios from the operators that the configuration chooses; golden twin:
//! `pointcore_golden::splat::division`.

use crate::compiler::{Program, Value};
use pointcore_contract::Format;
use pointcore_contract::splat::Division;

/// `1/x`.
pub(crate) fn recip(division: Division, x: Value) -> Value {
    match division {
        Division::Rounded => x.recip(),
        Division::Newton => x.recip_newton(),
    }
}

/// `√x`.
pub(crate) fn sqrt(division: Division, program: &Program, format: Format, x: Value) -> Value {
    match division {
        Division::Rounded => x.sqrt(),
        Division::Newton => {
            let sign = format.width() - 1;
            let is_zero = x.bits(sign - 1, 0).eq(program.lit(sign, 0));
            let is_infinite = x.bits(sign, 0).eq(program.lit(format.width(), format.infinity()));
            (is_zero | is_infinite).mux(x, x * x.rsqrt_newton())
        }
    }
}

/// `1/√x`.
pub(crate) fn rsqrt(division: Division, x: Value) -> Value {
    match division {
        Division::Rounded => x.rsqrt(),
        Division::Newton => x.rsqrt_newton(),
    }
}

/// `(a² + b²)/d²`.
pub(crate) fn squared_ratio(division: Division, a: Value, b: Value, d: Value) -> Value {
    match division {
        Division::Rounded => (a * a + b * b) / (d * d),
        Division::Newton => {
            let r = d.recip_newton();
            let [along, across] = [a, b].map(|part| part * r);
            along * along + across * across
        }
    }
}
