use super::quadrature::{self, STEP};
use super::*;
use crate::reference::Bounds;
use crate::reference::{Mapping, Projection, render};
use pointcore_contract::{FragmentDepth, Sampling};

const CAMERA: Camera = Camera {
    model_view: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
    scale_x: 50.0,
    scale_y: 60.0,
    center_x: 16.0,
    center_y: 15.0,
    depth_a: 100.0 / 99.0,
    depth_b: -100.0 / 99.0,
    near: 1.0,
};

const RENDERING: Rendering = Rendering {
    width: 32,
    height: 30,
    sampling: Sampling::Center,
    depth: FragmentDepth::Center,
    kernel_gamma: Rendering::DEFAULT_KERNEL_GAMMA,
    filter_radius_px: Some(Rendering::DEFAULT_FILTER_RADIUS_PX),
    epsilon_scale: Rendering::DEFAULT_EPSILON_SCALE,
    epsilon_bias: 0.01,
};

const UNFILTERED: Rendering = Rendering { filter_radius_px: None, ..RENDERING };

/// What a closed form may be off from numbers.
const BOUND: f64 = 1.0 / 65536.0;

const METHODS: [Method; 7] = [
    Method::Exact,
    Method::Bins(1),
    Method::Bins(2),
    Method::Bins(8),
    Method::Passes(1),
    Method::Passes(2),
    Method::Passes(8),
];

/// A source of numbers, whose seed `POINTCORE_SEED` replaces.
struct Random(fastrand::Rng);

impl Random {
    fn new() -> Self {
        let seed = std::env::var("POINTCORE_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1_u64);
        println!("reproduce with POINTCORE_SEED={seed} cargo test -p pointcore-golden reference::motion");
        Self(fastrand::Rng::with_seed(seed))
    }

    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.f64()
    }

    fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::new(self.uniform(-size, size), self.uniform(-size, size), self.uniform(-size, size))
    }

    /// A splat between near and far plane that faces the eye well enough, somewhere before the image.
    fn splat(&mut self) -> Splat {
        let z = self.uniform(3.0, 20.0);
        let size = z * self.uniform(0.02, 0.2);
        let center = DVec3::new(self.uniform(-0.3, 0.3) * z, self.uniform(-0.25, 0.25) * z, z);
        loop {
            let tangents = [self.vector(size), self.vector(size)];
            let normal = tangents[0].cross(tangents[1]);
            if normal.length() > 0.2 * size * size && normal.dot(center) < -0.3 * normal.length() * center.length() {
                return splat(center, tangents, [self.uniform(0.0, 1.0) as f32; 3]);
            }
        }
    }

    fn moving(&mut self, speed: f64) -> MovingSplat {
        let splat = self.splat();
        let motion = self.vector(speed * f64::from(splat.center[2]));
        MovingSplat { splat, motion, part: Interval::EXPOSURE }
    }

    /// A place near the way of the splat's center.
    fn place_near(&mut self, moving: &MovingSplat) -> Place {
        let center = DVec3::from_array(moving.splat.center.map(f64::from)) + self.uniform(-1.0, 1.0) * moving.motion;
        let near = |along: f64, size: usize| (along.max(0.0) as usize).min(size - 1);
        let x = CAMERA.scale_x * center.x / center.z + CAMERA.center_x + self.uniform(-2.0, 2.0);
        let y = CAMERA.scale_y * center.y / center.z + CAMERA.center_y + self.uniform(-2.0, 2.0);
        Place::new(near(x, RENDERING.width), near(y, RENDERING.height), &RENDERING)
    }

    fn shutter(&mut self) -> Shutter {
        if self.0.bool() { Shutter::Box } else { Shutter::Gaussian }
    }
}

fn splat(center: DVec3, tangents: [DVec3; 2], color: [f32; 3]) -> Splat {
    let single = |vector: DVec3| vector.as_vec3().to_array();
    let [red, green, blue] = color;
    Splat {
        center: single(center),
        tangents: tangents.map(single),
        attributes: [0.0, 0.0, -1.0, red, green, blue],
        material: 0,
    }
}

/// A disc that faces the eye squarely.
fn facing(center: DVec3, radius: f64, color: [f32; 3]) -> Splat {
    splat(center, [DVec3::Y * radius, DVec3::X * radius], color)
}

fn color(fragment: &Fragment, _: [f64; 2]) -> [f64; 3] {
    [fragment.attributes[3], fragment.attributes[4], fragment.attributes[5]]
}

fn exposed(splats: &[MovingSplat], method: Method, shutter: Shutter) -> Exposure {
    let (camera, rendering) = (&CAMERA, &RENDERING);
    expose(splats, method, &Setting { camera, rendering, shutter, shade: &color, row_done: &|| () })
}

/// The mean of still frames.
fn truth(splats: &[MovingSplat], count: usize) -> Exposure {
    let mut exposure = Exposure::dark(&RENDERING);
    for part in Interval::equal_parts(count) {
        let at = |moving: &MovingSplat| {
            let way = (part.middle() - moving.part.middle()) * moving.motion;
            let center = (DVec3::from_array(moving.splat.center.map(f64::from)) + way).as_vec3().to_array();
            moving.part.contains(part.middle()).then(|| Splat { center, ..moving.splat.clone() })
        };
        let there: Vec<_> = splats.iter().filter_map(at).collect();
        exposure.add(&render(&there, &CAMERA, &RENDERING, Mapping::Backward), 0.5 * part.length(), &RENDERING, &color);
    }
    exposure
}

/// Mean absolute difference of light and coverage.
fn difference(a: &Exposure, b: &Exposure) -> f64 {
    let of_sample = |(a, b): (&Exposed, &Exposed)| {
        let light: f64 = a.light.iter().zip(&b.light).map(|(a, b)| (a - b).abs()).sum();
        light + (a.coverage - b.coverage).abs()
    };
    a.samples.iter().zip(&b.samples).map(of_sample).sum::<f64>() / a.samples.len() as f64
}

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
fn what_stands_still_is_the_static_frame() {
    let mut random = Random::new();
    let splats: Vec<_> = (0..300).map(|_| random.splat()).collect();
    let frame = render(&splats, &CAMERA, &RENDERING, Mapping::Backward);
    let mut expected = Exposure::dark(&RENDERING);
    expected.add(&frame, 1.0, &RENDERING, &color);
    let still: Vec<_> = splats.into_iter().map(MovingSplat::still).collect();
    for method in METHODS {
        assert!(exposed(&still, method, Shutter::Box) == expected, "{method} differs, if only by a bit");
        assert!(difference(&exposed(&still, method, Shutter::Gaussian), &expected) < 1e-12, "{method}");
    }
    assert!(frame.statistics.inside > 1000);
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

/// A red sheet that flies before a green one that comes the other way.
fn sheets() -> Vec<MovingSplat> {
    let mut splats = Vec::new();
    for index in 0..64 {
        let at = |z: f64| DVec3::new(f64::from(index % 8) * 0.35 - 1.2, f64::from(index / 8) * 0.35 - 1.2, z);
        let splat = facing(at(8.0), 0.3, [0.0, 1.0, 0.0]);
        splats.push(MovingSplat { splat, motion: DVec3::X * -1.1, part: Interval::EXPOSURE });
        if index % 8 < 3 {
            let motion = DVec3::new(0.9, 0.2, 0.0);
            let splat = facing(at(5.0) * DVec3::new(0.6, 0.6, 1.0), 0.2, [1.0, 0.0, 0.0]);
            splats.push(MovingSplat { splat, motion, part: Interval::EXPOSURE });
        }
    }
    splats
}

#[test]
fn methods_approach_the_truth() {
    let splats = sheets();
    let truth = truth(&splats, 256);
    let error = |method| difference(&exposed(&splats, method, Shutter::Box), &truth);
    let exact = error(Method::Exact);
    // The truth errs by up to half of its step at each of the four edges that pass a sample.
    assert!(exact < 4.0 * 0.5 / 256.0, "{exact}");
    let bins: Vec<_> = [1, 2, 4, 8, 16].map(|count| error(Method::Bins(count))).to_vec();
    assert!(bins.windows(2).all(|pair| pair[1] < pair[0]), "{bins:?} fall");
    assert!(bins[4] < 0.2 * bins[0]);
}

#[test]
fn surfaces_that_change_places_are_cut_where_they_do() {
    // Red comes nearer, green goes farther: they meet in the middle.
    let disc = |motion: f64, color| {
        let splat = facing(DVec3::new(0.0, 0.0, 6.0), 4.0, color);
        MovingSplat { splat, motion: DVec3::Z * motion, part: Interval::EXPOSURE }
    };
    let exposure = exposed(&[disc(-2.0, [1.0, 0.0, 0.0]), disc(2.0, [0.0, 1.0, 0.0])], Method::Exact, Shutter::Box);
    let middle = exposure.samples[15 * RENDERING.width + 16];
    // Of the time for which they are one surface within ε, some is of the mean of both.
    let [red, green, _] = middle.light;
    assert!((middle.coverage - 1.0).abs() < 1e-9 && (red - 0.5).abs() < 0.1 && (red + green - 1.0).abs() < 1e-9);
    assert!(
        (exposed(&[disc(-2.0, [1.0, 0.0, 0.0])], Method::Exact, Shutter::Box).samples[0].coverage - 1.0).abs() < 1e-9
    );
}

#[test]
fn bins_and_exact_see_what_is_there_at_both_ends_only() {
    // A disc covers the middle in the first tenth of the exposure, another one in the last.
    let disc = |begin: f64, end: f64| {
        let splat = facing(DVec3::new(0.0, 0.0, 6.0), 2.0, [1.0; 3]);
        MovingSplat { splat, motion: DVec3::X * 1e-6, part: Interval { begin, end } }
    };
    let splats = [disc(-1.0, -0.8), disc(0.8, 1.0)];
    let coverage = |method| exposed(&splats, method, Shutter::Box).samples[15 * RENDERING.width + 16].coverage;
    assert!((coverage(Method::Exact) - 0.2).abs() < 1e-9);
    assert!((coverage(Method::Bins(2)) - 0.2).abs() < 1e-9 && (coverage(Method::Bins(8)) - 0.2).abs() < 1e-9);
    assert!((coverage(Method::Passes(1)) - 1.0).abs() < 1e-9, "the earliest and the latest time are all it knows");
}

#[test]
fn a_splat_is_seen_while_it_faces_the_eye() {
    // A disc whose plane holds the eye at τ = 0: before, it faces it.
    let tilted = splat(DVec3::new(0.0, 0.0, 6.0), [DVec3::Y, DVec3::Z], [1.0; 3]);
    let moving = MovingSplat { splat: tilted, motion: DVec3::X, part: Interval::EXPOSURE };
    let exposure = exposed(&[moving.clone()], Method::Exact, Shutter::Box);
    let expected = truth(&[moving], 256);
    assert!(difference(&exposure, &expected) < 2e-3, "{}", difference(&exposure, &expected));
    assert!(expected.samples.iter().any(|sample| sample.coverage > 0.0));
}

#[test]
fn methods_are_written_as_they_are_read() {
    for method in METHODS {
        assert_eq!(method.to_string().parse(), Ok(method));
    }
    assert_eq!("gpu".parse(), Ok(Method::Passes(1)));
    for text in ["", "bins", "bins:0", "bins:65", "bins:x", "exact:2", "gpu:", "GPU"] {
        assert_eq!(text.parse::<Method>(), Err(UnknownMethod(text.to_owned())), "{text}");
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
