//! Shipped scenes are what they are there for.

use super::Scene;
use crate::plan::Plan;
use crate::splat::{EncodedFrame, Fates, reference};
use pointcore_contract::Splat;
use pointcore_golden::reference::{Frame, Mapping, render};
use std::path::Path;

/// A scene of `scenes/` and its frame in f64.
fn rendered(name: &str) -> (Scene, Frame) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name).with_extension("toml");
    let scene = Scene::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
    let frame = render(&scene.splats, &scene.camera, &scene.rendering, Mapping::Backward);
    (scene, frame)
}

#[test]
fn inside_of_a_model_splats_reach_behind_the_eye() {
    let (scene, frame) = rendered("inside");
    let statistics = frame.statistics;
    assert!(statistics.crossing > 5 && statistics.samples > 2 * statistics.inside, "{statistics:?}");
    let crosses = |plane: f64| {
        let [x, y, z, offset] = scene.camera.model_view[2];
        let along = |vector: [f32; 3]| x * f64::from(vector[0]) + y * f64::from(vector[1]) + z * f64::from(vector[2]);
        let reaches = |splat: &&Splat| {
            let [first, second] = splat.tangents.map(along);
            (along(splat.center) + offset - plane).abs() < first.hypot(second)
        };
        scene.splats.iter().filter(reaches).count()
    };
    assert!(crosses(0.0) > 20 && crosses(scene.camera.near) > 20, "{} {}", crosses(0.0), crosses(scene.camera.near));
}

#[test]
fn triangles_hide_a_third_of_a_knot() {
    let (scene, frame) = rendered("triangles");
    let all = frame.pixels.iter().flatten().count() as f64;
    let seen = reference(&scene, Mapping::Backward).pixels.iter().flatten().count() as f64;
    assert!((0.5..0.75).contains(&(seen / all)), "{seen} of {all}");
}

#[test]
fn dense_splats_lie_a_hundred_deep() {
    let (_, frame) = rendered("dense");
    let overdraw = frame.statistics.inside as f64 / frame.pixels.iter().flatten().count() as f64;
    assert!((90.0..110.0).contains(&overdraw), "{overdraw}");
}

/// Splats, coverage in percent, overdraw, samples a splat, and attributes of the thesis' table 5.3. Coverage is that of FLIPQUAD's samples,
/// overdraw counts samples inside their splat for each of these, and samples a splat those for each that is drawn.
#[test]
fn scenes_of_table_5_3_have_its_statistics() {
    const TOLERANCE: f64 = 0.01;
    for (name, splats, expected, attributes) in [
        ("bench/table53_1", 101_685, [31.2, 6.8, 19.36], 14),
        ("bench/table53_2", 101_685, [1.3, 27.7, 3.5], 3),
        ("bench/table53_3", 465_878, [43.5, 17.6, 12.6], 6),
    ] {
        let (scene, frame) = rendered(name);
        let covered = frame.pixels.iter().flatten().count() as f64;
        let plan = Plan::of(&scene).unwrap_or_else(|error| panic!("{error}"));
        let drawn = Fates::of(&plan.config, &EncodedFrame::new(&scene, &plan)).drawn as f64;
        let inside = frame.statistics.inside as f64;
        let found = [100.0 * covered / frame.pixels.len() as f64, inside / covered, inside / drawn];
        let is_near = |(found, expected): (&f64, &f64)| (found / expected - 1.0).abs() < TOLERANCE;
        assert!(found.iter().zip(&expected).all(is_near), "{name}: {found:?}");
        assert_eq!((scene.splats.len(), plan.config.continuous), (splats, attributes), "{name}");
    }
}
