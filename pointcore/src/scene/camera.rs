//! From where the scene is looked at to the numbers of [`Camera`].

use super::file::{CameraTable, ImageTable};
use super::model::COORDINATE_LIMIT;
use glam::DVec3;
use pointcore_contract::Camera;
use pointcore_contract::splat::config::IMAGE_EDGE_MAX;
use std::ops::RangeInclusive;

/// Beyond these a pixel is wider than any scene, or narrower than a single-precision coordinate resolves.
const FOV_RANGE_DEGREES: RangeInclusive<f64> = 0.01..=179.0;
/// Depths of the near and far plane: reciprocals and ratios of them stay within single precision.
const DEPTH_RANGE: RangeInclusive<f64> = 1e-9..=1e12;

/// A key and what is wrong with its value.
pub(super) type Problem = (&'static str, String);

/// Rejects a number outside its range, NaN included.
pub(super) fn within(key: &'static str, number: f64, range: RangeInclusive<f64>) -> Result<(), Problem> {
    let (low, high) = (range.start(), range.end());
    let valid = range.contains(&number);
    valid.then_some(()).ok_or_else(|| (key, format!("is {number:?}: expected {low:?} to {high:?}")))
}

/// Derives the camera.
///
/// Its axes are the viewing direction `z`, `x = z × up` and `y = z × x`, so that x points right, y down and the triple
/// is right-handed. Pixels are square: one unit at distance 1 measures `height / (2·tan(fov/2))` pixels. Depth is
/// `a + b/Z` with `a = far/(far − near)` and `b = −near·a`, which is 0 at the near and 1 at the far plane.
pub(super) fn derive(camera: &CameraTable, image: &ImageTable) -> Result<Camera, Problem> {
    for (key, size) in [("image.width", image.width), ("image.height", image.height)] {
        if !(1..=IMAGE_EDGE_MAX as usize).contains(&size) {
            return Err((key, format!("is {size}: expected 1 to {IMAGE_EDGE_MAX} pixels")));
        }
    }
    within("camera.fov_degrees", camera.fov_degrees, FOV_RANGE_DEGREES)?;
    within("camera.near", camera.near, DEPTH_RANGE)?;
    within("camera.far", camera.far, DEPTH_RANGE)?;
    if camera.far <= camera.near {
        return Err(("camera.far", format!("is {}: expected more than near, which is {}", camera.far, camera.near)));
    }
    for (key, vector) in [("camera.eye", camera.eye), ("camera.target", camera.target), ("camera.up", camera.up)] {
        if !vector.iter().all(|component| component.abs() <= COORDINATE_LIMIT) {
            return Err((key, format!("is {vector:?}: expected numbers up to {COORDINATE_LIMIT:e}")));
        }
    }
    let (eye, target, up) =
        (DVec3::from_array(camera.eye), DVec3::from_array(camera.target), DVec3::from_array(camera.up));
    let forward = (target - eye).try_normalize().ok_or_else(|| {
        ("camera.target", format!("is {:?}, where the eye is: expected another point", camera.target))
    })?;
    let right = forward
        .cross(up)
        .try_normalize()
        .ok_or_else(|| ("camera.up", format!("is {:?}: expected a vector across the viewing direction", camera.up)))?;
    let row = |axis: DVec3| [axis.x, axis.y, axis.z, -axis.dot(eye)];
    let scale = image.height as f64 / (2.0 * (camera.fov_degrees.to_radians() / 2.0).tan());
    let depth_a = camera.far / (camera.far - camera.near);
    Ok(Camera {
        model_view: [row(right), row(forward.cross(right)), row(forward)],
        scale_x: scale,
        scale_y: scale,
        center_x: image.width as f64 / 2.0,
        center_y: image.height as f64 / 2.0,
        depth_a,
        depth_b: -camera.near * depth_a,
        near: camera.near,
    })
}
