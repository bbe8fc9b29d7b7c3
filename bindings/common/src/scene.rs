//! Scenes from arrays.

use crate::BindingError;
use glam::DVec3;
use pointcore::color::linear_from_srgb;
use pointcore::scene::{Disc, Scene as SplatScene, Sides};
use std::path::Path;

/// Splats as arrays: what is not given is the same for all.
#[derive(Clone, Debug)]
pub struct Splats {
    /// Where they are.
    pub points: Vec<[f64; 3]>,
    /// Out of the surface, of any length; a splat whose normal is zero faces the eye, and so do all without any.
    pub normals: Option<Vec<[f64; 3]>>,
    /// One radius for all, or one for each.
    pub radii: Vec<f64>,
    /// sRGB in `0..=1`; white without any.
    pub colors: Option<Vec<[f64; 3]>>,
    /// Whether they are seen from behind.
    pub sides: Sides,
}

/// Where the eye is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Viewpoint {
    /// Where it sees the whole scene, from the side that shows most.
    #[default]
    Anywhere,
    /// Where it sees the whole scene from this direction.
    From([f64; 3]),
    /// Here.
    At {
        /// The eye.
        eye: [f64; 3],
        /// What it looks at.
        target: [f64; 3],
        /// The vertical opening angle.
        fov_degrees: f64,
    },
}

/// What is seen of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Where the eye is.
    pub viewpoint: Viewpoint,
    /// What is up in the image; y, unless it is said.
    pub up: Option<[f64; 3]>,
    /// sRGB in `0..=1` where there is no splat.
    pub background: [f64; 3],
    /// Frames of a full turn around the scene; one frame without a turn.
    pub frames: usize,
}

/// A scene, ready to be rendered.
#[derive(Clone, Debug)]
pub struct Scene(pub(crate) SplatScene);

impl Scene {
    /// The scene of some splats.
    ///
    /// # Errors
    /// Arrays differ in length; a value makes no sense.
    pub fn new(splats: &Splats, view: &View) -> Result<Self, BindingError> {
        let View { width, height, viewpoint, up, background, frames } = *view;
        let mut builder = SplatScene::of(discs(splats)?).image(width, height).background(background);
        builder = match viewpoint {
            Viewpoint::Anywhere => builder,
            Viewpoint::From(direction) => builder.from(direction),
            Viewpoint::At { eye, target, fov_degrees } => builder.camera(eye, target, fov_degrees),
        };
        if let Some(up) = up {
            builder = builder.up(up);
        }
        if frames != 1 {
            builder = builder.turntable(frames);
        }
        Ok(Self(builder.build()?))
    }

    /// The scene of a scene file, or of a model that a camera fits.
    ///
    /// # Errors
    /// The file or one of its models is missing or malformed.
    pub fn load(path: &Path) -> Result<Self, BindingError> {
        Ok(Self(SplatScene::load(path, &[])?))
    }

    /// Splats in it.
    #[must_use]
    pub fn splats(&self) -> usize {
        self.0.splats.len()
    }
}

fn discs(splats: &Splats) -> Result<Vec<Disc>, BindingError> {
    let Splats { points, normals, radii, colors, sides } = splats;
    let count = points.len();
    let fits = |name: &str, length: Option<usize>| match length {
        Some(length) if length != count => {
            Err(BindingError::input(format!("there are {length} {name}: expected {count}, one for each point")))
        }
        _ => Ok(()),
    };
    fits("normals", normals.as_ref().map(Vec::len))?;
    fits("colors", colors.as_ref().map(Vec::len))?;
    fits("radii", Some(radii.len()).filter(|length| *length != 1))?;
    let disc = |index: usize| {
        let radius = *radii.get(index).unwrap_or(&radii[0]);
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(BindingError::input(format!("radius {index} is {radius}: expected a positive number")));
        }
        let color = colors.as_ref().map_or([1.0; 3], |colors| colors[index]);
        if !color.iter().all(|component| (0.0..=1.0).contains(component)) {
            return Err(BindingError::input(format!("color {index} is {color:?}: expected sRGB from 0 to 1")));
        }
        let normal = normals.as_ref().map_or(DVec3::ZERO, |normals| DVec3::from_array(normals[index]));
        let disc = Disc::new(DVec3::from_array(points[index]), normal, radius);
        let sides = if disc.sides == Sides::Eye { Sides::Eye } else { *sides };
        Ok(Disc { sides, color: color.map(|component| linear_from_srgb(component) as f32), ..disc })
    };
    (0..count).map(disc).collect()
}
