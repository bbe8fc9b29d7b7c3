//! Rendering.

use crate::arguments::{Configuration, back_end, whole};
use crate::error::detached;
use crate::scene::Scene;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pointcore_bindings::BackEnd;
use pyo3::prelude::*;

/// A scene, and the core that renders it.
#[pyclass(frozen, module = "pointcore")]
pub struct RenderSession(pointcore_bindings::Render);

/// A frame.
#[pyclass(frozen, get_all, module = "pointcore")]
pub struct Frame {
    color: Py<PyArray3<f32>>,
    depth: Py<PyArray2<f32>>,
    normal: Py<PyArray3<f32>>,
    mask: Py<PyArray2<bool>>,
    picture: Py<PyArray3<u8>>,
    cycles: u64,
    report: Py<PyAny>,
}

impl RenderSession {
    fn open(python: Python<'_>, scene: &Scene, back_end: BackEnd, config: Option<Configuration>) -> PyResult<Self> {
        let config = config.map(|config| config.text());
        detached(python, || pointcore_bindings::Render::open(&scene.0, config.as_deref(), back_end)).map(Self)
    }

    fn rendered(&self, python: Python<'_>, index: usize) -> PyResult<Frame> {
        let frame = detached(python, || self.0.frame(index))?;
        let (shape, [width, height]) = ([frame.height, frame.width], frame.picture_size);
        let of_three = |numbers| PyArray1::from_vec(python, numbers).reshape([shape[0], shape[1], 3]);
        let mask = frame.mask.iter().map(|sample| *sample == 1).collect();
        Ok(Frame {
            color: of_three(frame.color)?.unbind(),
            depth: PyArray1::from_vec(python, frame.depth).reshape(shape)?.unbind(),
            normal: of_three(frame.normal)?.unbind(),
            mask: PyArray1::from_vec(python, mask).reshape(shape)?.unbind(),
            picture: PyArray1::from_vec(python, frame.picture).reshape([height, width, 3])?.unbind(),
            cycles: frame.cycles,
            report: python.import("json")?.call_method1("loads", (frame.report,))?.unbind(),
        })
    }
}

#[pymethods]
impl RenderSession {
    #[new]
    #[pyo3(signature = (scene, *, backend="golden", lockstep=false, config=None))]
    fn new(
        python: Python<'_>,
        scene: &Scene,
        backend: &str,
        lockstep: bool,
        config: Option<Configuration>,
    ) -> PyResult<Self> {
        Self::open(python, scene, back_end(backend, lockstep)?, config)
    }

    /// Frames of the scene's sequence.
    fn __len__(&self) -> usize {
        self.0.frames()
    }

    /// Renders a frame of the sequence, which counts from 0.
    #[pyo3(signature = (index=0))]
    fn frame(&self, python: Python<'_>, index: i64) -> PyResult<Frame> {
        self.rendered(python, whole("index", index)?)
    }
}

/// Renders a scene's first frame.
#[pyfunction]
#[pyo3(signature = (scene, *, backend="golden", lockstep=false, config=None))]
pub fn render(
    python: Python<'_>,
    scene: &Scene,
    backend: &str,
    lockstep: bool,
    config: Option<Configuration>,
) -> PyResult<Frame> {
    RenderSession::open(python, scene, back_end(backend, lockstep)?, config)?.rendered(python, 0)
}
