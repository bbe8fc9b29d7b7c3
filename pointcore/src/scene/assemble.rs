//! From the tables of a scene and its discs to the scene that is rendered: where it lies, who looks, what is before the camera.

use super::camera::{self, Pose, Problem, within};
use super::disc::{Disc, Placement, Sides};
use super::file::{Draw, ImageTable, Light, LightDirection, LightTable, Material, SceneFile, SplattingTable, Surfaces};
use super::mesh::Triangle;
use super::motion::{self, Motion};
use super::{Scene, View, fit, model, object};
use crate::color::linear_from_srgb;
use glam::DVec3;
use pointcore_contract::splat::config::{IMAGE_EDGE_MAX, KERNEL_GAMMA_RANGE};
use pointcore_contract::{Camera, Rendering, Sampling, Splat};
use pointcore_golden::reference::motion::Method;
use std::borrow::Cow;
use std::ops::Range;

/// The share of a splat's radius by which surfaces may lie apart in depth and still blend. Neighboring splats of a
/// curved surface that all face the eye have no depth range of their own (eq. 5.9), but do differ in depth.
const BLENDED_RADIUS_SHARE: f64 = 0.5;
/// A filter of eight tiles' width; beyond, a picture is a blur.
const FILTER_RADIUS_LIMIT_PX: f64 = 64.0;
/// A splat that blends with what lies this many of its own depth ranges away blends with everything.
const EPSILON_SCALE_LIMIT: f64 = 1e6;
/// A light that is overexposed by this factor leaves nothing but white.
const INTENSITY_LIMIT: f64 = 1000.0;
/// Samples along an edge beyond which more show nothing.
const SAMPLES_LIMIT: usize = 8;
/// Cut off nearer, splats leave holes; farther, the kernel has hardly any weight left.
const CUTOFF_RANGE: std::ops::RangeInclusive<f64> = 0.25..=2.0;
/// Finer, every part is as short as it may be; coarser, nothing is left of a curve.
const RESAMPLE_RANGE_PX: std::ops::RangeInclusive<f64> = 0.01..=64.0;
/// A highlight narrower than a pixel of the largest picture.
const SHININESS_LIMIT: f64 = 1e6;

/// Where a light over the shoulder comes from: to the left, up, and back, by the camera's axes.
const SHOULDER: [f64; 3] = [0.5, 0.6, 1.0];

/// A key with its tables, and what is wrong with its value.
type Fault = (String, String);

fn fault((key, problem): Problem) -> Fault {
    (key.to_owned(), problem)
}

/// Rejects values that make no sense, whatever the objects turn out to be.
pub(super) fn check(file: &SceneFile) -> Result<(), Fault> {
    camera::check(&file.camera, &file.image).map_err(fault)?;
    object::check_color(file.image.background).map_err(|problem| ("image.background".to_owned(), problem))?;
    check_light(&file.light).map_err(fault)?;
    motion::check(file)?;
    method(&file.splatting)?;
    if let Some(resample_px) = file.splatting.resample_px {
        within("splatting.resample_px", resample_px, RESAMPLE_RANGE_PX).map_err(fault)?;
    }
    for (index, material) in file.materials.iter().enumerate() {
        check_material(material).map_err(|(key, problem)| (format!("material.{index}.{key}"), problem))?;
    }
    let materials = file.materials.len().max(1);
    match file.objects.iter().position(|object| usize::from(object.material) >= materials) {
        Some(index) => {
            let problem = format!("is {}: expected an index below {materials}", file.objects[index].material);
            Err((format!("object.{index}.material"), problem))
        }
        None => Ok(()),
    }
}

/// How a moving scene settles what hides what, if it says so.
fn method(splatting: &SplattingTable) -> Result<Option<Method>, Fault> {
    let parsed = splatting.motion.as_deref().map(str::parse::<Method>).transpose();
    parsed.map_err(|unknown| ("splatting.motion".to_owned(), unknown.to_string()))
}

/// Makes the scene of checked tables and discs, of which each object has a span.
pub(super) fn assemble(
    file: SceneFile,
    (mut discs, triangles): (Vec<Disc>, Vec<Triangle>),
    spans: &[Range<usize>],
    notes: Vec<String>,
) -> Result<Scene, Fault> {
    if discs.is_empty() {
        let problem = if triangles.is_empty() {
            "is empty: a scene needs at least one object"
        } else {
            "draws triangles alone: a scene needs at least one object of splats"
        };
        return Err(("object".to_owned(), problem.to_owned()));
    }
    let mut motion = Motion::of(&file, spans, method(&file.splatting)?);
    if let (Some(_), Some(index)) = (&motion, file.objects.iter().position(|object| object.draw == Draw::Triangles)) {
        let problem = "is \"triangles\", which go with scenes that stand still, but something moves: draw splats";
        return Err((format!("object.{index}.draw"), problem.to_owned()));
    }
    let mut camera_path = None;
    if let Some(motion) = &mut motion {
        motion.move_to_middle(&mut discs);
        camera_path = motion.take_camera();
    }
    let is_separate = file.splatting.surfaces == Surfaces::Objects;
    if is_separate && motion.is_some() {
        let problem = "is \"objects\", which goes with scenes that stand still, but something moves: leave it out";
        return Err(("splatting.surfaces".to_owned(), problem.to_owned()));
    }
    // What cameras are to see, and coordinates to count from, are corners of triangles, too.
    let seen_still = if triangles.is_empty() {
        Cow::Borrowed(&discs[..])
    } else {
        discs.iter().cloned().chain(triangles.iter().flat_map(Triangle::extent)).collect()
    };
    let placement = Placement::of(&seen_still);
    let splats: Vec<Splat> = discs.iter().map(|disc| placement.splat(disc)).collect();
    // Where a camera looks for discs: a moving scene's lie along their ways.
    let seen = |motion: &Option<Motion>| motion.as_ref().map(|motion| motion.of_all_instants(&discs));
    let mut poses = poses(&file, seen(&motion).as_deref().unwrap_or(&seen_still));
    if let (Some(motion), [pose]) = (&mut motion, &mut poses[..]) {
        motion.give_camera(camera_path, pose.eye);
        *pose = motion.pose(pose);
    }
    let seen = seen(&motion);
    let seen = seen.as_deref().unwrap_or(&seen_still);
    let view = |pose: Pose| {
        let depths = fit::depths(seen, &pose, [file.camera.near, file.camera.far])?;
        let camera = camera::derive(&pose, depths, &file.image, &placement)?;
        let light = light(&file.light, &camera);
        Ok(View { camera, light, epsilon_bias: blending_depth(&splats, &camera) })
    };
    let mut views = poses.into_iter().map(view).collect::<Result<Vec<_>, Problem>>().map_err(fault)?;
    let rendering = rendering(&file.image, &file.splatting).map_err(fault)?;
    if let Some(bias) = file.splatting.epsilon_bias {
        views.iter_mut().for_each(|view| view.epsilon_bias = bias);
    }

    let are_all_front = discs.iter().all(|disc| disc.sides == Sides::Front);
    let sides = if are_all_front { Vec::new() } else { discs.iter().map(|disc| disc.sides).collect() };
    let first = views.first().cloned().expect("a camera has one frame at least");
    let scene = Scene {
        camera: first.camera,
        rendering,
        splats,
        surfaces: if is_separate { spans.iter().filter(|span| !span.is_empty()).cloned().collect() } else { vec![] },
        triangles: triangles.iter().map(|triangle| triangle.placed(&placement)).collect(),
        light: first.light.clone(),
        materials: if file.materials.is_empty() { vec![Material::default()] } else { file.materials },
        background: file.image.background.map(linear_from_srgb),
        samples: 1,
        overrides: file.overrides,
        placement,
        sides,
        views,
        notes,
        motion: motion.map(|motion| motion.placed(placement)),
    };
    let (samples, cutoff) = (file.image.samples, file.splatting.cutoff.unwrap_or(1.0));
    check_sampling(samples, &scene.rendering).map_err(|problem| ("image.sampling".to_owned(), problem))?;
    check_samples(samples, &scene.rendering).map_err(|problem| ("image.samples".to_owned(), problem))?;
    within("splatting.cutoff", cutoff, CUTOFF_RANGE).map_err(fault)?;
    let mut scene = scene.without_unread().cut_off(cutoff).supersampled(samples);
    let first = scene.views[0].clone();
    scene.look(&first);
    Ok(scene)
}

/// Where the camera is in each frame.
fn poses(file: &SceneFile, discs: &[Disc]) -> Vec<Pose> {
    let table = &file.camera;
    let of_files = file.objects.iter().filter_map(|object| model::up(object.path.as_deref()?));
    let usual = if of_files.into_iter().any(|up| up == model::Up::Z) { DVec3::Z } else { DVec3::Y };
    let up = table.up.map_or(if table.fit { usual } else { DVec3::Y }, DVec3::from_array);
    if !table.keyframes.is_empty() {
        return camera::path(table, up);
    }
    let fov_degrees = camera::fov_degrees(table);
    let vector = |given: Option<[f64; 3]>| given.map(DVec3::from_array);
    let pose = if table.fit {
        let direction = vector(table.from).unwrap_or_else(|| fit::direction(discs, up));
        fit::pose(discs, direction, up, fov_degrees, &file.image)
    } else {
        let [eye, target] = [table.eye, table.target].map(|place| vector(place).unwrap_or_default());
        Pose { eye, target, up, fov_degrees }
    };
    let Some(frames) = table.turntable else { return vec![pose] };
    if !table.fit {
        return camera::turn(&pose, frames);
    }
    let directions: Vec<_> =
        camera::turn(&pose, frames).iter().map(|pose| (pose.eye - pose.target).normalize_or(DVec3::Z)).collect();
    camera::turn(&fit::at_distance(discs, &pose, &directions, &file.image), frames)
}

/// The light as a camera has it.
fn light(table: &LightTable, camera: &Camera) -> Light {
    let direction = match table.direction {
        LightDirection::World(direction) => direction,
        LightDirection::Derived(_) => {
            // The camera's axes point to the right, down and forward.
            let axes = camera.model_view.map(|row| DVec3::from_slice(&row[..3]));
            let along = axes.iter().zip(SHOULDER).map(|(axis, share)| -share * *axis);
            along.sum::<DVec3>().to_array()
        }
    };
    Light { direction, ambient: table.ambient, diffuse: table.diffuse }
}

/// Image size and kernel; the tolerance is that of a view, unless the scene says another.
fn rendering(image: &ImageTable, splatting: &SplattingTable) -> Result<Rendering, Problem> {
    let number = |key, given: Option<f64>, default, range| {
        given.map_or(Ok(default), |number| within(key, number, range).map(|()| number))
    };
    let kernel_gamma =
        number("splatting.kernel_gamma", splatting.kernel_gamma, Rendering::DEFAULT_KERNEL_GAMMA, KERNEL_GAMMA_RANGE)?;
    let filter_radius_px = number(
        "splatting.filter_radius_px",
        splatting.filter_radius_px,
        Rendering::DEFAULT_FILTER_RADIUS_PX,
        0.0..=FILTER_RADIUS_LIMIT_PX,
    )?;
    let epsilon_scale = number(
        "splatting.epsilon_scale",
        splatting.epsilon_scale,
        Rendering::DEFAULT_EPSILON_SCALE,
        0.0..=EPSILON_SCALE_LIMIT,
    )?;
    // A pixel's right and bottom sides are the left and top sides of pixels beside it: the last ones have such beside them, too.
    let (width, height) = match image.sampling {
        Sampling::Center => (image.width, image.height),
        Sampling::Flipquad => (2 * (image.width + 1), image.height + 1),
    };
    Ok(Rendering {
        width,
        height,
        sampling: image.sampling,
        depth: splatting.depth,
        kernel_gamma,
        filter_radius_px: (filter_radius_px > 0.0).then_some(filter_radius_px),
        epsilon_scale,
        epsilon_bias: number("splatting.epsilon_bias", splatting.epsilon_bias, 0.0, 0.0..=1.0)?,
    })
}

fn check_samples(samples: usize, rendering: &Rendering) -> Result<(), String> {
    if !(1..=SAMPLES_LIMIT).contains(&samples) {
        return Err(format!("is {samples}: expected 1 to {SAMPLES_LIMIT} along an edge of a pixel"));
    }
    let longest = samples * rendering.width.max(rendering.height);
    let limit = IMAGE_EDGE_MAX as usize;
    (longest <= limit).then_some(()).ok_or_else(|| {
        format!("is {samples}, which makes {longest} samples along an edge of the image: expected up to {limit}")
    })
}

fn check_sampling(samples: usize, rendering: &Rendering) -> Result<(), String> {
    let limit = IMAGE_EDGE_MAX as usize;
    match rendering.sampling {
        Sampling::Center => Ok(()),
        Sampling::Flipquad if samples > 1 => {
            Err(format!("is \"flipquad\", which has samples of its own: expected `image.samples` = 1, not {samples}"))
        }
        Sampling::Flipquad if rendering.width.max(rendering.height) > limit => Err(format!(
            "is \"flipquad\", which makes {} by {} samples: expected up to {limit}, an image of {} by {} pixels",
            rendering.width,
            rendering.height,
            limit / 2 - 1,
            limit - 1
        )),
        Sampling::Flipquad => Ok(()),
    }
}

fn check_light(light: &LightTable) -> Result<(), Problem> {
    if let LightDirection::World(direction) = light.direction
        && DVec3::from_array(direction).try_normalize().is_none()
    {
        return Err(("light.direction", format!("is {direction:?}: expected a vector other than zero")));
    }
    within("light.ambient", light.ambient, 0.0..=INTENSITY_LIMIT)?;
    within("light.diffuse", light.diffuse, 0.0..=INTENSITY_LIMIT)
}

fn check_material(material: &Material) -> Result<(), Problem> {
    within("specular", material.specular, 0.0..=1.0)?;
    within("shininess", material.shininess, 0.0..=SHININESS_LIMIT)
}

/// The mean, over the splats before the camera, of the depth difference that [`BLENDED_RADIUS_SHARE`] of their radius
/// makes: `|∂depth/∂Z| = |depth_b| / Z²`.
fn blending_depth(splats: &[Splat], camera: &Camera) -> f64 {
    let forward = camera.model_view[2];
    let depth = |splat: &Splat| {
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        let distance = DVec3::from_slice(&forward).dot(vector(splat.center)) + forward[3];
        let radius = vector(splat.tangents[0]).length();
        (distance > camera.near).then(|| BLENDED_RADIUS_SHARE * radius * camera.depth_b.abs() / (distance * distance))
    };
    let visible: Vec<f64> = splats.iter().filter_map(depth).collect();
    visible.iter().sum::<f64>() / visible.len().max(1) as f64
}
