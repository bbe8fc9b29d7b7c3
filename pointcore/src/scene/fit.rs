//! A camera that sees the whole scene, from a side on which there is something to be seen.

use super::camera::{Pose, Problem};
use super::disc::{Disc, Sides};
use super::file::ImageTable;
use glam::{DMat3, DVec3};

/// What is left free around the scene, as a share of the image.
const MARGIN: f64 = 0.04;
/// What is left free before and behind the scene, as a share of its depth.
const DEPTH_MARGIN: f64 = 0.02;
/// The near plane's least share of the far plane's distance: below, depth has no bits left for what is far.
const NEAR_SHARE: f64 = 1e-4;
/// Discs that are asked which side they are seen from.
const DISCS_ASKED: usize = 20_000;
/// Views are tried from the front, a little to the side and from above, then further round, then from further up and from below, in degrees.
const ELEVATIONS: [f64; 6] = [18.0, 45.0, 80.0, -18.0, -45.0, -80.0];
const AZIMUTHS: [f64; 8] = [28.0, -28.0, 0.0, 90.0, -90.0, 152.0, -152.0, 180.0];
/// The first view that shows this share of what the best one shows will do.
const GOOD_SHARE: f64 = 0.65;

/// The direction from the scene to an eye that sees much of it.
pub(super) fn direction(discs: &[Disc], up: DVec3) -> DVec3 {
    let up = up.normalize_or(DVec3::Y);
    // Models with y up look along z, those with z up against y; `any_orthonormal_pair` is for all others.
    let front = [DVec3::Z, DVec3::NEG_Y].into_iter().find(|front| front.dot(up) == 0.0);
    let front = front.unwrap_or_else(|| up.any_orthonormal_vector());
    let right = up.cross(front);
    let step = discs.len().div_ceil(DISCS_ASKED).max(1);
    let seen = |direction: DVec3| -> f64 {
        let share = |disc: &Disc| match disc.sides {
            Sides::Front => disc.normal.dot(direction).max(0.0),
            Sides::Both => disc.normal.dot(direction).abs(),
            Sides::Eye => 1.0,
        };
        discs.iter().step_by(step).map(|disc| disc.radius().powi(2) * share(disc)).sum()
    };
    let views = ELEVATIONS.iter().flat_map(|elevation| AZIMUTHS.map(|azimuth| [azimuth, *elevation]));
    let views = views.map(|angles| {
        let [(sin, cos), (height, around)] = angles.map(|angle| angle.to_radians().sin_cos());
        let direction = around * (cos * front + sin * right) + height * up;
        (direction, seen(direction))
    });
    let views: Vec<_> = views.collect();
    let best = views.iter().map(|(_, seen)| *seen).fold(0.0, f64::max);
    views.iter().find(|(_, seen)| *seen >= GOOD_SHARE * best).map_or(front, |(direction, _)| *direction)
}

/// The pose that looks against `direction` and has all discs in the image, in its middle.
pub(super) fn pose(discs: &[Disc], direction: DVec3, up: DVec3, fov_degrees: f64, image: &ImageTable) -> Pose {
    let back = direction.normalize_or(DVec3::Z);
    // Straight from above, what is up in the image is any direction.
    let up = if up.cross(back).length() > 1e-6 * up.length() { up } else { back.any_orthonormal_vector() };
    let axes = axes(back, up);
    let infinite = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    let [low, high] = discs.iter().fold(infinite, |[low, high], disc| {
        let (center, radius) = (axes.transpose() * disc.center, DVec3::splat(disc.radius()));
        [low.min(center - radius), high.max(center + radius)]
    });
    let target = axes * ((low + high) / 2.0);
    at_distance(discs, &Pose { eye: target + back, target, up, fov_degrees }, &[back], image)
}

/// The pose with its eye where a camera turned around the target has all discs in the image from each of these directions.
pub(super) fn at_distance(discs: &[Disc], pose: &Pose, directions: &[DVec3], image: &ImageTable) -> Pose {
    let slope_y = (pose.fov_degrees.to_radians() / 2.0).tan() * (1.0 - MARGIN);
    let slope_x = slope_y * image.width as f64 / image.height as f64;
    let distance = |back: &DVec3| {
        let axes = axes(*back, pose.up).transpose();
        let distance = |disc: &Disc| {
            let (offset, radius) = (axes * (disc.center - pose.target), disc.radius());
            let aside =
                [(offset.x, slope_x), (offset.y, slope_y)].map(|(offset, slope)| (offset.abs() + radius) / slope);
            offset.z + radius + aside[0].max(aside[1])
        };
        discs.iter().map(distance).fold(0.0, f64::max)
    };
    let farthest = directions.iter().map(distance).fold(0.0, f64::max);
    Pose { eye: pose.target + farthest * (pose.eye - pose.target).normalize_or(DVec3::Z), ..*pose }
}

/// The axes to the right, up and back.
fn axes(back: DVec3, up: DVec3) -> DMat3 {
    let right = up.cross(back).normalize_or(DVec3::X);
    DMat3::from_cols(right, back.cross(right), back)
}

/// Distances of planes before and behind all discs before the eye; those given are kept, and refused where nothing lies between them and the
/// other one.
pub(super) fn depths(discs: &[Disc], pose: &Pose, given: [Option<f64>; 2]) -> Result<[f64; 2], Problem> {
    if let [Some(near), Some(far)] = given {
        return Ok([near, far]);
    }
    let forward = (pose.target - pose.eye).normalize_or(DVec3::Z);
    let range = discs.iter().fold([f64::INFINITY, 0.0_f64], |[low, high], disc| {
        let (depth, radius) = (forward.dot(disc.center - pose.eye), disc.radius());
        [low.min(depth - radius), high.max(depth + radius)]
    });
    // With nothing before the eye any two planes will do.
    let farthest = if range[1] > 0.0 { range[1] } else { 1.0 };
    let far = given[1].unwrap_or(farthest + DEPTH_MARGIN * (farthest - range[0]).abs().min(farthest));
    let near = (range[0] - DEPTH_MARGIN * (farthest - range[0])).clamp(NEAR_SHARE * far, 0.99 * far);
    match given {
        [Some(near), None] if near >= far => {
            Err(("camera.near", format!("is {near}: expected less than {far}, behind which nothing lies")))
        }
        [None, Some(far)] if range[1] > 0.0 && far <= range[0] => {
            Err(("camera.far", format!("is {far}: expected more than {}, before which nothing lies", range[0])))
        }
        [given, _] => Ok([given.unwrap_or(near), far]),
    }
}
