use super::shapes::{SurfaceSample, Tube, plane, sphere};
use super::*;
use glam::DVec2;
use pointcore_golden::reference::{Footprint, Frame, Mapping, Projection, render};
use std::path::PathBuf;

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name)
}

fn load(text: &str, settings: &[&str]) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).expect("the folder is writable");
    let settings: Vec<_> = settings.iter().map(|setting| (*setting).to_owned()).collect();
    Scene::load(&path, &settings)
}

const SPHERE: &str = "camera = { eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 40, near = 1, far = 10 }\n\
                      image = { width = 64, height = 48 }\n\
                      [[object]]\nkind = \"sphere\"\npoints = 500\nouter_radius = 1\n";

/// Asserts that the scene, with `from` replaced by `to`, fails with a message that holds all of `parts`.
fn assert_fails(from: &str, to: &str, parts: &[&str]) {
    assert!(SPHERE.contains(from), "the test replaces nothing");
    let message = load(&SPHERE.replace(from, to), &[]).expect_err("the scene is bad").to_string();
    for part in parts.iter().chain(&["scene.toml"]) {
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
}

#[test]
fn example_scenes_load_and_cover_their_picture() {
    for (name, least_splats, least_share) in [
        ("knot.toml", 20_000, 0.3),
        ("shapes.toml", 50_000, 0.3),
        ("minified.toml", 50_000, 0.3),
        ("igea.toml", 134_345, 0.3),
    ] {
        if name == "igea.toml" && super::model::tests::shared("igea.ply").is_none() {
            continue;
        }
        let scene = Scene::load(&example(name), &[]).unwrap_or_else(|error| panic!("{error}"));
        assert!(scene.splats.len() >= least_splats, "{name}");
        let frame = render(&scene.splats, &scene.camera, &scene.rendering, Mapping::Backward);
        let covered = frame.pixels.iter().flatten().count() as f64 / frame.pixels.len() as f64;
        assert!((least_share..0.9).contains(&covered), "{name}: {covered} covered");
        assert_eq!(frame.statistics.outside_depth, 0, "{name}: near and far plane leave the objects alone");
        for fragment in frame.pixels.iter().flatten() {
            let finite = fragment.attributes.iter().all(|attribute| attribute.is_finite());
            assert!(finite && (0.0..=1.0).contains(&fragment.depth) && fragment.weight > 0.0, "{name}: {fragment:?}");
        }
        let picture = crate::shading::shade(&frame, &scene);
        assert!(picture.pixels.iter().flatten().all(|component| (0.0..=1.0).contains(component)), "{name}");
    }
}

#[test]
fn a_surface_leaves_no_holes() {
    let scene = Scene::load(&example("knot.toml"), &[]).unwrap_or_else(|error| panic!("{error}"));
    let frame = render(&scene.splats, &scene.camera, &scene.rendering, Mapping::Backward);
    let covered = |column: usize, row: usize| frame.pixels[row * frame.width + column].is_some();
    for row in 1..frame.height - 1 {
        for column in 1..frame.width - 1 {
            let around = covered(column - 1, row)
                && covered(column + 1, row)
                && covered(column, row - 1)
                && covered(column, row + 1);
            assert!(covered(column, row) || !around, "hole at ({column}, {row})");
        }
    }
}

#[test]
fn splats_are_discs_about_their_normal() {
    let scene = load(&format!("{SPHERE}radius = 0.25\nscale = 2\ntranslate = [1, 2, 3]\n"), &[]).expect("good");
    assert_eq!(scene.splats.len(), 500);
    for splat in &scene.splats {
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        let [first, second] = splat.tangents.map(vector);
        let normal = DVec3::from_slice(&splat.attributes[..3].iter().map(|&x| f64::from(x)).collect::<Vec<_>>());
        assert!((first.length() - 0.5).abs() < 1e-6 && (second.length() - 0.5).abs() < 1e-6);
        assert!(first.dot(second).abs() < 1e-6);
        assert!(first.cross(second).distance(0.25 * normal) < 1e-6);
        assert!((vector(splat.center) - DVec3::new(1.0, 2.0, 3.0)).distance(2.0 * normal) < 1e-5);
    }
}

#[test]
fn the_camera_puts_the_target_in_the_middle_and_up_above_it() {
    let camera = load(SPHERE, &[]).expect("the scene is good").camera;
    let project = |point: DVec3| {
        let [x, y, z] = camera.model_view.map(|row| DVec3::from_slice(&row).dot(point) + row[3]);
        let depth = camera.depth_a + camera.depth_b / z;
        (DVec2::new(camera.scale_x * x / z + camera.center_x, camera.scale_y * y / z + camera.center_y), depth)
    };
    assert_eq!(project(DVec3::ZERO).0, DVec2::new(32.0, 24.0));
    assert!(project(DVec3::Y).0.y < 24.0 && project(DVec3::X).0.x > 32.0, "y is up, x right");
    let top = 5.0 * 20_f64.to_radians().tan();
    assert!(project(DVec3::new(0.0, top, 0.0)).0.y.abs() < 1e-9, "the field of view is the vertical one");
    assert!(
        project(DVec3::new(0.0, 0.0, 4.0)).1.abs() < 1e-12
            && (project(DVec3::new(0.0, 0.0, -5.0)).1 - 1.0).abs() < 1e-12
    );
    let axes = camera.model_view.map(|row| DVec3::from_slice(&row));
    assert!((axes[0].cross(axes[1]).dot(axes[2]) - 1.0).abs() < 1e-12, "a rotation");
}

#[test]
fn settings_replace_values() {
    let scene = load(SPHERE, &["object.0.points=100", "image.width=80", "overrides.heap_levels=9"]).expect("good");
    assert_eq!((scene.splats.len(), scene.rendering.width), (100, 80));
    assert_eq!(scene.overrides["heap_levels"].as_integer(), Some(9));
    for (setting, part) in [
        ("object.1.points=100", "index below 1"),
        ("points", "key=value"),
        ("image.width.x=1", "`image.width` is no table"),
        ("object.0.kind.x.y=1", "below what is no table"),
        ("object.0.points=many", "a number of points or"),
        ("object.0.colour=red", "unknown field"),
        ("object.0.path=a b.ply", "belongs to `file`"),
    ] {
        let message = load(SPHERE, &[setting]).expect_err("the setting is bad").to_string();
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
}

#[test]
fn bad_scenes_are_named_with_their_key() {
    assert_fails("points = 500", "points = ", &["line 5"]);
    assert_fails("points = 500", "pionts = 500", &["line 5", "pionts"]);
    assert_fails("points = 500", "", &["object.0.points", "missing"]);
    assert_fails("points = 500", "points = 0", &["object.0.points", "1 to"]);
    assert_fails("points = 500", "points = 500\nsize = 3", &["object.0.size", "`plane`"]);
    assert_fails("points = 500", "points = 500\nradius = \"big\"", &["a number or"]);
    assert_fails("points = 500", "points = 500\nradius = -1", &["object.0.radius", "positive"]);
    assert_fails("points = 500", "points = 500\nradius = 1e-300", &["object.0.scale", "splat 0", "1e-300"]);
    assert_fails("points = 500", "points = 500\nscale = 1e9\nradius_scale = 1e9", &["object.0.scale", "splat 0"]);
    assert_fails("points = 500", "points = 4000001", &["object.0.points", "1 to 4000000"]);
    assert_fails("points = 500", "points = 500\nmaterial = 1", &["object.0.material", "below 1"]);
    assert_fails("points = 500", "points = 500\ncolor = [0, 0, 255]", &["object.0.color", "0 to 1"]);
    assert_fails("points = 500", "points = 500\nchecks = [2, 2]", &["checker_color"]);
    assert_fails("points = 500", "points = 1", &["spacing"]);
    assert_fails("outer_radius = 1", "outer_radius = nan", &["object.0.outer_radius", "positive"]);
    assert_fails("\"sphere\"", "\"cube\"", &["line 4", "cube", "torus_knot"]);
    assert_fails("target = [0, 0, 0]", "target = [0, 0, 5]", &["camera.target"]);
    assert_fails("target = [0, 0, 0]", "target = [0, 0, 0], up = [0, 0, 1]", &["camera.up"]);
    assert_fails("near = 1", "near = 0", &["camera.near"]);
    assert_fails("far = 10", "far = 1", &["camera.far"]);
    assert_fails("fov_degrees = 40", "fov_degrees = 180", &["camera.fov_degrees"]);
    assert_fails("fov_degrees = 40", "fov_degrees = 1e-300", &["camera.fov_degrees", "0.01 to 179"]);
    assert_fails("eye = [0, 0, 5]", "eye = [0, 0, 1e12]", &["camera.eye", "1e9"]);
    assert_fails("eye = [0, 0, 5]", "eye = [0, nan, 5]", &["camera.eye", "NaN"]);
    assert_fails("width = 64", "width = 0", &["image.width"]);
    assert_fails("[[object]]", "[splatting]\nepsilon_bias = -1\n[[object]]", &["splatting.epsilon_bias"]);
    assert_fails("[[object]]", "[splatting]\nkernel_gamma = 100\n[[object]]", &["splatting.kernel_gamma", "0.1 to 8"]);
    assert_fails("[[object]]", "[splatting]\nfilter_radius_px = 1e9\n[[object]]", &["splatting.filter_radius_px"]);
    assert_fails("[[object]]", "[[material]]\nspecular = nan\n[[object]]", &["material.0.specular", "0.0 to 1.0"]);
    assert_fails("[[object]]", "[[material]]\nshininess = -1\n[[object]]", &["material.0.shininess"]);
    assert_fails("[[object]]", "[light]\ndiffuse = inf\n[[object]]", &["light.diffuse"]);
    assert_fails("[[object]]", "[light]\ndirection = [0, 0, 0]\n[[object]]", &["light.direction"]);
    let absent = SPHERE.replace("\"sphere\"\npoints = 500\nouter_radius = 1", "\"file\"\npath = \"gone.ply\"");
    let message = load(&absent, &[]).expect_err("there is no such model").to_string();
    for part in ["scene.toml: `object.0.path`", "gone.ply, which cannot be read", "--set object.0.path="] {
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
    let message = Scene::load(Path::new("no/such.toml"), &[]).expect_err("there is no such file").to_string();
    assert!(message.contains("no/such.toml"), "{message}");
}

/// Asserts that samples are spread evenly: no spacing deviates from the mean by more than `factor`.
fn assert_even(samples: &[SurfaceSample], factor: f64) {
    let points: Vec<_> = samples.iter().map(|sample| sample.point).collect();
    let spacing = neighbors::spacing(&points).expect("the points are distinct");
    let mean = spacing.iter().sum::<f64>() / spacing.len() as f64;
    for (index, distance) in spacing.iter().enumerate() {
        assert!((mean / factor..mean * factor).contains(distance), "sample {index}: {distance}, mean {mean}");
    }
}

#[test]
fn shapes_are_even_and_their_normals_exact() {
    let ball = sphere(2000, 3.0);
    assert!(ball.iter().all(|sample| sample.point.distance(3.0 * sample.normal) < 1e-12));
    assert_even(&ball, 1.3);

    let knot = Tube { outer_radius: 2.0, knot_radius: 0.8, tube_radius: 0.3, windings: [2, 3] };
    let samples = knot.sample(6000);
    assert_even(&samples, 2.0);
    // An estimated normal needs no formula of the shape; on a fine sampling it is nearly exact.
    let estimated =
        normals::estimate(&samples.iter().map(|sample| sample.point).collect::<Vec<_>>()).expect("enough points");
    for (sample, estimated) in samples.iter().zip(estimated) {
        assert!(sample.normal.dot(estimated) > 0.97, "{sample:?}, estimated {estimated}");
    }

    let torus = Tube { outer_radius: 2.0, knot_radius: 0.0, tube_radius: 0.5, windings: [1, 0] };
    for SurfaceSample { point, .. } in torus.sample(1000) {
        let from_circle = DVec2::new(DVec2::new(point.x, point.y).length() - 2.0, point.z);
        assert!((from_circle.length() - 0.5).abs() < 1e-9);
    }

    let floor = plane(1000, 4.0);
    assert_eq!(floor.len(), 31 * 31);
    assert!(floor.iter().all(|sample| sample.normal == DVec3::Y && sample.point.abs().max_element() < 2.0));
}

#[test]
fn spacing_is_the_mean_distance_to_eleven_neighbors() {
    let line: Vec<_> = (0..30).map(|x| DVec3::new(f64::from(x), 0.0, 0.0)).collect();
    let spacing = neighbors::spacing(&line).expect("the points are distinct");
    // In the middle: five neighbors a side at 1 to 5, and one at 6; at the end: eleven at 1 to 11.
    assert!((spacing[15] - 36.0 / 11.0).abs() < 1e-12 && (spacing[0] - 6.0).abs() < 1e-12);
    let mut heap = vec![DVec3::ZERO; 13];
    heap.push(DVec3::X);
    assert!(neighbors::spacing(&heap).is_err_and(|problem| problem.contains("vertex 0")));
}

#[test]
fn more_samples_see_the_same_picture() {
    let one = load(SPHERE, &[]).expect("the scene is good");
    let four = load(SPHERE, &["image.samples=2"]).expect("the scene is good");
    assert_eq!((four.samples, four.rendering.width, four.rendering.height), (2, 128, 96));
    let frames = [&one, &four].map(|scene| render(&scene.splats, &scene.camera, &scene.rendering, Mapping::Backward));
    let depth = |frame: &Frame, column: usize, row: usize| {
        frame.pixels[row * frame.width + column].as_ref().map_or(1.0, |fragment| fragment.depth)
    };
    // A pixel's sample lies in the middle of its four.
    let around = [(64, 48), (65, 48), (64, 49), (65, 49)].map(|(column, row)| depth(&frames[1], column, row));
    assert!((around.iter().sum::<f64>() / 4.0 - depth(&frames[0], 32, 24)).abs() < 1e-3, "{around:?}");
    assert_fails("height = 48", "height = 48, samples = 9", &["`image.samples` is 9", "1 to 8"]);
    assert_fails("height = 48", "height = 48, sampling = \"grid\"", &["image", "`center` or `flipquad`"]);
    assert_fails(
        "height = 48",
        "height = 48, samples = 2, sampling = \"flipquad\"",
        &["`image.sampling`", "`image.samples` = 1"],
    );
    assert_fails("height = 48", "height = 4096, sampling = \"flipquad\"", &["130 by 4097", "2047 by 4095"]);
    assert_fails("height = 48", "height = 1000, samples = 8", &["8000 samples", "up to 4096"]);
}

#[test]
fn a_kernel_that_is_cut_off_is_the_same_where_it_is_left() {
    let [whole, cut] = [load(SPHERE, &[]), load(SPHERE, &["splatting.cutoff=0.5"])].map(|scene| scene.expect("good"));
    assert_eq!(cut.rendering.kernel_gamma, whole.rendering.kernel_gamma / 4.0);
    assert_eq!(cut.rendering.filter_radius_px, whole.rendering.filter_radius_px.map(|radius| radius / 2.0));
    let weight = |scene: &Scene, splat: usize| {
        let projection = Projection::new(&scene.splats[splat], &scene.camera).ok()?;
        let [column, row] = projection.center.map(|center| center as usize);
        Footprint::new(&projection, &scene.rendering, Mapping::Backward).ok()?.weight(column, row)
    };
    let pairs = (0..whole.splats.len()).filter_map(|splat| Some((weight(&whole, splat)?, weight(&cut, splat)?)));
    let pairs: Vec<_> = pairs.collect();
    assert!(pairs.len() > 100 && pairs.iter().all(|(a, b)| (a - b).abs() < 1e-5), "{pairs:?}");
    assert_fails(
        "[[object]]",
        "splatting = { cutoff = 3.0 }\n[[object]]",
        &["`splatting.cutoff` is 3.0", "0.25 to 2.0"],
    );
}

#[test]
fn a_scene_s_text_is_the_scene_wherever_it_lies() {
    let scene = example("plane.toml");
    let settings = ["image.samples=2".to_owned(), "overrides.geometry=f24".to_owned()];
    let text = Scene::text(&scene, &settings).unwrap_or_else(|error| panic!("{error}"));
    let (moved, original) = (load(&text, &[]), Scene::load(&scene, &settings));
    let [moved, original] = [moved, original].map(|scene| scene.unwrap_or_else(|error| panic!("{error}")));
    assert_eq!(format!("{moved:?}"), format!("{original:?}"));
    let igea = Scene::text(&example("igea.toml"), &[]).unwrap_or_else(|error| panic!("{error}"));
    let path = igea.lines().find_map(|line| line.strip_prefix("path = \"")).expect("its model is a file");
    assert!(path.starts_with('/') && path.ends_with("igea.ply\""), "{path}");
}

/// A floor of triangles below the sphere.
const FLOOR: &str = "[[object]]\nkind = \"plane\"\ndraw = \"triangles\"\nsize = 4\nchecks = [2, 3]\n\
                     checker_color = [0, 0, 0]\ntranslate = [0, -1, 0]\n";

#[test]
fn objects_of_triangles_stand_beside_those_of_splats() {
    let both_text = format!("{SPHERE}{FLOOR}");
    let both = load(&both_text, &[]).expect("the scene is good");
    let striped = load(&both_text.replace("[2, 3]", "[0, 3]"), &[]).expect("the scene is good");
    assert_eq!(striped.triangles.len(), 2 * 3, "no checks along an edge are one");
    assert_eq!((both.splats.len(), both.triangles.len()), (500, 2 * 2 * 3));
    let corners = both.triangles.iter().flat_map(|triangle| triangle.corners);
    assert!(corners.clone().all(|corner| corner.place.y == -1.0 && corner.normal == DVec3::Y));
    assert_eq!(corners.map(|corner| corner.place.x).fold(0.0, f64::max), 2.0);
    let message = |text: &str| load(text, &[]).expect_err("the scene is bad").to_string();
    let alone = format!("{}{FLOOR}", &SPHERE[..SPHERE.find("[[object]]").expect("there is one")]);
    let moves = "shutter = { open = 0, close = 1 }\n".to_owned()
        + &SPHERE.replace("outer_radius = 1", "outer_radius = 1\nmotion = { velocity = [1, 0, 0] }")
        + FLOOR;
    for (text, part) in [
        (alone, "`object` draws triangles alone"),
        (moves, "`object.1.draw` is \"triangles\", which go with scenes that stand still"),
        (format!("{SPHERE}{FLOOR}points = 9\n"), "`object.1.points` belongs to splats"),
        (both_text.replace("[2, 3]", "[100000, 100000]"), "`object.1.checks` make 20000000000 triangles"),
        (
            SPHERE.replace("points = 500", "draw = \"triangles\""),
            "`object.0.draw` is \"triangles\", which `file` and `plane` have",
        ),
        (SPHERE.replace("points = 500", "draw = \"lines\""), "`splats` or `triangles`"),
    ] {
        let message = message(&text);
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
}

#[test]
fn objects_may_be_surfaces_of_their_own() {
    let two = format!("{SPHERE}[[object]]\nkind = \"sphere\"\npoints = 300\nouter_radius = 0.5\n");
    let apart = format!("splatting = {{ surfaces = \"objects\" }}\n{two}{FLOOR}");
    assert_eq!(load(&apart, &[]).expect("the scene is good").surfaces, [0..500, 500..800]);
    assert!(!load(&two, &[]).expect("the scene is good").is_merged());
    let moves = apart.replace("outer_radius = 0.5", "outer_radius = 0.5\nmotion = { velocity = [1, 0, 0] }");
    let moves = format!("shutter = {{ open = 0, close = 1 }}\n{}", moves.replace(FLOOR, ""));
    let message = load(&moves, &[]).expect_err("the scene is bad").to_string();
    assert!(
        message.contains("`splatting.surfaces` is \"objects\", which goes with scenes that stand still"),
        "{message}"
    );
}

#[test]
fn a_camera_fits_triangles_too() {
    let text = format!(
        "{}{FLOOR}",
        SPHERE.replace("eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 40, near = 1, far = 10", "fit = true")
    );
    let [alone, both] = [&text[..text.rfind("[[object]]").expect("there are two")], &text].map(|text| load(text, &[]));
    let eye = |scene: Result<Scene, SceneError>| {
        let rows = scene.expect("the scene is good").camera.model_view;
        DVec3::from_array(rows.map(|row| row[3])).length()
    };
    let [alone, both] = [alone, both].map(eye);
    assert!(both > 1.3 * alone, "{alone} and {both} away");
}
