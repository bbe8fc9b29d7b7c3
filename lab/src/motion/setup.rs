//! What setup's roundings may make of a footprint, as docs/units/splat/motion_setup.md derives it: the equations once more, with a sum of magnitudes
//! for every sum.

use pointcore_contract::Camera;
use pointcore_golden::reference::motion::{MovingFootprint, Way};

/// Magnitudes of a footprint's terms, in which setup's roundings are counted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Magnitudes {
    /// Of the projected center, px.
    pub center: [f64; 2],
    /// Of the determinant's form.
    pub determinant: [f64; 2],
    /// Of places.
    pub place: [[f64; 2]; 2],
    /// Of speeds.
    pub speed: [[f64; 3]; 2],
    /// Of the distance's change.
    pub change: f64,
}

impl Magnitudes {
    /// Of a splat's footprint.
    #[must_use]
    pub fn of(way: &Way, footprint: &MovingFootprint, camera: &Camera) -> Self {
        let Way { center, motion, tangents: [first, second], .. } = *way;
        let scale = [camera.scale_x.abs(), camera.scale_y.abs()];
        let axis = [camera.center_x.abs(), camera.center_y.abs()];
        let time = footprint.time;
        let (true_w, w) = (center + time * motion, center.abs() + time.abs() * motion.abs());
        let distance = true_w.z;
        // Of the reciprocal distance, which is in every term once or twice.
        let of_distance = w.z / distance;
        let v = [w.x / distance * of_distance, w.y / distance * of_distance];
        let image = |vector: glam::DVec3| {
            let [x, y] = [0, 1].map(|axis: usize| {
                scale[axis] * (vector[axis].abs() + v[axis] * vector.z.abs()) / distance * of_distance
            });
            [x, y, vector.z.abs() / distance * of_distance]
        };
        let signed = |vector: glam::DVec3| {
            [0, 1].map(|axis: usize| scale[axis] * (vector[axis] - true_w[axis] / distance * vector.z) / distance)
        };
        let ([a_x, a_y, alpha], [b_x, b_y, beta], [m_x, m_y, mu]) = (image(first), image(second), image(motion));
        let (a, b) = (signed(first), signed(second));
        let delta = (a[0] * b[1] - b[0] * a[1]).abs();
        let per_area = (1.0 + (a_x * b_y + b_x * a_y) / delta) / delta;
        let determinant = [beta * a_y + alpha * b_y, alpha * b_x + beta * a_x].map(|part| part * per_area);
        let moved =
            |[x, y, z]: [f64; 3]| [m_y * x + m_x * y, mu * y + m_y * z, m_x * z + mu * x].map(|part| part * per_area);
        Self {
            center: [0, 1].map(|i| scale[i] * v[i] + axis[i]),
            determinant,
            place: [[b_y, b_x], [a_y, a_x]].map(|form| form.map(|part| part * per_area)),
            speed: [moved([b_x, b_y, beta]), moved([a_x, a_y, alpha])],
            change: m_x * determinant[0] + m_y * determinant[1] + mu,
        }
    }
}
