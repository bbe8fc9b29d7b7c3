//! Scenes from arrays.

use crate::BindingError;
use glam::DVec3;
use pointcore::color::linear_from_srgb;
use pointcore::scene::{Disc, Scene as SplatScene, Sides, Triangle};
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

/// Triangles as arrays, which are drawn before the splats and hide what lies behind them; seen from both sides.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// Where its vertices are.
    pub vertices: Vec<[f64; 3]>,
    /// Of each triangle the indices of its vertices.
    pub faces: Vec<[u32; 3]>,
    /// Of the vertices, of any length; the means of those of the faces without any.
    pub normals: Option<Vec<[f64; 3]>>,
    /// sRGB in `0..=1` of the vertices; white without any.
    pub colors: Option<Vec<[f64; 3]>>,
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
    /// The scene of some splats, and of triangles beside them.
    ///
    /// # Errors
    /// Arrays differ in length; a value makes no sense.
    pub fn new(splats: &Splats, mesh: Option<&Mesh>, view: &View) -> Result<Self, BindingError> {
        let View { width, height, viewpoint, up, background, frames } = *view;
        let mut builder = SplatScene::of(discs(splats)?).image(width, height).background(background);
        if let Some(mesh) = mesh {
            builder = builder.triangles(triangles(mesh)?);
        }
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

/// That there is one for each, where there are any.
fn fits(name: &str, length: Option<usize>, count: usize, each: &str) -> Result<(), BindingError> {
    match length {
        Some(length) if length != count => {
            Err(BindingError::input(format!("there are {length} {name}: expected {count}, one for each {each}")))
        }
        _ => Ok(()),
    }
}

/// Linear RGB of sRGB, white where there is none.
fn linear(name: &str, colors: Option<&Vec<[f64; 3]>>, index: usize) -> Result<[f32; 3], BindingError> {
    let color = colors.map_or([1.0; 3], |colors| colors[index]);
    if !color.iter().all(|component| (0.0..=1.0).contains(component)) {
        return Err(BindingError::input(format!("{name} {index} is {color:?}: expected sRGB from 0 to 1")));
    }
    Ok(color.map(|component| linear_from_srgb(component) as f32))
}

fn triangles(mesh: &Mesh) -> Result<Vec<Triangle>, BindingError> {
    let Mesh { vertices, faces, normals, colors } = mesh;
    let count = vertices.len();
    fits("vertex normals", normals.as_ref().map(Vec::len), count, "vertex")?;
    fits("vertex colors", colors.as_ref().map(Vec::len), count, "vertex")?;
    let is_finite = |vertex: &[f64; 3]| vertex.iter().all(|coordinate| coordinate.is_finite());
    if let Some(index) = vertices.iter().position(|vertex| !is_finite(vertex)) {
        return Err(BindingError::input(format!("vertex {index} is {:?}: expected finite numbers", vertices[index])));
    }
    let colors: Vec<_> =
        (0..count).map(|index| linear("vertex color", colors.as_ref(), index)).collect::<Result<_, _>>()?;
    let vectors = |rows: &[[f64; 3]]| rows.iter().map(|row| DVec3::from_array(*row)).collect::<Vec<_>>();
    let normals = normals.as_deref().map(vectors);
    Triangle::of_faces(&vectors(vertices), faces, normals.as_deref(), |index| colors[index])
        .map_err(BindingError::input)
}

fn discs(splats: &Splats) -> Result<Vec<Disc>, BindingError> {
    let Splats { points, normals, radii, colors, sides } = splats;
    let count = points.len();
    fits("normals", normals.as_ref().map(Vec::len), count, "point")?;
    fits("colors", colors.as_ref().map(Vec::len), count, "point")?;
    fits("radii", Some(radii.len()).filter(|length| *length != 1), count, "point")?;
    let disc = |index: usize| {
        let radius = *radii.get(index).unwrap_or(&radii[0]);
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(BindingError::input(format!("radius {index} is {radius}: expected a positive number")));
        }
        let color = linear("color", colors.as_ref(), index)?;
        let normal = normals.as_ref().map_or(DVec3::ZERO, |normals| DVec3::from_array(normals[index]));
        let disc = Disc::new(DVec3::from_array(points[index]), normal, radius);
        let sides = if disc.sides == Sides::Eye { Sides::Eye } else { *sides };
        Ok(Disc { sides, color, ..disc })
    };
    (0..count).map(disc).collect()
}
