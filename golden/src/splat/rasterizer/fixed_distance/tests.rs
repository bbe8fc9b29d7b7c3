use super::*;
use crate::splat::setup::fixed_footprint::{Projection, footprint};
use crate::splat::setup::sight::Limits;
use fastrand::Rng;
use std::ops::Range;

const KERNEL_BITS: u32 = 16;
const SPLATS: usize = 3000;
const SAMPLES: usize = 40;
const IMAGE: f64 = 512.0;

fn number(value: f64) -> Number {
    Number::new(Format::F32, (value as f32).to_bits())
}

fn value(number: Number) -> f64 {
    number.value().into()
}

/// All of a splat with such a `Δ` is seen.
fn seen(delta: f64) -> Limits {
    Limits { is_negative: delta < 0.0, planes: [None; 2], is_turned: false, has_disc: true }
}

fn distance(coefficient: Coefficient) -> Distance {
    Distance { coefficient, kernel_bits: KERNEL_BITS, eye_plane: Feature::On, screen_filter: Feature::Off }
}

/// An ellipse of 2^−1 to 2^9 px, leaning towards the eye by up to a slant of 0.95, whose centre lies about the image.
fn splat(random: &mut Rng) -> (Projection, [Range<u64>; 2]) {
    let mut centered = || 2.0 * random.f64() - 1.0;
    let center = [(); 2].map(|()| number(IMAGE * (0.5 + 0.7 * centered())));
    let radius = 2.0_f64.powf(4.0 + 5.0 * centered());
    let (turn, tilt) = (3.2 * centered(), 3.2 * centered());
    let (steepness, aspect) = (0.95 * centered().abs(), 2.0_f64.powf(3.0 * centered() - 3.0));
    let axes = [[turn.cos(), turn.sin()], [-turn.sin() * aspect, turn.cos() * aspect]];
    let [a, b] = axes.map(|axis| axis.map(|part| value(number(part * radius))));
    let (alpha, beta) = (steepness * tilt.cos(), steepness * tilt.sin());
    let delta = a[0] * b[1] - b[0] * a[1];
    let m = [beta * a[1] - alpha * b[1], alpha * b[0] - beta * a[0]].map(number);
    let e = 1.0 - steepness * steepness;
    let pixels = [0, 1].map(|axis: usize| {
        let middle = value(center[axis]) - (a[axis] * alpha + b[axis] * beta) / e;
        let half = (middle - value(center[axis])).hypot(a[axis].hypot(b[axis]) / e.sqrt());
        let first = (middle - half).clamp(0.0, IMAGE - 1.0);
        let last = (middle + half).clamp(first, IMAGE - 1.0);
        first as u64..last as u64 + 1
    });
    (
        Projection { center, a: a.map(number), b: b.map(number), delta: Some(number(delta)), m, limits: seen(delta) },
        pixels,
    )
}

/// `ρ²` of a sample by f64, infinite behind the eye, and how far docs/stability.md says that integers may be off.
fn truth(coefficient: Coefficient, splat: &Projection, fixed: &Footprint, sample: [f64; 2]) -> (f64, f64) {
    let pair = |pair: [Number; 2]| pair.map(value);
    let (center, [ax, ay], [bx, by], [mx, my]) = (pair(splat.center), pair(splat.a), pair(splat.b), pair(splat.m));
    let delta = value(splat.delta.expect("it is not seen edge-on"));
    let [x, y] = [0, 1].map(|axis| sample[axis] - center[axis]);
    let s = (x * ay - y * ax).hypot(x * by - y * bx);
    let d = delta + x * mx + y * my;
    let squared = if (d < 0.0) == (delta < 0.0) { (s / d).powi(2) } else { f64::INFINITY };

    // Units of a coefficient, of an offset, and of Δ.
    let widest = |integer: u32| signed(integer, coefficient.width()).unsigned_abs() as f64;
    let coefficients = [(ax, fixed.ax), (ay, fixed.ay), (bx, fixed.bx), (by, fixed.by)];
    let (length, integer) = coefficients
        .map(|(length, integer)| (length.abs(), widest(integer)))
        .into_iter()
        .fold((0.0, 1.0), |widest, pair| if pair.0 > widest.0 { pair } else { widest });
    let unit = (length / integer).log2().round().exp2();
    let place = 0.5_f64.powi(coefficient.place_fraction() as i32);
    let shifted = place * f64::from(fixed.shift).exp2();
    let offset_error = place / 2.0 + if fixed.shift > 0 { shifted } else { 0.0 };
    let sum_error = |a: f64, b: f64| (a.abs() + b.abs() + 2.0 * unit) * offset_error + (x.abs() + y.abs()) * unit;
    let significant = d.abs() * 0.5_f64.powi(Coefficient::SIGNIFICANT_BITS as i32 - 1);
    let s_error = sum_error(ax, ay).hypot(sum_error(bx, by)) + (unit * shifted + significant) * 2.0_f64.sqrt();
    let delta_unit = unit * shifted / place;
    let d_error = sum_error(mx, my) + delta_unit + unit * shifted + significant;
    let known = d.abs() - d_error;
    if known <= 0.0 {
        return (squared, f64::INFINITY);
    }
    let rho = s / d.abs();
    let error = (s_error + rho * d_error) / known;
    let quotient = 0.5_f64.powi(KERNEL_BITS as i32) * (1.0 + 2.0_f64.powi(3 - GUARD_BITS as i32));
    (squared, 2.0 * rho * error + error * error + quotient)
}

#[test]
fn distances_lie_within_their_bound_of_f64() {
    for (name, coefficient) in Coefficient::NAMED {
        let mut random = Rng::with_seed(5);
        let unit = distance(coefficient);
        let (mut inside, mut outside, mut undetermined, mut sum, mut bounds, mut worst) = (0, 0, 0, 0.0, 0.0, 0.0_f64);
        for _ in 0..SPLATS {
            let (splat, pixels) = splat(&mut random);
            let fixed = footprint(coefficient, &splat, pixels.clone());
            if fixed.delta == 0 {
                continue;
            }
            for _ in 0..SAMPLES {
                let pixel = pixels.clone().map(|range| random.u64(range) as u32);
                let computed = unit.squared(&fixed, pixel.map(|index| 8 * index + 4), 0);
                let (squared, bound) = truth(coefficient, &splat, &fixed, pixel.map(|index| f64::from(index) + 0.5));
                if squared + bound < 1.0 {
                    let error = (value(computed) - squared).abs();
                    assert!(error <= bound, "{name}: {computed:?} for {squared} ± {bound} of {splat:?}");
                    inside += 1;
                    sum += error;
                    bounds += bound;
                    worst = worst.max(error / bound);
                } else if squared - bound >= 1.0 {
                    assert_eq!(value(computed), f64::INFINITY, "{name}: {squared} ± {bound} of {splat:?}");
                    outside += 1;
                } else {
                    undetermined += 1;
                }
            }
        }
        let [mean, mean_bound] = [sum, bounds].map(|sum: f64| sum / f64::from(inside));
        println!("{name}: mean error {mean:.2e} of {mean_bound:.2e}, {worst:.2} of the bound at most");
        println!("{inside} inside, {outside} outside, {undetermined} undetermined");
        assert!(inside > 20_000 && outside > 10_000 && undetermined < inside / 10);
        let (mean_limit, bound_limit) = match coefficient {
            Coefficient::Sixteen => (2e-4, 2e-3),
            Coefficient::Eighteen => (6e-5, 6e-4),
        };
        assert!(mean < mean_limit && mean_bound < bound_limit && worst > 0.3, "{name}");
    }
}

/// A disc of 3 px about (20.3, 9.6), in its bounds.
fn disc() -> (Projection, [Range<u64>; 2]) {
    let pairs = [[20.3, 9.6], [3.0, 0.0], [0.0, 3.0], [0.0, 0.0]];
    let [center, a, b, m] = pairs.map(|pair| pair.map(number));
    (Projection { center, a, b, delta: Some(number(9.0)), m, limits: seen(9.0) }, [17..24, 6..13])
}

#[test]
fn a_filters_disc_is_as_wide_as_its_radius() {
    let (splat, pixels) = disc();
    for (name, coefficient) in Coefficient::NAMED {
        let unit = Distance { screen_filter: Feature::On, ..distance(coefficient) };
        let fixed = footprint(coefficient, &Projection { delta: None, ..splat }, pixels.clone());
        for radius in [0.3, 1.0, 2.5, 3.9] {
            let scale = f64::from(1 << Coefficient::FILTER_SCALE.fraction) / (radius * radius);
            let scale = scale.round();
            for (column, row) in (10..30).flat_map(|column| (0..20).map(move |row| (column, row))) {
                let squared = value(unit.squared(&fixed, [column, row].map(|index| 8 * index + 4), scale as u32));
                let offset = [column, row].map(|index| f64::from(index) + 0.5);
                let exact = (offset[0] - 20.3).powi(2) + (offset[1] - 9.6).powi(2);
                let exact = exact * scale / f64::from(1 << Coefficient::FILTER_SCALE.fraction);
                let error = 4.0 * (radius + 1.0) / (radius * radius) * 0.5_f64.powi(12);
                if exact < 1.0 - error {
                    assert!((squared - exact).abs() <= error, "{name}: {squared} for {exact} at {radius} px");
                } else if exact > 1.0 + error {
                    assert_eq!(squared, f64::INFINITY, "{name}: {exact} at {radius} px");
                }
            }
        }
    }
}

#[test]
fn what_is_no_number_covers_nothing_and_without_a_place_no_disc() {
    let (splat, pixels) = disc();
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let far = [8192.0, -8192.0, 1e6, -1e30].map(number);
    let wrong = |change: &dyn Fn(&mut Projection)| {
        let mut splat = splat;
        change(&mut splat);
        splat
    };
    let mut bad: Vec<(Projection, bool)> = vec![(wrong(&|splat| splat.delta = None), true)];
    for odd in odd.map(number).into_iter() {
        for axis in [0, 1] {
            bad.push((wrong(&|splat| splat.a[axis] = odd), true));
            bad.push((wrong(&|splat| splat.b[axis] = odd), true));
            bad.push((wrong(&|splat| splat.m[axis] = odd), true));
            bad.push((wrong(&|splat| splat.center[axis] = odd), false));
        }
        bad.push((wrong(&|splat| splat.delta = Some(odd)), true));
    }
    bad.extend(far.iter().flat_map(|&far| [0, 1].map(|axis| (wrong(&|splat| splat.center[axis] = far), false))));
    bad.push((wrong(&|splat| splat.delta = Some(number(1e-5))), true));
    bad.push((wrong(&|splat| splat.delta = Some(number(-0.0))), true));
    for (name, coefficient) in Coefficient::NAMED {
        let without = distance(coefficient);
        let with = Distance { screen_filter: Feature::On, ..without };
        let covered = |unit: &Distance, splat: &Projection| {
            let fixed = footprint(coefficient, splat, pixels.clone());
            let places = pixels[1].clone().flat_map(|row| pixels[0].clone().map(move |column| [column, row]));
            let squared = places.map(|place| unit.squared(&fixed, place.map(|index| 8 * index as u32 + 4), 1 << 12));
            squared.filter(|squared| value(*squared) < 1.0).count()
        };
        assert!(covered(&without, &splat) > 20, "{name}");
        for (bad, has_disc) in &bad {
            assert_eq!(covered(&without, bad), 0, "{name}: {bad:?}");
            assert_eq!(covered(&with, bad) > 0, *has_disc, "{name}: {bad:?}");
        }
    }
}

#[test]
fn a_footprint_is_the_same_in_any_unit() {
    let mut random = Rng::with_seed(6);
    for (name, coefficient) in Coefficient::NAMED {
        for _ in 0..100 {
            let (splat, pixels) = splat(&mut random);
            let fixed = footprint(coefficient, &splat, pixels.clone());
            for scale in [1e-9_f64, 1e9, 1e24].map(|scale| scale.log2().round().exp2()) {
                let scaled = |part: Number| number(value(part) * scale);
                let Projection { center, a, b, delta, m, limits } = splat;
                let [a, b, m] = [a, b, m].map(|pair| pair.map(scaled));
                let splat = Projection { center, a, b, delta: delta.map(scaled), m, limits };
                assert_eq!(footprint(coefficient, &splat, pixels.clone()), fixed, "{name}: {splat:?}");
            }
        }
    }
}
