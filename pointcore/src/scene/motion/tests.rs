use super::*;
use crate::exposure::{by_method, by_samples};
use crate::plan::{Plan, PlanError};
use crate::scene::SceneError;
use crate::shading;
use pointcore_golden::reference::motion::Interval;
use std::path::Path as FilePath;

const STILL: &str = "[image]\nwidth = 64\nheight = 64\nbackground = [0.6, 0.7, 0.8]\n\
                     [[object]]\nkind = \"sphere\"\npoints = 600\nouter_radius = 1\ntranslate = [0.2, 0.0, 0.0]\n";
const CAMERA: &str = "[camera]\neye = [0, 0, 6]\ntarget = [0, 0, 0]\nfov_degrees = 40\nnear = 2\nfar = 12\n";
const SHUTTER: &str = "[shutter]\nopen = 0.0\nclose = 1.0\n";
const TURN: &str = "[[object.motion.keyframe]]\ntime = 0\n[[object.motion.keyframe]]\ntime = 1\n\
                    translate = [0.5, 0.0, 0.5]\nrotate_degrees = [0, 90, 30]\n";

fn load(text: &str) -> Result<Scene, SceneError> {
    let folder = tempfile::tempdir().expect("the system has a temporary folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).expect("the folder is writable");
    Scene::load(&path, &[])
}

fn good(parts: &[&str]) -> Scene {
    load(&parts.concat()).unwrap_or_else(|error| panic!("{error}"))
}

/// Where a point of splats' coordinates is for a camera.
fn seen(camera: &Camera, point: DVec3) -> DVec3 {
    DVec3::from_array(camera.model_view.map(|row| DVec3::from_slice(&row).dot(point) + row[3]))
}

/// The largest distance on the screen, in pixels, of a splat on its straight parts from where it is.
fn distance_px(scene: &Scene, tau: f64) -> f64 {
    let (splats, camera) = scene.at(tau);
    let parts = scene.moving_splats();
    let at_tau: Vec<_> = parts.iter().filter(|moving| moving.part.contains(tau)).collect();
    assert_eq!(at_tau.len(), splats.len(), "a part a splat at every time but their borders");
    let distance = |(moving, splat): (&&MovingSplat, &Splat)| {
        let center = vector(&moving.splat.center) + (tau - moving.part.middle()) * moving.motion;
        let [parted, true_place] = [seen(&scene.camera, center), seen(&camera, vector(&splat.center))];
        camera.scale_x * (parted / parted.z - true_place / true_place.z).length()
    };
    at_tau.iter().zip(&splats).map(distance).fold(0.0, f64::max)
}

#[test]
fn a_scene_where_nothing_moves_is_the_scene_it_was() {
    let still = good(&[CAMERA, STILL]);
    assert!(still.motion.is_none());
    let rests = "[[object.motion.keyframe]]\ntime = -1\n[[object.motion.keyframe]]\ntime = 0\n\
                 [[object.motion.keyframe]]\ntime = 1\n[[object.motion.keyframe]]\ntime = 2\ntranslate = [1, 0, 0]\n";
    for also_still in [
        good(&[CAMERA, SHUTTER, STILL]),
        good(&[CAMERA, SHUTTER, STILL, "motion = { velocity = [0, 0, 0] }\n"]),
        good(&[CAMERA, SHUTTER, STILL, rests]),
    ] {
        assert!(also_still.motion.is_none());
        assert!(also_still.splats == still.splats && also_still.camera == still.camera, "bit for bit");
        assert_eq!(also_still.views, still.views);
        assert!(Plan::of(&also_still).is_ok());
    }
}

#[test]
fn straight_ways_are_one_part_and_curves_are_cut() {
    let straight = good(&[CAMERA, SHUTTER, STILL, "motion = { velocity = [1.5, 0.2, 0.0] }\n"]);
    assert_eq!(straight.moving_splats().len(), straight.splats.len());
    let turning = good(&[CAMERA, SHUTTER, STILL, TURN]);
    assert!(turning.moving_splats().len() > 3 * turning.splats.len());
    for tau in [-0.99, -0.61, -0.3, 0.013, 0.49, 0.83] {
        assert!(distance_px(&straight, tau) < 1e-3, "single precision is all that it errs by");
        // The chord's own limit, and somewhat more where the distance from the eye changes.
        assert!(distance_px(&turning, tau) < 0.3, "{}", distance_px(&turning, tau));
    }
}

#[test]
fn a_camera_that_moves_is_a_world_that_moves_the_other_way() {
    let camera = CAMERA.to_owned() + "motion = { velocity = [0.6, -0.2, 0.4] }\n";
    let moving_camera = good(&[&camera, SHUTTER, STILL]);
    let moving_object = good(&[CAMERA, SHUTTER, STILL, "motion = { velocity = [-0.6, 0.2, -0.4] }\n"]);
    for tau in [-1.0_f64, -0.4, 0.0, 0.7] {
        assert!(distance_px(&moving_camera, tau.clamp(-0.999, 0.999)) < 1e-3);
        let place = |scene: &Scene, index: usize| {
            let (splats, camera) = scene.at(tau);
            seen(&camera, vector(&splats[index].center))
        };
        for index in [0, 99, 300] {
            assert!(place(&moving_camera, index).distance(place(&moving_object, index)) < 1e-5);
        }
    }
    let turning = CAMERA.to_owned()
        + "[[camera.motion.keyframe]]\ntime = 0\n[[camera.motion.keyframe]]\ntime = 1\nrotate_degrees = [0, 6, 0]\n";
    let turning = good(&[&turning, SHUTTER, STILL]);
    for tau in [-0.9, -0.2, 0.55] {
        assert!(distance_px(&turning, tau) < 0.3, "{}", distance_px(&turning, tau));
    }
    let eyes = [-1.0, 1.0].map(|tau| eye(&turning.at(tau).1));
    assert!(eyes[0].distance(eyes[1]) < 1e-9, "it turns about its eye");
}

#[test]
fn a_camera_that_fits_sees_the_whole_way() {
    let fit = "[camera]\nfit = true\nfrom = [0, 0, 1]\n";
    let scene = good(&[fit, SHUTTER, STILL, "motion = { velocity = [4, 0, 1] }\n"]);
    for tau in [-1.0, 0.0, 1.0] {
        let (splats, camera) = scene.at(tau);
        for splat in &splats {
            let place = seen(&camera, vector(&splat.center));
            let x = camera.scale_x * place.x / place.z + camera.center_x;
            let depth = camera.depth_a + camera.depth_b / place.z;
            assert!((0.0..64.0).contains(&x) && (0.0..1.0).contains(&depth), "{x}, {depth} at {tau}");
        }
    }
}

#[test]
fn exact_pictures_of_shipped_scenes_are_near_the_truth() {
    let settings = ["image.width=64", "image.height=64"].map(str::to_owned);
    for (name, least_db) in [("translation", 40.0), ("rotation", 35.0), ("uncover", 45.0), ("ends", 40.0)] {
        let path = FilePath::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/motion").join(name).with_extension("toml");
        let mut settings = settings.to_vec();
        let objects = match name {
            "translation" | "rotation" => 1,
            "uncover" => 4,
            _ => 3,
        };
        settings.extend((0..objects).map(|index| format!("object.{index}.points=1200")));
        let scene = Scene::load(&path, &settings).unwrap_or_else(|error| panic!("{error}"));
        let truth = shading::exposed(&by_samples(&scene, 64, &|| ()), &scene);
        let psnr_db = |method| {
            shading::exposed(&by_method(&scene, &scene.moving_splats(), method, &|| ()), &scene).psnr_db(&truth)
        };
        assert!(psnr_db(Method::Exact) > least_db, "{name}: {}", psnr_db(Method::Exact));
        assert!(psnr_db(Method::Bins(8)) > psnr_db(Method::Bins(1)), "{name}");
    }
}

#[test]
fn the_shutter_is_open_when_it_says() {
    let moving = |shutter: &str| good(&[CAMERA, shutter, STILL, "motion = { velocity = [1, 0, 0] }\n"]);
    let scene = moving("[shutter]\nopen = 2.0\nclose = 3.0\nshape = \"gaussian\"\n");
    let still = good(&[CAMERA, STILL]);
    for (tau, way) in [(-1.0, 2.0), (0.0, 2.5), (1.0, 3.0)] {
        let offset = vector(&scene.at(tau).0[7].center) - vector(&still.splats[7].center);
        assert!(offset.distance(DVec3::X * way) < 1e-5, "{offset}");
    }
    assert_eq!(scene.motion.as_ref().map(|motion| motion.shutter), Some(Shutter::Gaussian));
    assert_eq!(scene.moving_splats()[0].part, Interval::EXPOSURE);
}

#[test]
fn a_still_picture_of_what_moves_has_no_plan() {
    let scene = good(&[CAMERA, SHUTTER, STILL, "motion = { velocity = [1, 0, 0] }\n"]);
    assert_eq!(Plan::of(&scene).err(), Some(PlanError::Moving));
    assert_eq!(Plan::on(&scene, &pointcore_contract::splat::Config::default()).err(), Some(PlanError::Moving));
}

#[test]
fn motion_that_makes_no_sense_is_refused() {
    let object = |motion: &str| [CAMERA, SHUTTER, STILL, motion].concat();
    let scene =
        |camera: &str, shutter: &str| [CAMERA, camera, shutter, STILL, "motion = { velocity = [1, 0, 0] }\n"].concat();
    for (text, parts) in [
        (scene("", ""), ["`object.0.motion`", "`[shutter]`"]),
        (scene("turntable = 3\n", SHUTTER), ["`camera.turntable`", "`object.0.motion`"]),
        (scene("", "[shutter]\nopen = 1\nclose = 1\n"), ["`shutter.close` is 1", "more than `shutter.open`"]),
        (scene("", "[shutter]\nopen = nan\nclose = 1\n"), ["`shutter.open`", "seconds"]),
        (scene("", "[shutter]\nopen = 0\n"), ["missing field `close`", "line"]),
        (scene("", "[shutter]\nopen = 0\nclose = 1\nshape = \"triangle\"\n"), ["triangle", "`box`"]),
        (scene("", "[shutter]\nopen = 0\nclose = 1\nspeed = 1\n"), ["unknown field `speed`", "`shape`"]),
        (
            scene("", &format!("{SHUTTER}[splatting]\nmotion = \"bins\"\n")),
            ["`splatting.motion` is \"bins\"", "\"bins:8\""],
        ),
        (object("motion = {}\n"), ["`object.0.motion`", "`velocity`"]),
        (object("motion = { speed = 1 }\n"), ["unknown field `speed`", "`velocity`"]),
        (object("motion = { velocity = [inf, 0, 0] }\n"), ["`object.0.motion.velocity`", "numbers up to"]),
        (
            object("motion = { velocity = [1, 0, 0], keyframe = [{ time = 0 }] }\n"),
            ["`object.0.motion.velocity`", "either"],
        ),
        (object("motion = { keyframe = [{ time = 0 }] }\n"), ["`object.0.motion`", "two keyframes"]),
        (
            object("motion = { keyframe = [{ time = 1 }, { time = 1 }] }\n"),
            ["`object.0.motion.keyframe.1.time` is 1", "later than"],
        ),
        (
            object("motion = { keyframe = [{ time = 0 }, { time = 1, rotate_degrees = [0, 1e9, 0] }] }\n"),
            ["`object.0.motion.keyframe.1.rotate_degrees`", "full turns"],
        ),
    ] {
        let message = load(&text).expect_err("the scene is bad").to_string();
        for part in parts {
            assert!(message.contains(part), "`{part}` is missing in: {message}");
        }
    }
}
