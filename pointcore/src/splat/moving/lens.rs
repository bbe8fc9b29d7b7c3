//! The screen filter of splats that move: their hardware has none, so what is narrower on the screen is sent as an ellipse that is not.
//!
//! On the screen a splat's tangents are the columns of a matrix `P = UΣVᵀ`, affine about its centre. No semi-axis of its ellipse is to be less than the
//! filter's radius `r`: `P' = U·max(Σ, r)·Vᵀ`. What a tangent gains lies in a plane parallel to the image, at the distance of the splat in the middle of
//! its way, so that a splat seen edge-on stays as large as it is.

use crate::scene::Scene;
use glam::{DMat2, DMat3, DVec2, DVec3};
use pointcore_golden::reference::motion::MovingSplat;

/// From splats' space to the screen.
pub(crate) struct Lens {
    /// Splats' space to camera space.
    rotation: DMat3,
    translation: DVec3,
    /// Pixels at a distance of one.
    scale: DVec2,
    near: f64,
    /// Of the filter, px.
    radius: Option<f64>,
}

impl Lens {
    /// That of a scene's camera and filter.
    pub fn of(scene: &Scene) -> Self {
        let camera = &scene.camera;
        let [x, y, z] = camera.model_view.map(|row| DVec3::from_slice(&row));
        Self {
            rotation: DMat3::from_cols(x, y, z).transpose(),
            translation: camera.model_view.map(|row| row[3]).into(),
            scale: DVec2::new(camera.scale_x, camera.scale_y),
            near: camera.near,
            radius: scene.rendering.filter_radius_px,
        }
    }

    /// The tangents of a splat, no narrower on the screen than the filter.
    pub fn widened(&self, moving: &MovingSplat) -> [[f32; 3]; 2] {
        let single = moving.splat.tangents;
        let Some(radius) = self.radius else { return single };
        let double = |vector: [f32; 3]| DVec3::from_array(vector.map(f64::from));
        let center = self.rotation * double(moving.splat.center) + self.translation;
        let distance = center.z.max(self.near);
        let per_px = self.scale.recip() * distance;
        let on_screen = |tangent: DVec3| (tangent.truncate() - center.truncate() * (tangent.z / distance)) / per_px;
        let tangents = single.map(|tangent| self.rotation * double(tangent));
        let Some(gain) =
            gain(DMat2::from_cols_array_2d(&tangents.map(|tangent| on_screen(tangent).to_array())), radius)
        else {
            return single;
        };
        let added = [gain.x_axis, gain.y_axis].map(|gain| self.rotation.transpose() * (gain * per_px).extend(0.0));
        [0, 1].map(|axis: usize| (double(single[axis]) + added[axis]).as_vec3().to_array())
    }
}

/// `P' − P`, if any.
fn gain(p: DMat2, radius: f64) -> Option<DMat2> {
    let square = p * p.transpose();
    let [a, b, c] = [square.x_axis.x, square.x_axis.y, square.y_axis.y];
    let first = DVec2::from_angle(0.5 * (2.0 * b).atan2(a - c));
    let longer = (p.transpose() * first).length();
    let determinant = p.determinant();
    let shorter = if longer > 0.0 { determinant.abs() / longer } else { 0.0 };
    if shorter >= radius {
        return None;
    }
    // A splat of no size, or seen edge-on, faces the eye or not as its determinant's sign says.
    let first_axis = (p.transpose() * first).try_normalize().unwrap_or(DVec2::X);
    let second_axis = first_axis.perp() * 1.0_f64.copysign(determinant);
    let outer = |left: DVec2, right: DVec2, factor: f64| DMat2::from_cols(left * right.x, left * right.y) * factor;
    let grown = |length: f64| length.max(radius) - length;
    Some(outer(first, first_axis, grown(longer)) + outer(first.perp(), second_axis, grown(shorter)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Semi-axes of the ellipse of a matrix's columns.
    fn semi_axes(p: DMat2) -> [f64; 2] {
        let (sum, difference) = (
            (p.x_axis.x + p.y_axis.y).hypot(p.x_axis.y - p.y_axis.x),
            (p.x_axis.x - p.y_axis.y).hypot(p.x_axis.y + p.y_axis.x),
        );
        [(sum + difference) / 2.0, (sum - difference).abs() / 2.0]
    }

    #[test]
    fn no_semi_axis_is_shorter_than_the_radius() {
        let mut random = fastrand::Rng::with_seed(1);
        for case in 0..10_000 {
            let mut number = || (random.f64() - 0.5) * 4.0;
            let mut p = DMat2::from_cols(DVec2::new(number(), number()), DVec2::new(number(), number()));
            match case % 4 {
                // Seen edge-on, and of no size.
                0 => p.y_axis = p.x_axis * 0.5,
                1 => p = DMat2::ZERO,
                _ => {}
            }
            let [longer, shorter] = semi_axes(p);
            let grown = p + gain(p, 1.0).unwrap_or(DMat2::ZERO);
            let [grown_longer, grown_shorter] = semi_axes(grown);
            assert!(
                (grown_longer - longer.max(1.0)).abs() < 1e-9 && (grown_shorter - shorter.max(1.0)).abs() < 1e-9,
                "{p}"
            );
            assert!(shorter < 1e-9 || grown.determinant() * p.determinant() > 0.0, "{p} faces elsewhere");
        }
    }
}
