//! The interpolated tables against f64.

use pointcore_contract::TableShape;
use pointcore_golden::float::{Table, erf_table, kernel_integral_table, kernel_table};

const SHAPES: [TableShape; 3] = [
    TableShape { index_bits: 4, fraction_bits: 6, value_bits: 8 },
    TableShape { index_bits: 8, fraction_bits: 8, value_bits: 16 },
    TableShape { index_bits: 7, fraction_bits: 0, value_bits: 12 },
];

/// Checks the whole of every argument's interval; `chord` bounds the distance of chord and curve, `slope` the curve's slope.
fn within_bound(table: &Table, shape: TableShape, chord: f64, slope: f64, exact: impl Fn(f64) -> f64) {
    let one = ((1_u64 << shape.value_bits) - 1) as f64;
    let intervals = (1_u64 << shape.index_bits) as f64;
    // Both ends of what an argument stands for where the table alone does.
    let (bound, ends) = match shape.fraction_bits {
        0 => (slope / 2.0 / intervals * one + 0.5, 0..2),
        _ => (chord * one + 1.5, 0..1),
    };
    let arguments = 1_u64 << (shape.index_bits + shape.fraction_bits);
    for t in 0..arguments {
        for end in ends.clone() {
            let expected = exact((t + end) as f64 / arguments as f64) * one;
            let error = (table.interpolate(t) as f64 - expected).abs();
            assert!(error <= bound, "{shape:?}: off by {error} units at {t} + {end}");
        }
    }
}

#[test]
fn kernel_is_within_its_bound() {
    for shape in SHAPES {
        for gamma in [0.5, 1.0, 2.0, 4.0] {
            let chord = gamma * gamma / 8.0 * 0.25_f64.powi(shape.index_bits as i32);
            within_bound(&kernel_table(gamma, shape), shape, chord, gamma, |t| (-gamma * t).exp());
        }
    }
}

#[test]
fn erf_is_within_its_bound() {
    for shape in SHAPES {
        let chord = 2.0 * 0.25_f64.powi(shape.index_bits as i32);
        let slope = 4.0 * std::f64::consts::FRAC_2_SQRT_PI;
        within_bound(&erf_table(shape), shape, chord, slope, |t| simpson_erf(4.0 * t));
    }
}

#[test]
fn the_kernels_integral_is_within_its_bound() {
    for shape in SHAPES {
        for gamma in [0.1, 0.5, 2.0, 8.0] {
            let chord = (2.0 * gamma / std::f64::consts::E).sqrt() / 8.0 * 0.25_f64.powi(shape.index_bits as i32);
            let integral = |t: f64| simpson_erf(gamma.sqrt() * t) / (std::f64::consts::FRAC_2_SQRT_PI * gamma.sqrt());
            within_bound(&kernel_integral_table(gamma, shape), shape, chord, 1.0, integral);
        }
    }
}

/// `erf(x) = 2/√π · ∫₀ˣ exp(−t²) dt` by Simpson's rule, to about 10^−12 for x ≤ 4.
fn simpson_erf(x: f64) -> f64 {
    const INTERVALS: u32 = 1000;
    let step = x / f64::from(INTERVALS);
    let sum: f64 = (0..=INTERVALS)
        .map(|i| {
            let weight = match i {
                0 | INTERVALS => 1.0,
                odd if odd % 2 == 1 => 4.0,
                _ => 2.0,
            };
            weight * (-(step * f64::from(i)).powi(2)).exp()
        })
        .sum();
    std::f64::consts::FRAC_2_SQRT_PI * sum * step / 3.0
}

/// By hand: between 255 and 155, a fraction of 1/64 truncates −100/64 to −2.
#[test]
fn a_falling_interval_truncates_downward() {
    let shape = TableShape { index_bits: 0, fraction_bits: 6, value_bits: 8 };
    let table = kernel_table(0.5, shape);
    assert_eq!(table.values(), [255, 155]);
    assert_eq!([0, 1, 32, 63].map(|t| table.interpolate(t)), [255, 253, 205, 156]);
}
