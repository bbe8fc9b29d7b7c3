//! Models without a scene file: whatever they are, something is to be seen.

use super::*;
use pointcore_golden::reference::{Mapping, render};
use std::fmt::Write as _;
use std::path::PathBuf;

/// A model's file in a folder that lives as long as the test.
fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).expect("the folder is writable");
    path
}

fn loaded(path: &Path, settings: &[&str]) -> Scene {
    let settings: Vec<_> = settings.iter().map(|setting| (*setting).to_owned()).collect();
    Scene::load(path, &settings).unwrap_or_else(|error| panic!("{error}"))
}

/// The share of the image that is covered; asserts that all splats are before the camera, and that nothing reaches the image's edge.
fn covered(scene: &Scene) -> f64 {
    let frame = render(&scene.splats, &scene.camera, &scene.rendering, Mapping::Backward);
    let figures = frame.statistics;
    assert_eq!((figures.outside_depth, figures.outside_viewport), (0, 0), "{figures:?}");
    let is_edge = |index: usize| {
        let (column, row) = (index % frame.width, index / frame.width);
        column == 0 || row == 0 || column == frame.width - 1 || row == frame.height - 1
    };
    assert!(!frame.pixels.iter().enumerate().any(|(index, pixel)| pixel.is_some() && is_edge(index)), "cut off");
    frame.pixels.iter().flatten().count() as f64 / frame.pixels.len() as f64
}

/// Points of a wavy square, as columns of text.
fn terrain(origin: [f64; 3], size: f64) -> String {
    let mut text = String::new();
    for index in 0..1600 {
        let (x, y) = (f64::from(index % 40) / 40.0, f64::from(index / 40) / 40.0);
        let z = 0.05 * (7.0 * x).sin() * (5.0 * y).cos();
        let [x, y, z] = [origin[0] + size * x, origin[1] + size * y, origin[2] + size * z];
        _ = writeln!(text, "{x:e} {y:e} {z:e}");
    }
    text
}

#[test]
fn models_of_any_place_size_and_kind_are_seen_whole() {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let line: String = (0..50).map(|x| format!("{x} 0 0\n")).collect();
    let cube = "v 0 0 0\nv 0 0 1\nv 0 1 0\nv 0 1 1\nv 1 0 0\nv 1 0 1\nv 1 1 0\nv 1 1 1\nf 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\n\
                f 1 3 7 5\nf 2 6 8 4\n";
    for (name, text, least) in [
        ("usual.xyz", terrain([0.0; 3], 1.0), 0.2),
        ("georeferenced.xyz", terrain([500_000.0, 5_000_000.0, 120.0], 50.0), 0.2),
        ("tiny.xyz", terrain([0.0; 3], 1e-6), 0.2),
        ("huge.xyz", terrain([0.0; 3], 1e8), 0.2),
        (
            "flat.xyz",
            terrain([0.0; 3], 1.0)
                .lines()
                .map(|line| line.rsplit_once(' ').map_or(String::new(), |(xy, _)| format!("{xy} 3\n")))
                .collect(),
            0.2,
        ),
        ("line.xyz", line, 0.01),
        ("two.xyz", "0 0 0\n1 0 0\n".to_owned(), 0.05),
        ("point.xyz", "500000 5000000 7\n".to_owned(), 0.3),
        ("repeated.xyz", "1 2 3\n".repeat(500), 0.3),
        ("invalid.xyz", terrain([0.0; 3], 1.0) + "nan 0 0\n", 0.2),
        ("cube.obj", cube.to_owned(), 0.3),
    ] {
        let scene = loaded(&file(&folder, name, &text), &["image.width=96", "image.height=64"]);
        let share = covered(&scene);
        println!("{name}: {share:.2} covered, {:?}", scene.notes);
        assert!(share > least, "{name}: {share} covered");
    }
}

#[test]
fn what_was_done_to_a_model_is_said() {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let notes = |name: &str, text: &str| {
        loaded(&file(&folder, name, text), &["image.width=32", "image.height=32"]).notes.join("\n")
    };
    assert_eq!(notes("good.xyz", &terrain([0.0; 3], 1.0)), "");
    assert!(notes("invalid.xyz", "0 0 0\nnan 0 0\n1 0 0\n").contains("invalid.xyz: 1 points are no numbers"));
    assert!(notes("repeated.xyz", &"1 2 3\n".repeat(5)).contains("4 of 5 points are the same"));
    assert!(notes("line.xyz", "0 0 0\n1 0 0\n2 0 0\n").contains("3 of 3 points span no surface"));
    assert!(notes("stray.xyz", &(terrain([0.0; 3], 1.0) + "9 9 9\n")).contains("1 points lie 4 times farther apart"));
    let corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    assert!(notes("corner.obj", corner).contains("`--set object.0.points=COUNT` says another number"));
    let sphere = "[[object]]\nkind = \"sphere\"\npoints = 50\nouter_radius = 1\n";
    let file_object = "[[object]]\nkind = \"file\"\npath = \"corner.obj\"\npoints = 90\n";
    let scene = format!("camera = {{ fit = true }}\nimage = {{ width = 32, height = 32 }}\n{sphere}{file_object}");
    let said = loaded(&file(&folder, "second.toml", &scene), &[]).notes.join("\n");
    assert!(said.contains("drawn: `object.1.points` says another number"), "{said}");
    // Random directions around a center have no surface, and so no side.
    let mut random = fastrand::Rng::with_seed(1);
    let mut cloud = String::new();
    for _ in 0..3000 {
        let [x, y, z] = [(); 3].map(|()| random.f64());
        _ = writeln!(cloud, "{x} {y} {z}");
    }
    assert!(notes("cloud.xyz", &cloud).contains("point to the other side than their neighbors"));
}

#[test]
fn estimated_normals_may_point_to_the_sensor_or_to_both_sides() {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let path = file(&folder, "terrain.xyz", &terrain([0.0; 3], 1.0));
    let facing = |settings: &[&str]| {
        let mut all = vec!["image.width=32", "image.height=32", "camera.from=[0,0,-1]"];
        all.extend(settings);
        let scene = loaded(&path, &all);
        render(&scene.splats, &scene.camera, &scene.rendering, Mapping::Backward).statistics.back_facing
    };
    assert_eq!(facing(&["object.0.two_sided=false"]), 1600, "the tree points upwards");
    assert_eq!(
        facing(&["object.0.two_sided=false", "object.0.orient=viewpoint", "object.0.viewpoint=[0.5,0.5,-5]"]),
        0
    );
    assert_eq!(facing(&[]), 0, "both sides, where normals are estimated");
    let error =
        Scene::load(&path, &["object.0.orient=viewpoint".to_owned()]).expect_err("no sensor is known").to_string();
    assert!(error.contains("viewpoint = [x, y, z]"), "{error}");
}

#[test]
fn elliptic_splats_follow_the_spread_of_the_points() {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    // Scan lines: three times as dense along x as along y.
    let text: String = (0..2400).map(|i| format!("{} {} 0\n", f64::from(i % 80) / 3.0, i / 80)).collect();
    let scene = loaded(&file(&folder, "lines.xyz", &text), &["object.0.radius=elliptic", "camera.from=[0,0,1]"]);
    let lengths = |splat: &Splat| splat.tangents.map(|tangent| tangent.iter().map(|x| x * x).sum::<f32>().sqrt());
    let middle =
        scene.splats.iter().find(|splat| splat.center[0] > 12.0 && splat.center[1] == 15.0).expect("there is one");
    let [major, minor] = lengths(middle);
    assert!(major / minor > 1.05 && major / minor < 8.0, "{major} by {minor}");
    assert!(covered(&scene) > 0.3);
    // Evenly spread points have circles.
    let round = loaded(&file(&folder, "even.xyz", &terrain([0.0; 3], 1.0)), &["object.0.radius=elliptic"]);
    let [major, minor] = lengths(&round.splats[20 * 40 + 20]);
    assert!(major / minor < 1.3, "{major} by {minor}");
}

#[test]
fn sequences_move_camera_light_and_turning_splats() {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let path = file(&folder, "terrain.xyz", &terrain([0.0; 3], 1.0));
    let mut scene =
        loaded(&path, &["camera.turntable=4", "image.width=48", "image.height=48", "camera.from=[0,-1,0.1]"]);
    assert_eq!(scene.views.len(), 4);
    let light = scene.light.clone();
    for view in scene.views.clone() {
        scene.look(&view);
        assert!(covered(&scene) > 0.02);
    }
    let bar: String = (0..80).map(|x| format!("{} 0 {}\n", x / 2, x % 2)).collect();
    let mut bar =
        loaded(&file(&folder, "bar.xyz", &bar), &["camera.turntable=5", "camera.from=[1,0.2,0.1]", "image.width=64"]);
    for view in bar.views.clone() {
        bar.look(&view);
        assert!(covered(&bar) > 0.0, "seen whole from its end and from its side");
    }
    assert_ne!(scene.light, light, "it comes over the shoulder of who looks");
    let keyframes = "camera.keyframe=[{ eye = [0, 0, 5] }, { eye = [4, 0, 3] }, { eye = [0, 0, 2], fov_degrees = 50 }]";
    let text = super::settings::model_scene(&path).expect("the model is there").replace("fit = true", "frames = 5");
    let scene = loaded(&file(&folder, "path.toml", &text), &[keyframes]);
    let eyes: Vec<f64> = scene.views.iter().map(|view| view.camera.model_view[2][3]).collect();
    assert!(
        eyes.len() == 5 && (eyes[0] - 5.0).abs() < 1e-9 && (eyes[2] - 5.0).abs() < 1e-9 && (eyes[4] - 2.0).abs() < 1e-9
    );
    assert!(scene.views[4].camera.scale_y < scene.views[0].camera.scale_y, "a wider angle");
}

#[test]
fn alternatives_exclude_each_other() {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let path = file(&folder, "point.xyz", "0 0 0\n");
    for (setting, part) in [
        ("camera.eye=[0,0,1]", "`camera.eye` goes without `fit`"),
        ("camera.fit=false", "`camera.eye` is missing"),
        ("camera.frames=5", "two keyframes"),
        ("camera.turntable=0", "1 to 2000"),
        ("camera.up=[0,0,nan]", "camera.up"),
        ("light.direction=sun", "\"camera\""),
        ("object.0.points=0", "1 to 4000000"),
        ("object.0.two_sided=maybe", "\"estimated\""),
    ] {
        let message = Scene::load(&path, &[setting.to_owned()]).expect_err("the setting is bad").to_string();
        assert!(message.contains(part), "{setting}: {message}");
    }
    let gone = Scene::load(Path::new("gone.ply"), &[]).expect_err("there is no such file").to_string();
    assert!(gone.contains("gone.ply: cannot be read"), "{gone}");
}
