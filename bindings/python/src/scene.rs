//! Scenes.

use crate::arguments::{number_or_column, rows, triples, whole};
use crate::error::{detached, wrong};
use pointcore_bindings::{Mesh, Sides, Splats, View, Viewpoint};
use pyo3::prelude::*;
use std::path::PathBuf;

/// The opening angle of a camera of which none is said, as in scene files.
const FOV_DEGREES: f64 = 30.0;

/// A scene, ready to be rendered.
#[pyclass(frozen, module = "pointcore")]
pub struct Scene(pub pointcore_bindings::Scene);

/// Where the eye is, of what may be said about it.
fn viewpoint(
    eye: Option<[f64; 3]>,
    target: Option<[f64; 3]>,
    fov_degrees: Option<f64>,
    direction: Option<[f64; 3]>,
) -> PyResult<Viewpoint> {
    match (eye, direction) {
        (Some(_), Some(_)) => Err(wrong("eye and direction are both given: expected one of them".to_owned())),
        (Some(eye), None) => Ok(Viewpoint::At {
            eye,
            target: target.unwrap_or_default(),
            fov_degrees: fov_degrees.unwrap_or(FOV_DEGREES),
        }),
        (None, _) if target.is_some() || fov_degrees.is_some() => {
            Err(wrong("target and fov_degrees go with an eye".to_owned()))
        }
        (None, Some(direction)) => Ok(Viewpoint::From(direction)),
        (None, None) => Ok(Viewpoint::Anywhere),
    }
}

/// Triangles beside the splats, if there are any.
fn mesh(
    vertices: Option<&Bound<'_, PyAny>>,
    faces: Option<&Bound<'_, PyAny>>,
    normals: Option<&Bound<'_, PyAny>>,
    colors: Option<&Bound<'_, PyAny>>,
) -> PyResult<Option<Mesh>> {
    match (vertices, faces) {
        (Some(vertices), Some(faces)) => Ok(Some(Mesh {
            vertices: rows("vertices", vertices)?,
            faces: triples("faces", faces)?,
            normals: normals.map(|normals| rows("vertex_normals", normals)).transpose()?,
            colors: colors.map(|colors| rows("vertex_colors", colors)).transpose()?,
        })),
        (None, None) if normals.is_none() && colors.is_none() => Ok(None),
        _ => Err(wrong("triangles need vertices and faces: expected both, or neither".to_owned())),
    }
}

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (points, radii, normals=None, colors=None, *, two_sided=false, vertices=None, faces=None,
        vertex_normals=None, vertex_colors=None, width=512, height=512, background=[0.0; 3], eye=None, target=None,
        fov_degrees=None, direction=None, up=None, frames=1))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn new(
        points: &Bound<'_, PyAny>,
        radii: &Bound<'_, PyAny>,
        normals: Option<&Bound<'_, PyAny>>,
        colors: Option<&Bound<'_, PyAny>>,
        two_sided: bool,
        vertices: Option<&Bound<'_, PyAny>>,
        faces: Option<&Bound<'_, PyAny>>,
        vertex_normals: Option<&Bound<'_, PyAny>>,
        vertex_colors: Option<&Bound<'_, PyAny>>,
        width: i64,
        height: i64,
        background: [f64; 3],
        eye: Option<[f64; 3]>,
        target: Option<[f64; 3]>,
        fov_degrees: Option<f64>,
        direction: Option<[f64; 3]>,
        up: Option<[f64; 3]>,
        frames: i64,
    ) -> PyResult<Self> {
        let splats = Splats {
            points: rows("points", points)?,
            normals: normals.map(|normals| rows("normals", normals)).transpose()?,
            radii: number_or_column("radii", radii)?,
            colors: colors.map(|colors| rows("colors", colors)).transpose()?,
            sides: if two_sided { Sides::Both } else { Sides::Front },
        };
        let view = View {
            width: whole("width", width)?,
            height: whole("height", height)?,
            viewpoint: viewpoint(eye, target, fov_degrees, direction)?,
            up,
            background,
            frames: whole("frames", frames)?,
        };
        let mesh = mesh(vertices, faces, vertex_normals, vertex_colors)?;
        detached(points.py(), || pointcore_bindings::Scene::new(&splats, mesh.as_ref(), &view)).map(Self)
    }

    /// Loads a scene file, or a model that a camera fits.
    #[staticmethod]
    fn load(python: Python<'_>, path: PathBuf) -> PyResult<Self> {
        detached(python, || pointcore_bindings::Scene::load(&path)).map(Self)
    }

    /// Splats in it.
    fn __len__(&self) -> usize {
        self.0.splats()
    }
}
