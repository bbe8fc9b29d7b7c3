//! The Newton variants' error, over every significand of every named format.

use crate::support::{formats, operand_tuples, reproduce};
use pointcore_contract::Format;
use pointcore_golden::float;

fn number(f: Format, bits: u64) -> f64 {
    f32::from_bits(float::convert(f, Format::F32, bits) as u32).into()
}

/// The largest error, in units of the exact result's last place, for operands in [1, 4), which repeats with every power
/// of four as long as the result is normal.
fn largest_error_ulp(f: Format, model: fn(Format, u64) -> u64, exact: fn(f64) -> f64) -> f64 {
    let (start, end) = (f.one(), f.one() + (2 << f.mantissa));
    let errors = (start..end).map(|a| {
        let exact = exact(number(f, a));
        let last_place = (exact.log2().floor() - f64::from(f.mantissa)).exp2();
        (number(f, model(f, a)) - exact).abs() / last_place
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn newton_error_is_as_documented() {
    for (_, f) in Format::NAMED {
        let reciprocal = largest_error_ulp(f, float::recip_newton, |x| 1.0 / x);
        let root = largest_error_ulp(f, float::rsqrt_newton, |x| 1.0 / x.sqrt());
        println!("fp.recip_newton.{f}.max_ulp {reciprocal:.4}\nfp.rsqrt_newton.{f}.max_ulp {root:.4}");
        assert!(reciprocal <= 0.565, "recip_newton is off by {reciprocal} ulp in {f}");
        assert!(root <= 0.576, "rsqrt_newton is off by {root} ulp in {f}");
    }
}

/// Over the whole range, subnormal operands and results included, a variant is the correctly rounded result or a
/// neighbour of it, and the same for special operands.
#[test]
fn newton_is_next_to_the_correctly_rounded_result() {
    for f in formats() {
        let mut differ = 0_u64;
        for [a] in operand_tuples(f) {
            for (newton, exact) in
                [(float::recip_newton(f, a), float::recip(f, a)), (float::rsqrt_newton(f, a), float::rsqrt(f, a))]
            {
                let special = exact & f.infinity() == f.infinity();
                let distance = newton.abs_diff(exact);
                assert!(distance <= u64::from(!special), "{a:x} in {f}: {newton:x}, not {exact:x}\n{}", reproduce());
                differ += distance;
            }
        }
        assert!(differ > 0, "in {f} the Newton variants are expected to differ from correct rounding somewhere");
    }
}
