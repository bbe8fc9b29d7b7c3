//! The closed form beside numbers.

use super::*;
use crate::reference::motion::quadrature::{self, STEP};
use crate::reference::{Bounds, Projection};

/// What a closed form may be off from numbers.
const BOUND: f64 = 1.0 / 65536.0;

/// Closed form and quadrature of a splat at a place, and in how many pieces it covers it.
fn both(moving: &MovingSplat, place: &Place, shutter: Shutter, rendering: &Rendering) -> (f64, f64, usize) {
    let numbers = quadrature::integral(moving, place, shutter, &CAMERA, rendering);
    let Ok(kernel) = Kernel::new(moving, &CAMERA, rendering) else { return (0.0, numbers, 0) };
    let pieces = kernel.pieces(place, &CAMERA);
    let count = pieces.len();
    let hit = Hit { kernel: &kernel, pieces };
    (hit.integral(Interval::EXPOSURE, shutter, rendering.kernel_gamma), numbers, count)
}

#[test]
fn the_closed_form_is_the_integral_of_the_moving_footprint() {
    let mut random = Random::new();
    let (mut covered, mut worst) = (0, 0.0_f64);
    for _ in 0..2000 {
        let moving = random.moving(0.2);
        let (place, shutter) = (random.place_near(&moving), random.shutter());
        let (closed, numbers, _) = both(&moving, &place, shutter, &UNFILTERED);
        assert!((closed - numbers).abs() <= BOUND, "{closed} beside {numbers}: {moving:?} at {place:?}, {shutter:?}");
        covered += usize::from(closed > 0.0);
        worst = worst.max((closed - numbers).abs());
    }
    assert!(covered > 1000, "only {covered} of 2000 are covered");
    println!("worst {worst:e}");
}

#[test]
fn the_screen_filter_moves_along() {
    let mut random = Random::new();
    for _ in 0..1000 {
        let mut moving = random.moving(0.2);
        // Small ones, parallel to the image, where the filter keeps its size.
        let shrink = random.uniform(0.02, 0.5) as f32;
        moving.splat.tangents.iter_mut().flatten().for_each(|component| *component *= shrink);
        moving.motion.z = 0.0;
        let (place, shutter) = (random.place_near(&moving), random.shutter());
        let (closed, numbers, pieces) = both(&moving, &place, shutter, &RENDERING);
        // Where filter and splat change places, nothing jumps; each end of a piece may.
        assert!((closed - numbers).abs() <= BOUND.max(STEP * pieces as f64), "{closed} beside {numbers}: {moving:?}");
    }
}

#[test]
fn hard_cases_err_by_what_their_numbers_resolve() {
    let mut random = Random::new();
    for index in 0..1500 {
        let mut moving = random.moving(0.3);
        let [first, second] = moving.splat.tangents.map(|tangent| DVec3::from_array(tangent.map(f64::from)));
        match index % 5 {
            // Hardly any motion.
            0 => moving.motion *= 10_f64.powf(random.uniform(-14.0, -2.0)),
            // Within the splat's plane.
            1 => moving.motion = random.uniform(-2.0, 2.0) * first + random.uniform(-2.0, 2.0) * second,
            // Towards the eye, through the near plane.
            2 => moving.motion = -DVec3::Z * f64::from(moving.splat.center[2]) * random.uniform(0.5, 1.5),
            // Nearly edge-on: the second tangent leans to the eye.
            3 => {
                let center = DVec3::from_array(moving.splat.center.map(f64::from));
                let lean = center.normalize() * second.length() + 10_f64.powf(random.uniform(-6.0, -1.0)) * second;
                moving.splat.tangents[1] = lean.as_vec3().to_array();
            }
            // Very fast.
            _ => moving.motion *= 30.0,
        }
        let (place, shutter) = (random.place_near(&moving), random.shutter());
        let (closed, numbers, pieces) = both(&moving, &place, shutter, &UNFILTERED);
        // Either end of a piece lies within half a step of where the sum has it, and no kernel exceeds one; a shutter weighs at most 1.34 times its
        // mean.
        let bound = BOUND.max(1.34 * STEP * (pieces.max(1) as f64));
        assert!((closed - numbers).abs() <= bound, "{index}: {closed} beside {numbers}: {moving:?} at {place:?}");
        assert!(closed.is_finite() && closed >= 0.0);
    }
}

#[test]
fn bounds_hold_all_that_is_covered() {
    let mut random = Random::new();
    let mut covered = 0;
    for index in 0..400 {
        let mut moving = random.moving(if index % 2 == 0 { 0.2 } else { 1.0 });
        if index % 4 == 0 {
            // From without the image into it.
            moving.splat.center[0] += (2.0 * moving.motion.x) as f32;
        }
        let kernel = Kernel::new(&moving, &CAMERA, &RENDERING);
        for row in 0..RENDERING.height {
            for column in 0..RENDERING.width {
                let place = Place::new(column, row, &RENDERING);
                let is_seen = [-0.99, -0.5, -0.1, 0.0, 0.3, 0.7, 0.99]
                    .iter()
                    .any(|&tau| quadrature::weight(&moving, &place, tau, &CAMERA, &UNFILTERED) > 0.0);
                if is_seen {
                    let Ok(kernel) = &kernel else { panic!("culled, but covers ({column}, {row}): {moving:?}") };
                    let Bounds { columns, rows } = &kernel.bounds;
                    assert!(columns.contains(&column) && rows.contains(&row), "({column}, {row}) of {moving:?}");
                    assert!(!kernel.pieces(&place, &CAMERA).is_empty());
                    covered += 1;
                }
            }
        }
    }
    assert!(covered > 5000, "{covered}");
}

#[test]
fn parts_of_an_integral_add_up() {
    let mut random = Random::new();
    for _ in 0..500 {
        let moving = random.moving(0.3);
        let (place, shutter) = (random.place_near(&moving), random.shutter());
        let Ok(kernel) = Kernel::new(&moving, &CAMERA, &RENDERING) else { continue };
        let hit = Hit { kernel: &kernel, pieces: kernel.pieces(&place, &CAMERA) };
        let integral = |interval| hit.integral(interval, shutter, RENDERING.kernel_gamma);
        let whole = integral(Interval::EXPOSURE);
        for count in [1, 2, 3, 8, 64] {
            let sum: f64 = Interval::equal_parts(count).map(integral).sum();
            assert!((sum - whole).abs() < 1e-12, "{count} parts: {sum} beside {whole}");
            let shares: f64 = Interval::equal_parts(count).map(|part| shutter.share(part)).sum();
            assert!((shares - 1.0).abs() < 1e-12);
        }
        // The splat itself in two parts that follow each other.
        let halves: f64 = Interval::equal_parts(2)
            .map(|part| {
                let mut half = moving.clone();
                let center = DVec3::from_array(half.splat.center.map(f64::from)) + part.middle() * half.motion;
                half.splat.center = center.as_vec3().to_array();
                half.part = part;
                both(&half, &place, shutter, &UNFILTERED).0
            })
            .sum();
        let (unfiltered, ..) = both(&moving, &place, shutter, &UNFILTERED);
        assert!((halves - unfiltered).abs() < 1e-5, "{halves} beside {unfiltered}: single precision moves the center");
    }
}

#[test]
fn a_projection_set_up_is_that_of_a_splat() {
    let mut random = Random::new();
    for _ in 0..100 {
        let splat = random.splat();
        let (center, tangents) = crate::reference::projection::in_camera_space(&splat, &CAMERA);
        assert_eq!(Projection::new(&splat, &CAMERA), Ok(Projection::set_up(center, tangents, &CAMERA)));
    }
}
