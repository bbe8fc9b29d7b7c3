//! The way of something rigid through world space.

use super::table::MotionTable;
use glam::{DAffine3, DQuat, DVec3, EulerRot};

/// A way, relative to where the scene has what moves.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Path {
    /// What it turns about.
    pivot: DVec3,
    way: Way,
}

#[derive(Clone, Debug)]
enum Way {
    /// Straight on, from where it is at second 0.
    Straight(DVec3),
    /// From one place to the next, in the order of time; before the first and after the last it rests.
    Keyframes(Vec<Key>),
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Key {
    time: f64,
    translation: DVec3,
    /// Angles about x, y and z in radians, each of which goes straight from one keyframe to the next: 360 degrees are a full turn.
    angles: DVec3,
}

impl Path {
    /// The way of a checked table.
    pub fn new(table: &MotionTable, pivot: DVec3) -> Self {
        let key = |keyframe: &super::table::MotionKeyframe| Key {
            time: keyframe.time,
            translation: DVec3::from_array(keyframe.translate),
            angles: DVec3::from_array(keyframe.rotate_degrees.map(f64::to_radians)),
        };
        let way = match table.velocity {
            Some(velocity) => Way::Straight(DVec3::from_array(velocity)),
            None => Way::Keyframes(table.keyframes.iter().map(key).collect()),
        };
        Self { pivot, way }
    }

    /// The same way about another place.
    pub fn about(self, pivot: DVec3) -> Self {
        Self { pivot, ..self }
    }

    fn key(keys: &[Key], time: f64) -> Key {
        let next = keys.partition_point(|key| key.time <= time);
        let (Some(from), Some(to)) = (keys.get(next.wrapping_sub(1)), keys.get(next)) else {
            return keys[next.min(keys.len() - 1)];
        };
        let share = (time - from.time) / (to.time - from.time);
        let translation = from.translation.lerp(to.translation, share);
        Key { time, translation, angles: from.angles.lerp(to.angles, share) }
    }

    /// The map from where the scene has it to where it is at a second.
    pub fn at(&self, time: f64) -> DAffine3 {
        match &self.way {
            Way::Straight(velocity) => DAffine3::from_translation(time * *velocity),
            Way::Keyframes(keys) => {
                let Key { translation, angles, .. } = Self::key(keys, time);
                let rotation = DQuat::from_euler(EulerRot::XYZEx, angles.x, angles.y, angles.z);
                let to_pivot = DAffine3::from_translation(-self.pivot);
                DAffine3::from_rotation_translation(rotation, self.pivot + translation) * to_pivot
            }
        }
    }

    /// The seconds within an exposure at which the way may turn a corner, so often that between two of them no angle changes by more than a quarter
    /// turn.
    pub fn bends(&self, [open, close]: [f64; 2]) -> Vec<f64> {
        let Way::Keyframes(keys) = &self.way else { return Vec::new() };
        let mut bends = Vec::new();
        for pair in keys.windows(2) {
            let sweep = (pair[1].angles - pair[0].angles).abs().max_element();
            let turns = (sweep / std::f64::consts::FRAC_PI_2).ceil().max(1.0);
            let at = |step: usize| pair[0].time + (pair[1].time - pair[0].time) * step as f64 / turns;
            bends.extend((0..=turns as usize).map(at).filter(|time| (open..=close).contains(time)));
        }
        bends
    }

    /// Whether it rests during an exposure.
    pub fn is_still(&self, [open, close]: [f64; 2]) -> bool {
        match &self.way {
            Way::Straight(velocity) => *velocity == DVec3::ZERO,
            Way::Keyframes(keys) => {
                let place = |time: f64| {
                    let Key { translation, angles, .. } = Self::key(keys, time);
                    (translation, angles)
                };
                let between = keys.iter().map(|key| key.time).filter(|time| (open..=close).contains(time));
                between.chain([close]).all(|time| place(time) == place(open))
            }
        }
    }
}
