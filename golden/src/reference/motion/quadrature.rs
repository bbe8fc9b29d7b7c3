//! The integral of a moving splat by numbers: its static footprint at very many instants. It shares nothing with the closed form.

use super::{MovingSplat, Place, Shutter};
use glam::DVec3;
use pointcore_contract::{Camera, Rendering};

/// Instants of the exposure. Where a footprint begins or ends between two of them, the sum errs by half a step times the kernel there.
pub const INSTANTS: usize = 1 << 14;
/// Time between two instants, as a share of the exposure.
pub const STEP: f64 = 1.0 / INSTANTS as f64;

/// The splat's weight at a place at `τ`: the viewing ray is cast onto its plane, and the screen filter is a circle of its radius about the center.
pub fn weight(moving: &MovingSplat, place: &Place, tau: f64, camera: &Camera, rendering: &Rendering) -> f64 {
    if !moving.part.contains(tau) {
        return 0.0;
    }
    let row = |row: usize| DVec3::from_slice(&camera.model_view[row]);
    let turned = |vector: DVec3| DVec3::new(row(0).dot(vector), row(1).dot(vector), row(2).dot(vector));
    let double = |vector: [f32; 3]| DVec3::from_array(vector.map(f64::from));
    let translation = DVec3::from_array(camera.model_view.map(|row| row[3]));
    let way = moving.motion * (tau - moving.part.middle());
    let center = turned(double(moving.splat.center) + way) + translation;
    let [first, second] = moving.splat.tangents.map(|tangent| turned(double(tangent)));
    let normal = first.cross(second);
    if center.dot(normal) > 0.0 {
        return 0.0;
    }
    let is_between =
        |distance: f64| (0.0..=1.0).contains(&(camera.depth_a + camera.depth_b / distance)) && distance > 0.0;
    let ray = place.ray(camera);
    let distance = center.dot(normal) / ray.dot(normal);
    let offset = distance * ray - center;
    // `a2 × n` is orthogonal to a2 and n, so it singles out the coordinate along a1, and likewise for a2.
    let (across_second, across_first) = (second.cross(normal), first.cross(normal));
    let s = offset.dot(across_second) / first.dot(across_second);
    let t = offset.dot(across_first) / second.dot(across_first);
    let on_splat = if is_between(distance) { s * s + t * t } else { f64::INFINITY };
    let on_screen = rendering.filter_radius_px.filter(|_| is_between(center.z)).map_or(f64::INFINITY, |radius| {
        let x = camera.scale_x * center.x / center.z + camera.center_x - place.position[0];
        let y = camera.scale_y * center.y / center.z + camera.center_y - place.position[1];
        (x * x + y * y) / (radius * radius)
    });
    let squared = on_splat.min(on_screen);
    if squared < 1.0 { (-rendering.kernel_gamma * squared).exp() } else { 0.0 }
}

/// The integral over the exposure, scaled as the closed form is.
pub fn integral(moving: &MovingSplat, place: &Place, shutter: Shutter, camera: &Camera, rendering: &Rendering) -> f64 {
    let at = |index: usize| {
        let tau = -1.0 + 2.0 * (index as f64 + 0.5) * STEP;
        shutter.weight(tau) * weight(moving, place, tau, camera, rendering)
    };
    (0..INSTANTS).map(at).sum::<f64>() * 2.0 * STEP / shutter.total()
}
