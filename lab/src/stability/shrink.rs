//! Making a counterexample small: fewer digits, in ever more of its numbers, as long as the property does not hold.

use super::case::Case;
use super::check::{BrokenProperty, Property, check};
use super::hardware::Units;
use pointcore_contract::splat::Feature;

/// Numbers of a case.
const PLACES: usize = 9;

/// The case with fewer digits in which `property` still does not hold, and how; `None` if it holds from the beginning.
#[must_use]
pub fn shrink(units: &Units, case: &Case, seed: u64, property: Property) -> Option<(Case, BrokenProperty)> {
    let violation = |case: &Case| check(units, case, seed).of(property).cloned();
    let (mut case, mut found) = (*case, violation(case)?);
    let off = Case { filter: Feature::Off, ..case };
    if let Some(without) = violation(&off) {
        (case, found) = (off, without);
    }
    loop {
        let mut is_smaller = false;
        for place in 0..PLACES {
            let number = case.numbers()[place];
            for simpler in simpler(number) {
                let candidate = case.with_number(place, simpler);
                // What the format makes of it may be the number again.
                let shorter = digits(candidate.numbers()[place]) < digits(number);
                if let Some(violation) = violation(&candidate).filter(|_| shorter) {
                    (case, found) = (candidate, violation);
                    is_smaller = true;
                    break;
                }
            }
        }
        if !is_smaller {
            return Some((case, found));
        }
    }
}

/// Significant bits and size of the exponent: what a reader has to take in.
fn digits(number: f64) -> u32 {
    if number == 0.0 {
        return 0;
    }
    let bits = number.to_bits() & ((1 << 52) - 1);
    let exponent = if number.is_finite() { number.abs().log2().floor().abs() as u32 } else { 0 };
    53 - bits.trailing_zeros().min(52) + exponent.div_ceil(4) + u32::from(number < 0.0)
}

/// Numbers to try in the place of another, the simplest first.
fn simpler(number: f64) -> Vec<f64> {
    let mut candidates = vec![0.0, 1.0, -1.0, number.abs()];
    if number.is_finite() {
        let power = number.abs().max(f64::MIN_POSITIVE).log2().round();
        candidates.extend([number / 16.0, number * 16.0, number / 2.0, number * 2.0]);
        candidates.extend([0, 1, 2, 4, 8, 12, 16, 20].map(|bits| {
            let unit = (power - f64::from(bits)).exp2();
            (number / unit).round() * unit
        }));
    }
    candidates
}
