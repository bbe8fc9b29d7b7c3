//! Motion as a scene file writes it.

use pointcore_golden::reference::motion::Shutter;
use serde::Deserialize;

/// When the shutter is open.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::scene) struct ShutterTable {
    /// Seconds.
    pub open: f64,
    /// Seconds.
    pub close: f64,
    #[serde(default)]
    pub shape: Shape,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(in crate::scene) enum Shape {
    #[default]
    Box,
    Gaussian,
}

impl From<Shape> for Shutter {
    fn from(shape: Shape) -> Self {
        match shape {
            Shape::Box => Self::Box,
            Shape::Gaussian => Self::Gaussian,
        }
    }
}

/// How an object, or the camera, leaves the place that the scene gives it.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(in crate::scene) struct MotionTable {
    /// World units a second; at second 0 it is where the scene has it.
    pub velocity: Option<[f64; 3]>,
    #[serde(rename = "keyframe")]
    pub keyframes: Vec<MotionKeyframe>,
}

/// A place on the way.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::scene) struct MotionKeyframe {
    /// Seconds.
    pub time: f64,
    #[serde(default)]
    pub translate: [f64; 3],
    /// About the fixed axes x, then y, then z, through the object's `translate`, or the camera's eye.
    #[serde(default)]
    pub rotate_degrees: [f64; 3],
}
