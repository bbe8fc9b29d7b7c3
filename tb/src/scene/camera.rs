//! From where the scene is looked at to the numbers of [`Camera`].

use super::file::{CameraTable, ImageTable};
use glam::DVec3;
use pointcore_spec::Camera;

/// Wider than the prototypes' screens by far; keeps a slip of the keyboard from filling the memory.
const SIZE_LIMIT_PX: usize = 4096;

/// A key and what is wrong with its value.
pub(super) type Problem = (&'static str, String);

/// Derives the camera.
///
/// Its axes are the viewing direction `z`, `x = z × up` and `y = z × x`, so that x points right, y down and the triple
/// is right-handed. Pixels are square: one unit at distance 1 measures `height / (2·tan(fov/2))` pixels. Depth is
/// `a + b/Z` with `a = far/(far − near)` and `b = −near·a`, which is 0 at the near and 1 at the far plane.
pub(super) fn derive(camera: &CameraTable, image: &ImageTable) -> Result<Camera, Problem> {
    for (key, size) in [("image.width", image.width), ("image.height", image.height)] {
        if !(1..=SIZE_LIMIT_PX).contains(&size) {
            return Err((key, format!("is {size}: expected 1 to {SIZE_LIMIT_PX} pixels")));
        }
    }
    if !(camera.fov_degrees > 0.0 && camera.fov_degrees < 180.0) {
        return Err((
            "camera.fov_degrees",
            format!("is {}: expected more than 0 and less than 180", camera.fov_degrees),
        ));
    }
    if !(camera.near > 0.0 && camera.near.is_finite()) {
        return Err(("camera.near", format!("is {}: expected a positive distance", camera.near)));
    }
    if !(camera.far > camera.near && camera.far.is_finite()) {
        return Err(("camera.far", format!("is {}: expected more than near, which is {}", camera.far, camera.near)));
    }
    let (eye, target, up) =
        (DVec3::from_array(camera.eye), DVec3::from_array(camera.target), DVec3::from_array(camera.up));
    let forward = (target - eye)
        .try_normalize()
        .ok_or_else(|| ("camera.target", "must be finite and differ from the eye".to_owned()))?;
    let right = forward
        .cross(up)
        .try_normalize()
        .ok_or_else(|| ("camera.up", "must not be parallel to the viewing direction".to_owned()))?;
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
