//! Ways become straight parts (thesis 4.4.5): a path is halved where it bends, splat by splat.
//!
//! What a part neglects: the path's distance from its chord, up to `resample_px`; the tangents' turn from those of the part's middle, up to
//! as much at the splat's rim; the normal's, up to half of [`TURN_LIMIT`] radians, in shading; and of a splat smaller than the screen filter,
//! the change of that filter with distance, up to half of [`DISTANCE_LIMIT`].

use super::{Motion, Path, carried, eye, vector};
use crate::scene::Scene;
use glam::{DAffine3, DVec3};
use pointcore_contract::{Camera, Splat};
use pointcore_golden::reference::motion::{Interval, MovingSplat};
use rayon::prelude::*;

/// How far a splat may turn in a part, in radians: its cosine to the light then errs by an eighth at most, and by nothing in the mean.
const TURN_LIMIT: f64 = 0.25;
/// By which share of its distance from the eye a splat may come nearer or go farther in a part.
const DISTANCE_LIMIT: f64 = 0.25;
/// No part is shorter, in the exposure's time: as many parts as temporal samples of the truth.
const SHORTEST: f64 = 2.0 / 256.0;

/// The splats of a moving scene with their ways' parts, in the splats' order.
pub(super) fn moving_splats(scene: &Scene, motion: &Motion) -> Vec<MovingSplat> {
    let paths = motion.paths(scene.splats.len());
    let of_splat = |(index, path): (usize, Option<&Path>)| {
        if path.is_none() && motion.camera.is_none() {
            return vec![MovingSplat::still(scene.splats[index].clone())];
        }
        let way = Way { scene, motion, path, splat: &scene.splats[index] };
        let mut parts = Vec::new();
        for ends in motion.bends(path).windows(2) {
            way.halve(ends[0], ends[1], &mut parts);
        }
        let turned = |part: Interval| {
            let mut moving = way.moving(part);
            scene.turn_to(&mut moving.splat, index, eye(&scene.camera));
            moving
        };
        parts.into_iter().map(turned).collect()
    };
    paths.into_par_iter().enumerate().flat_map_iter(of_splat).collect()
}

/// The way of one splat, as a camera sees it that stands where it is in the middle of the exposure.
struct Way<'a> {
    scene: &'a Scene,
    motion: &'a Motion,
    path: Option<&'a Path>,
    splat: &'a Splat,
}

impl Way<'_> {
    fn map(&self, tau: f64) -> DAffine3 {
        let [object, camera] = self.motion.ways(self.path, tau);
        camera.inverse() * object
    }

    fn center(&self, tau: f64) -> DVec3 {
        self.map(tau).transform_point3(vector(&self.splat.center))
    }

    fn halve(&self, begin: f64, end: f64, parts: &mut Vec<Interval>) {
        let Some(part) = Interval::new(begin, end) else { return };
        if part.length() <= SHORTEST || self.is_straight(part, &self.scene.camera) {
            parts.push(part);
            return;
        }
        self.halve(begin, part.middle(), parts);
        self.halve(part.middle(), end, parts);
    }

    fn is_straight(&self, part: Interval, camera: &Camera) -> bool {
        let maps = [0.0, 0.25, 0.5, 0.75, 1.0].map(|share| self.map(part.begin + share * part.length()));
        let centers = maps.map(|map| map.transform_point3(vector(&self.splat.center)));
        let axis = camera.model_view[2];
        let distances = centers.map(|center| DVec3::from_slice(&axis).dot(center) + axis[3]);
        let nearest = distances.iter().copied().fold(f64::INFINITY, f64::min);
        let px = camera.scale_x.max(camera.scale_y) / nearest.max(camera.near);
        let bend = |index: usize| centers[index].distance(centers[0].lerp(centers[4], 0.25 * index as f64));
        let turn = |tangent: &[f32; 3]| {
            let [first, last] = [maps[0], maps[4]].map(|map| map.transform_vector3(vector(tangent)));
            [first.distance(last), first.length()]
        };
        let turns = self.splat.tangents.each_ref().map(turn);
        let is_near = (distances[4] - distances[0]).abs() <= DISTANCE_LIMIT * nearest.max(camera.near);
        let limit_px = self.motion.resample_px;
        (1..4).all(|index| bend(index) * px <= limit_px)
            && turns.iter().all(|[way, length]| 0.5 * way * px <= limit_px && *way <= TURN_LIMIT * length)
            && is_near
    }

    /// The splat on the chord of a part of its way.
    fn moving(&self, part: Interval) -> MovingSplat {
        let [object, camera] = self.motion.ways(self.path, part.middle());
        let mut splat = carried(self.splat, &(camera.inverse() * object), &object.matrix3);
        let [begin, end] = [part.begin, part.end].map(|tau| self.center(tau));
        splat.center = begin.midpoint(end).as_vec3().to_array();
        MovingSplat { splat, motion: (end - begin) / part.length(), part }
    }
}
