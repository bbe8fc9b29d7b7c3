//! Tables of the error function over [0, 4], and of the integral of a kernel by it over [0, 1].

use super::parts::table::sample;
use pointcore_contract::TableShape;
use std::f64::consts::PI;

/// Upper end of the argument; beyond, erf differs from 1 by less than 2^−25.
const END: f64 = 4.0;

/// Samples of `erf(4·t)` for [`table::module`](super::parts::table::module).
#[must_use]
pub fn samples(shape: TableShape) -> Vec<u64> {
    sample(shape, |t| erf(END * t))
}

/// Samples of `∫₀ᵗ exp(−γy²) dy` for [`table::module`](super::parts::table::module).
#[must_use]
pub fn integral_samples(gamma: f64, shape: TableShape) -> Vec<u64> {
    let scale = (PI / (4.0 * gamma)).sqrt();
    sample(shape, |t| scale * erf(gamma.sqrt() * t))
}

/// `2/√π · exp(−x²) · Σ 2^n x^(2n+1) / (2n+1)!!`: all terms positive, so none cancel.
fn erf(x: f64) -> f64 {
    let mut term = x;
    let mut sum = 0.0;
    let mut odd = 1.0;
    while sum + term > sum {
        sum += term;
        odd += 2.0;
        term *= 2.0 * x * x / odd;
    }
    2.0 / PI.sqrt() * (-x * x).exp() * sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        for (x, expected) in
            [(0.0, 0.0), (0.5, 0.520_499_877_813_046_5), (1.0, 0.842_700_792_949_714_9), (2.0, 0.995_322_265_018_952_7)]
        {
            assert!((erf(x) - expected).abs() < 1e-15, "erf({x}) = {}", erf(x));
        }
    }
}
