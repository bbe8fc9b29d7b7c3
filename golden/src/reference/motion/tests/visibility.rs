//! What hides what, beside the mean of still frames.

use super::*;
use crate::reference::{Mapping, render};

const METHODS: [Method; 7] = [
    Method::Exact,
    Method::Bins(1),
    Method::Bins(2),
    Method::Bins(8),
    Method::Passes(1),
    Method::Passes(2),
    Method::Passes(8),
];

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
    assert!((coverage(Method::Bins(1)) - 0.25).abs() < 1e-9, "two of the bin's sixteen parts at either end");
    assert!((coverage(Method::Passes(1)) - 1.0).abs() < 1e-9, "the earliest and the latest time are all it knows");
}

#[test]
fn a_splat_is_seen_while_it_faces_the_eye() {
    // A disc whose plane holds the eye at τ = 0: before, it faces it.
    let tilted = splat(DVec3::new(0.0, 0.0, 6.0), [DVec3::Y, DVec3::Z], [1.0; 3]);
    let moving = MovingSplat { splat: tilted, motion: DVec3::X, part: Interval::EXPOSURE };
    let exposure = exposed(std::slice::from_ref(&moving), Method::Exact, Shutter::Box);
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
