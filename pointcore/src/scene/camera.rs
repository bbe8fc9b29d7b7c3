//! From where the scene is looked at to the numbers of [`Camera`].

use super::disc::Placement;
use super::file::{CameraTable, ImageTable, Keyframe};
use super::model::COORDINATE_LIMIT;
use glam::DVec3;
use pointcore_contract::Camera;
use pointcore_contract::splat::config::IMAGE_EDGE_MAX;
use std::ops::RangeInclusive;

/// Beyond these a pixel is wider than any scene, or narrower than a single-precision coordinate resolves.
const FOV_RANGE_DEGREES: RangeInclusive<f64> = 0.01..=179.0;
/// Depths of the near and far plane: reciprocals and ratios of them stay within single precision.
const DEPTH_RANGE: RangeInclusive<f64> = 1e-9..=1e12;
/// The opening angle of a camera that says none: that of a portrait lens, which hardly distorts.
const DEFAULT_FOV_DEGREES: f64 = 30.0;
/// The most frames of a sequence: a minute and a half.
pub const FRAMES_LIMIT: usize = 2000;

/// A key and what is wrong with its value.
pub(super) type Problem = (&'static str, String);

/// Rejects a number outside its range, NaN included.
pub(super) fn within(key: &'static str, number: f64, range: RangeInclusive<f64>) -> Result<(), Problem> {
    let (low, high) = (range.start(), range.end());
    let valid = range.contains(&number);
    valid.then_some(()).ok_or_else(|| (key, format!("is {number:?}: expected {low:?} to {high:?}")))
}

/// Where the camera stands in world space, and what it is turned to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose {
    pub eye: DVec3,
    pub target: DVec3,
    pub up: DVec3,
    pub fov_degrees: f64,
}

impl Pose {
    /// The axes to the right, down, and forward; right-handed. None, where the eye is the target, or up is forward.
    pub(super) fn axes(&self) -> Result<[DVec3; 3], Problem> {
        let forward = (self.target - self.eye).try_normalize().ok_or_else(|| {
            let target = self.target.to_array();
            ("camera.target", format!("is {target:?}, where the eye is: expected another point"))
        })?;
        let right = forward.cross(self.up).try_normalize().ok_or_else(|| {
            ("camera.up", format!("is {:?}: expected a vector across the viewing direction", self.up.to_array()))
        })?;
        Ok([right, forward.cross(right), forward])
    }
}

/// Rejects what no camera can be made of, whatever the scene.
pub(super) fn check(camera: &CameraTable, image: &ImageTable) -> Result<(), Problem> {
    for (key, size) in [("image.width", image.width), ("image.height", image.height)] {
        if !(1..=IMAGE_EDGE_MAX as usize).contains(&size) {
            return Err((key, format!("is {size}: expected 1 to {IMAGE_EDGE_MAX} pixels")));
        }
    }
    for fov in camera.keyframes.iter().map(|keyframe| keyframe.fov_degrees).chain([camera.fov_degrees]).flatten() {
        within("camera.fov_degrees", fov, FOV_RANGE_DEGREES)?;
    }
    for (key, depth) in [("camera.near", camera.near), ("camera.far", camera.far)] {
        depth.map_or(Ok(()), |depth| within(key, depth, DEPTH_RANGE))?;
    }
    if let (Some(near), Some(far)) = (camera.near, camera.far)
        && far <= near
    {
        return Err(("camera.far", format!("is {far}: expected more than near, which is {near}")));
    }
    let of_keyframes = camera.keyframes.iter().flat_map(|keyframe| {
        [
            ("camera.keyframe", Some(keyframe.eye)),
            ("camera.keyframe", keyframe.target),
            ("camera.keyframe", keyframe.up),
        ]
    });
    let own = [
        ("camera.eye", camera.eye),
        ("camera.target", camera.target),
        ("camera.up", camera.up),
        ("camera.from", camera.from),
    ];
    for (key, vector) in own.into_iter().chain(of_keyframes).filter_map(|(key, vector)| Some((key, vector?))) {
        if !vector.iter().all(|component| component.abs() <= COORDINATE_LIMIT) {
            return Err((key, format!("is {vector:?}: expected numbers up to {COORDINATE_LIMIT:e}")));
        }
    }
    // Where the camera fits, no other direction makes these meaningless.
    for (key, vector) in [("camera.up", camera.up), ("camera.from", camera.from)] {
        if camera.fit && vector.is_some_and(|vector| DVec3::from_array(vector).try_normalize().is_none()) {
            return Err((key, format!("is {:?}: expected a vector other than zero", vector.unwrap_or_default())));
        }
    }
    check_alternatives(camera)
}

/// Rejects keys that another one makes meaningless: they would be ignored silently.
fn check_alternatives(camera: &CameraTable) -> Result<(), Problem> {
    let is_path = !camera.keyframes.is_empty();
    for (key, given, other, excludes) in [
        ("camera.eye", camera.eye.is_some(), "`fit`", camera.fit),
        ("camera.target", camera.target.is_some(), "`fit`", camera.fit),
        ("camera.keyframe", is_path, "`fit`", camera.fit),
        ("camera.eye", camera.eye.is_some(), "keyframes", is_path),
        ("camera.turntable", camera.turntable.is_some(), "keyframes", is_path),
    ] {
        if given && excludes {
            return Err((key, format!("goes without {other}: give either")));
        }
    }
    if camera.from.is_some() && !camera.fit {
        return Err(("camera.from", "goes with `fit = true`".to_owned()));
    }
    if camera.frames.is_some() != is_path || camera.keyframes.len() == 1 {
        return Err(("camera.frames", "goes with two keyframes or more: `[[camera.keyframe]]`".to_owned()));
    }
    for (key, frames) in [("camera.turntable", camera.turntable), ("camera.frames", camera.frames)] {
        if let Some(frames) = frames.filter(|frames| !(1..=FRAMES_LIMIT).contains(frames)) {
            return Err((key, format!("is {frames}: expected 1 to {FRAMES_LIMIT} frames")));
        }
    }
    if !camera.fit && !is_path {
        for (key, given) in [("camera.eye", camera.eye), ("camera.target", camera.target)] {
            given.ok_or_else(|| (key, "is missing: give it, or `fit = true` to see the whole scene".to_owned()))?;
        }
    }
    Ok(())
}

/// The opening angle of a camera.
pub(super) fn fov_degrees(camera: &CameraTable) -> f64 {
    camera.fov_degrees.unwrap_or(DEFAULT_FOV_DEGREES)
}

/// Where the camera is in each frame of a path through its keyframes.
pub(super) fn path(camera: &CameraTable, up: DVec3) -> Vec<Pose> {
    let pose = |keyframe: &Keyframe| Pose {
        eye: DVec3::from_array(keyframe.eye),
        target: DVec3::from_array(keyframe.target.or(camera.target).unwrap_or_default()),
        up: keyframe.up.map_or(up, DVec3::from_array),
        fov_degrees: keyframe.fov_degrees.unwrap_or(fov_degrees(camera)),
    };
    let poses: Vec<_> = camera.keyframes.iter().map(pose).collect();
    let frames = camera.frames.unwrap_or_default();
    let last = poses.len().saturating_sub(1);
    let at = |frame: usize| {
        let time = last as f64 * frame as f64 / frames.saturating_sub(1).max(1) as f64;
        let first = (time as usize).min(last.saturating_sub(1));
        between(
            [first.saturating_sub(1), first, first + 1, (first + 2).min(last)].map(|index| poses[index]),
            time - first as f64,
        )
    };
    (0..frames).map(at).collect()
}

/// A pose on the Catmull-Rom curve through the two in the middle.
fn between([before, from, to, after]: [Pose; 4], share: f64) -> Pose {
    let curve = |of: &dyn Fn(&Pose) -> DVec3| {
        let [p, q, r, s] = [&before, &from, &to, &after].map(of);
        let (square, cube) = (share * share, share * share * share);
        0.5 * (2.0 * q
            + (r - p) * share
            + (2.0 * p - 5.0 * q + 4.0 * r - s) * square
            + (3.0 * q - p - 3.0 * r + s) * cube)
    };
    let fov_degrees = from.fov_degrees + (to.fov_degrees - from.fov_degrees) * share;
    Pose {
        eye: curve(&|pose| pose.eye),
        target: curve(&|pose| pose.target),
        up: from.up.lerp(to.up, share),
        fov_degrees,
    }
}

/// Where the camera is in each frame of a full turn around its target, counter-clockwise seen from above.
pub(super) fn turn(pose: &Pose, frames: usize) -> Vec<Pose> {
    let axis = pose.up.normalize_or(DVec3::Y);
    let at = |frame: usize| {
        let angle = std::f64::consts::TAU * frame as f64 / frames as f64;
        let eye = if frame == 0 {
            pose.eye
        } else {
            pose.target + glam::DQuat::from_axis_angle(axis, angle) * (pose.eye - pose.target)
        };
        Pose { eye, ..*pose }
    };
    (0..frames).map(at).collect()
}

/// Derives the camera in the splats' coordinates; `depths` are those of near and far plane in world units.
///
/// Its axes are the viewing direction `z`, `x = z × up` and `y = z × x`, so that x points right, y down and the triple
/// is right-handed. Pixels are square: one unit at distance 1 measures `height / (2·tan(fov/2))` pixels. Depth is
/// `a + b/Z` with `a = far/(far − near)` and `b = −near·a`, which is 0 at the near and 1 at the far plane.
pub(super) fn derive(
    pose: &Pose,
    [near, far]: [f64; 2],
    image: &ImageTable,
    placement: &Placement,
) -> Result<Camera, Problem> {
    let [right, down, forward] = pose.axes()?;
    let eye = placement.place(pose.eye);
    let [near, far] = [near, far].map(|depth| depth / placement.unit);
    let row = |axis: DVec3| [axis.x, axis.y, axis.z, -axis.dot(eye)];
    let scale = image.height as f64 / (2.0 * (pose.fov_degrees.to_radians() / 2.0).tan());
    let depth_a = far / (far - near);
    Ok(Camera {
        model_view: [row(right), row(down), row(forward)],
        scale_x: scale,
        scale_y: scale,
        center_x: image.width as f64 / 2.0,
        center_y: image.height as f64 / 2.0,
        depth_a,
        depth_b: -near * depth_a,
        near,
    })
}
