//! Reciprocals, square roots and ratios as the configuration's [`Division`] has them.

use crate::number::Number;
use pointcore_contract::splat::Division;

/// `1/x`.
pub(crate) fn recip(division: Division, x: Number) -> Number {
    match division {
        Division::Rounded => x.recip(),
        Division::Newton => x.recip_newton(),
    }
}

/// `√x`.
pub(crate) fn sqrt(division: Division, x: Number) -> Number {
    match division {
        Division::Rounded => x.sqrt(),
        Division::Newton => x.sqrt_newton(),
    }
}

/// `1/√x`.
pub(crate) fn rsqrt(division: Division, x: Number) -> Number {
    match division {
        Division::Rounded => x.rsqrt(),
        Division::Newton => x.rsqrt_newton(),
    }
}

/// `(s1² + s2²)/d²`: one quotient of squares, or the squares of two quotients.
pub(crate) fn squared_ratio(division: Division, [s1, s2]: [Number; 2], d: Number) -> Number {
    match division {
        Division::Rounded => (s1 * s1 + s2 * s2) / (d * d),
        Division::Newton => {
            let r = d.recip_newton();
            let (q1, q2) = (s1 * r, s2 * r);
            q1 * q1 + q2 * q2
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::Format;

    const FORMATS: [Format; 4] = [Format::F32, Format::F32.flushed(), Format::F24.flushed(), Format::BF16];

    /// Zero, numbers over the whole range with their neighbours, infinity and NaN, of both signs.
    fn numbers(format: Format) -> Vec<Number> {
        let largest = format.infinity() as u32;
        let step = (largest / 37) | 1;
        let magnitudes = (0..=largest).step_by(step as usize).chain([1, largest - 1, largest, largest | 1]);
        let powers = (1..format.exponent_max() as u32).step_by(7).map(|exponent| exponent << format.mantissa);
        let magnitudes: Vec<u32> = magnitudes.chain(powers).collect();
        let signs = [0, format.sign_mask() as u32];
        let all = signs.into_iter().flat_map(|sign| magnitudes.iter().map(move |&bits| bits | sign));
        all.map(|bits| Number::new(format, bits)).collect()
    }

    #[test]
    fn roots_are_numbers_where_rounded_ones_are() {
        for format in FORMATS {
            // What arithmetic brings forth: no subnormal number where they are flushed.
            for x in numbers(format).into_iter().map(|x| x.of(0.0) + x) {
                let (newton, rounded) = (sqrt(Division::Newton, x), sqrt(Division::Rounded, x));
                assert_eq!(newton.is_nan(), rounded.is_nan(), "{x:?}");
                let error = (f64::from(newton.value()) / f64::from(rounded.value()) - 1.0).abs();
                let unit = 0.5_f64.powi(format.mantissa as i32 + 1);
                assert!(newton == rounded || newton.is_nan() || error <= 3.2 * unit, "{x:?}: {newton:?}, {rounded:?}");
            }
        }
    }

    #[test]
    fn a_ratio_that_is_no_number_lies_outside_either_way() {
        for format in FORMATS {
            let numbers = numbers(format);
            let mut nans = 0;
            for &d in &numbers {
                for &s1 in &numbers {
                    for s2 in [s1, s1.of(0.0), s1.of(1.0), s1.of(f32::INFINITY)] {
                        let newton = squared_ratio(Division::Newton, [s1, s2], d);
                        let rounded = squared_ratio(Division::Rounded, [s1, s2], d);
                        let is_outside = rounded.is_nan() || rounded.value() == f32::INFINITY;
                        assert!(!newton.is_nan() || is_outside, "{s1:?}, {s2:?} over {d:?}: {rounded:?}");
                        nans += u32::from(newton.is_nan() && !rounded.is_nan());
                    }
                }
            }
            assert!(nans > 0, "{format}: there are some at 0/0");
        }
    }
}
