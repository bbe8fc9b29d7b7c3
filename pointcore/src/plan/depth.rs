//! Whether the depths of a scene can be told apart in the format of its hardware.

use super::Plan;
use crate::scene::Scene;
use glam::DVec3;
use std::fmt;

/// The share of a splat's radius that must make a difference in depth: the one over which surfaces blend.
const RADIUS_SHARE: f64 = 0.5;
/// Roundings that a depth goes through, in units of the last place of one just below 1.
const ROUNDED_PLACES: f64 = 4.0;
/// The share of splats that may lie beyond the resolution.
const LOST_LIMIT: f64 = 0.01;

/// Splats that lie where depth resolves less than their own size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthLoss {
    /// Share of the splats before the near plane.
    pub lost: f64,
    /// The near plane as it is.
    pub near: f64,
    /// The near plane with which nearly all would be told apart.
    pub near_needed: f64,
    /// Distance of the nearest splat before the camera.
    pub nearest: f64,
}

impl DepthLoss {
    /// Looks at the splats that a plan's hardware draws; nothing where their depths can be told apart.
    #[must_use]
    pub fn of(scene: &Scene, plan: &Plan) -> Option<Self> {
        let camera = &scene.camera;
        let forward = camera.model_view[2];
        let resolved = ROUNDED_PLACES * 0.5_f64.powi(plan.config.geometry.mantissa as i32 + 1);
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        // How many times the resolution a splat's own size makes, and how far away it is.
        let reach = |splat: &pointcore_contract::Splat| {
            let distance = DVec3::from_slice(&forward).dot(vector(splat.center)) + forward[3];
            let size = RADIUS_SHARE * vector(splat.tangents[0]).length();
            (distance > camera.near).then(|| (size * camera.depth_b.abs() / (distance * distance) / resolved, distance))
        };
        let mut reaches: Vec<(f64, f64)> = scene.splats.iter().filter_map(reach).collect();
        reaches.sort_by(|a, b| a.0.total_cmp(&b.0));
        let count = reaches.len() as f64;
        let lost = reaches.partition_point(|(reach, _)| *reach < 1.0) as f64 / count.max(1.0);
        if lost <= LOST_LIMIT {
            return None;
        }
        let allowed = reaches[(LOST_LIMIT * count) as usize].0;
        let nearest = reaches.iter().map(|(_, distance)| *distance).fold(f64::INFINITY, f64::min);
        Some(Self { lost, near: camera.near, near_needed: camera.near / allowed, nearest })
    }
}

impl fmt::Display for DepthLoss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { lost, near, near_needed, nearest } = *self;
        let percent = 100.0 * lost;
        write!(
            f,
            "depth resolves less than half their radius at {percent:.0} % of the splats, so that far surfaces mix: "
        )?;
        if near_needed < nearest {
            write!(f, "raise `camera.near` from {near} to {near_needed:.2}; the nearest splat is {nearest:.2} away")
        } else {
            write!(
                f,
                "raise `camera.near` from {near} to {nearest:.2}, where the nearest splat is, or take a wider `geometry`"
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn loss(near: f64) -> Option<DepthLoss> {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let path = folder.path().join("scene.toml");
        let text = format!(
            "camera = {{ eye = [0, 0, 5], target = [0, 0, 0], fov_degrees = 40, near = {near}, far = 100 }}\n\
             image = {{ width = 32, height = 32 }}\n[[object]]\nkind = \"sphere\"\npoints = 500\nouter_radius = 1\n"
        );
        fs::write(&path, text).expect("a temporary folder can be written");
        let scene = Scene::load(&path, &[]).expect("the scene is good");
        DepthLoss::of(&scene, &Plan::of(&scene).expect("it has hardware"))
    }

    #[test]
    fn only_a_near_plane_too_near_is_warned_about() {
        assert_eq!(loss(1.0), None);
        let lost = loss(1e-6).expect("a millionth leaves no depth");
        assert!(lost.lost > 0.9 && lost.near_needed > 1e-6 && lost.near_needed < lost.nearest, "{lost:?}");
        assert!(lost.to_string().contains("raise `camera.near` from 0.000001"), "{lost}");
        assert_eq!(loss(lost.near_needed * 1.05), None, "the remedy is one");
    }
}
