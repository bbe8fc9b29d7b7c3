//! Scenes that move while the shutter is open.
//!
//! A moving scene's splats and camera are those of the middle of the exposure. [`Motion`] says where they are at any other time of it, and
//! [`Scene::moving_splats`] has each splat's way as straight parts. A camera that moves is a world that moves the other way: the camera of the
//! reference stands still. Lights do not move with it.

mod check;
mod path;
mod resample;
mod table;

pub(super) use check::check;
pub(super) use path::Path;
pub(super) use table::{MotionTable, ShutterTable};

use super::camera::Pose;
use super::disc::{Disc, Placement, turn};
use super::file::SceneFile;
use super::{Scene, Splat};
use glam::{DAffine3, DMat3, DVec3};
use pointcore_contract::Camera;
use pointcore_contract::surface::NORMAL;
use pointcore_golden::reference::motion::{Interval, Method, MovingSplat, Shutter};
use std::ops::Range;

/// Instants of the exposure, its ends among them, at which a camera that is put around a scene looks where it is.
const INSTANTS: usize = 9;
/// A quarter of what the screen filter smooths over.
const RESAMPLE_PX: f64 = 0.25;

/// What moves in a scene while the shutter is open, and how that is drawn.
#[derive(Clone, Debug)]
pub struct Motion {
    /// How light counts over the exposure.
    pub shutter: Shutter,
    /// How it is settled what hides what; `None` where the scene leaves it open.
    pub method: Option<Method>,
    /// How far a path may lie from its straight parts, and a splat's rim from where it is drawn, px.
    resample_px: f64,
    /// When the shutter opens and closes, in seconds.
    exposure: [f64; 2],
    /// The splats of each object that moves, and its way through world space.
    objects: Vec<(Range<usize>, Path)>,
    camera: Option<Path>,
    placement: Placement,
}

impl Motion {
    /// What of a checked scene moves; `spans` are the objects' discs. `None` where all stands still while the shutter is open.
    pub(super) fn of(file: &SceneFile, spans: &[Range<usize>], method: Option<Method>) -> Option<Self> {
        let shutter = file.shutter.as_ref()?;
        let exposure = [shutter.open, shutter.close];
        let moving = |table: &Option<MotionTable>, pivot: DVec3| {
            table.as_ref().map(|table| Path::new(table, pivot)).filter(|path| !path.is_still(exposure))
        };
        let objects = file.objects.iter().zip(spans).filter_map(|(object, span)| {
            Some((span.clone(), moving(&object.motion, DVec3::from_array(object.translate))?))
        });
        let objects: Vec<_> = objects.collect();
        // Its eye is not known yet.
        let camera = moving(&file.camera.motion, DVec3::ZERO);
        let shape = shutter.shape.into();
        let placement = Placement::WORLD;
        let is_moving = !objects.is_empty() || camera.is_some();
        let resample_px = file.splatting.resample_px.unwrap_or(RESAMPLE_PX);
        is_moving.then_some(Self { shutter: shape, method, resample_px, exposure, objects, camera, placement })
    }

    /// How f64 settles what hides what: exactly, unless the scene says otherwise.
    #[must_use]
    pub fn reference_method(&self) -> Method {
        self.method.unwrap_or(Method::Exact)
    }

    /// The same, of splats that are placed so.
    pub(super) fn placed(self, placement: Placement) -> Self {
        Self { placement, ..self }
    }

    /// Takes the camera's motion out until its eye is known, which it turns about.
    pub(super) fn take_camera(&mut self) -> Option<Path> {
        self.camera.take()
    }

    /// Has the camera move about its eye.
    pub(super) fn give_camera(&mut self, path: Option<Path>, eye: DVec3) {
        self.camera = path.map(|path| path.about(eye));
    }

    fn time(&self, tau: f64) -> f64 {
        let [open, close] = self.exposure;
        open + (close - open) * 0.5 * (tau + 1.0)
    }

    /// Moves discs as they stand in the file to where they are in the middle of the exposure.
    pub(super) fn move_to_middle(&self, discs: &mut [Disc]) {
        for (span, path) in &self.objects {
            let map = path.at(self.time(0.0));
            discs[span.clone()].iter_mut().for_each(|disc| *disc = moved(disc, &map));
        }
    }

    /// The camera's pose in the middle of the exposure.
    pub(super) fn pose(&self, pose: &Pose) -> Pose {
        let Some(path) = &self.camera else { return *pose };
        let map = path.at(self.time(0.0));
        let [eye, target] = [pose.eye, pose.target].map(|place| map.transform_point3(place));
        Pose { eye, target, up: map.transform_vector3(pose.up), ..*pose }
    }

    /// The discs of several instants together, as they lie about where the camera is in the middle of the exposure.
    pub(super) fn of_all_instants(&self, discs: &[Disc]) -> Vec<Disc> {
        let instants = (0..INSTANTS).map(|index| -1.0 + 2.0 * index as f64 / (INSTANTS - 1) as f64);
        let of_instant = |tau: f64| {
            let mut discs = discs.to_vec();
            let back = self.camera_way(tau).inverse();
            discs.iter_mut().for_each(|disc| *disc = moved(disc, &back));
            for (span, path) in &self.objects {
                let map = back * self.way(path, tau) * back.inverse();
                discs[span.clone()].iter_mut().for_each(|disc| *disc = moved(disc, &map));
            }
            discs
        };
        instants.flat_map(of_instant).collect()
    }

    /// From where a place is in the middle of the exposure to where its path has it at `τ`, in world space.
    fn way(&self, path: &Path, tau: f64) -> DAffine3 {
        path.at(self.time(tau)) * path.at(self.time(0.0)).inverse()
    }

    fn camera_way(&self, tau: f64) -> DAffine3 {
        self.camera.as_ref().map_or(DAffine3::IDENTITY, |path| self.way(path, tau))
    }

    /// A map of world space as one of splats' coordinates.
    fn in_splats(&self, map: DAffine3) -> DAffine3 {
        let Placement { origin, unit } = self.placement;
        DAffine3 { matrix3: map.matrix3, translation: (map.transform_point3(origin) - origin) / unit }
    }

    /// The object's way at `τ`, and the camera's, in splats' coordinates.
    fn ways(&self, path: Option<&Path>, tau: f64) -> [DAffine3; 2] {
        let object = path.map_or(DAffine3::IDENTITY, |path| self.way(path, tau));
        [object, self.camera_way(tau)].map(|way| self.in_splats(way))
    }

    /// The times at which a path may bend, in the exposure's own time, its ends among them.
    fn bends(&self, path: Option<&Path>) -> Vec<f64> {
        let [open, close] = self.exposure;
        let of_paths = path.into_iter().chain(&self.camera).flat_map(|path| path.bends(self.exposure));
        let mut bends: Vec<f64> = of_paths.map(|time| 2.0 * (time - open) / (close - open) - 1.0).collect();
        bends.extend([-1.0, 1.0]);
        bends.sort_by(f64::total_cmp);
        bends.dedup();
        bends
    }

    /// The path of each splat, `None` where its object stands still.
    fn paths(&self, splats: usize) -> Vec<Option<&Path>> {
        let mut paths = vec![None; splats];
        for (span, path) in &self.objects {
            paths[span.clone()].fill(Some(path));
        }
        paths
    }
}

fn moved(disc: &Disc, map: &DAffine3) -> Disc {
    let turned = |vector| map.transform_vector3(vector);
    Disc {
        center: map.transform_point3(disc.center),
        tangents: disc.tangents.map(turned),
        normal: turned(disc.normal),
        ..disc.clone()
    }
}

fn vector(numbers: &[f32]) -> DVec3 {
    DVec3::new(numbers[0].into(), numbers[1].into(), numbers[2].into())
}

/// A splat carried along: its place by one map, its normal by another.
fn carried(splat: &Splat, map: &DAffine3, normals: &DMat3) -> Splat {
    let single = |vector: DVec3| vector.as_vec3().to_array();
    let mut carried = Splat {
        center: single(map.transform_point3(vector(&splat.center))),
        tangents: splat.tangents.map(|tangent| single(map.transform_vector3(vector(&tangent)))),
        ..splat.clone()
    };
    let normal = *normals * vector(&splat.attributes[NORMAL]);
    carried.attributes[NORMAL].copy_from_slice(&single(normal));
    carried
}

impl Scene {
    /// Splats and camera at a time `τ` of the exposure, −1 where the shutter opens and 1 where it closes.
    #[must_use]
    pub fn at(&self, tau: f64) -> (Vec<Splat>, Camera) {
        let Some(motion) = &self.motion else { return (self.splats.clone(), self.camera) };
        let camera = moved_camera(&self.camera, &motion.in_splats(motion.camera_way(tau)));
        let eye = eye(&camera);
        let mut splats = self.splats.clone();
        for (span, path) in &motion.objects {
            let way = motion.in_splats(motion.way(path, tau));
            splats[span.clone()].iter_mut().for_each(|splat| *splat = carried(splat, &way, &way.matrix3));
        }
        (0..splats.len()).for_each(|index| self.turn_to(&mut splats[index], index, eye));
        (splats, camera)
    }

    /// The splats of a moving scene with the straight parts of their ways, in their order.
    #[must_use]
    pub fn moving_splats(&self) -> Vec<MovingSplat> {
        let Some(motion) = &self.motion else {
            return self.splats.iter().cloned().map(MovingSplat::still).collect();
        };
        resample::moving_splats(self, motion)
    }

    /// What stands still for all of the exposure, if anything does, as a scene of its own.
    #[must_use]
    pub fn still_part(&self) -> Option<Self> {
        let still = self.moving_splats().into_iter().filter(MovingSplat::is_still).map(|still| still.splat);
        let splats: Vec<_> = still.collect();
        // They have turned to the eye already.
        (!splats.is_empty()).then(|| Self { splats, sides: Vec::new(), motion: None, ..self.clone() })
    }

    /// What moves, with the straight parts of its ways, each of which lies in one of so many bins of the exposure.
    #[must_use]
    pub fn moving_part(&self, bins: usize) -> Vec<MovingSplat> {
        let in_bins = |moving: MovingSplat| {
            Interval::equal_parts(bins).filter_map(move |bin| {
                let part = moving.part.intersection(bin)?;
                if part == moving.part {
                    return Some(moving.clone());
                }
                let way = (part.middle() - moving.part.middle()) * moving.motion;
                let center = (vector(&moving.splat.center) + way).as_vec3().to_array();
                Some(MovingSplat { splat: Splat { center, ..moving.splat.clone() }, part, ..moving })
            })
        };
        self.moving_splats().into_iter().filter(|moving| !moving.is_still()).flat_map(in_bins).collect()
    }

    /// Turns a splat to an eye if it is one that is seen from either side.
    fn turn_to(&self, splat: &mut Splat, index: usize, eye: DVec3) {
        if let Some(sides) = self.sides.get(index) {
            turn(splat, *sides, eye);
            if !self.is_lit() {
                splat.attributes[NORMAL].fill(0.0);
            }
        }
    }
}

fn eye(camera: &Camera) -> DVec3 {
    // A rotation's inverse is its transpose.
    camera.model_view.iter().map(|row| -row[3] * DVec3::from_slice(row)).sum()
}

/// A camera carried along by a rigid map.
fn moved_camera(camera: &Camera, way: &DAffine3) -> Camera {
    let back = way.inverse();
    let model_view = camera.model_view.map(|row| {
        let axis = DVec3::from_slice(&row);
        let turned = back.matrix3.transpose() * axis;
        [turned.x, turned.y, turned.z, row[3] + axis.dot(back.translation)]
    });
    Camera { model_view, ..*camera }
}

#[cfg(test)]
mod tests;
