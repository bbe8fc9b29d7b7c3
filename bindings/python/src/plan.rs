//! Which hardware something calls for, and its files.

use crate::arguments::{Configuration, rows, whole};
use crate::error::detached;
use crate::scene::Scene;
use pyo3::prelude::*;
use std::path::PathBuf;

/// Hardware that something calls for.
#[pyclass(frozen, module = "pointcore")]
pub struct Plan(pub pointcore_bindings::Plan);

#[pymethods]
impl Plan {
    /// What was chosen and why, and what it takes, for people.
    #[getter]
    fn text(&self) -> &str {
        self.0.text()
    }

    /// The hardware's configuration as TOML.
    #[getter]
    fn toml(&self) -> String {
        self.0.toml()
    }

    fn __str__(&self) -> &str {
        self.0.text()
    }
}

/// Plans the renderer for a scene, or the search core for points and up to k neighbors of each query.
#[pyfunction]
#[pyo3(signature = (what, k=10))]
pub fn plan(python: Python<'_>, what: &Bound<'_, PyAny>, k: i64) -> PyResult<Plan> {
    if let Ok(scene) = what.cast::<Scene>() {
        let scene = &scene.get().0;
        return detached(python, || pointcore_bindings::Plan::scene(scene)).map(Plan);
    }
    let (points, k) = (rows("points", what)?.len(), whole("k", k)?);
    detached(python, || pointcore_bindings::Plan::search(points, k)).map(Plan)
}

/// Writes the Verilog of a configuration and what goes with it into a folder; returns the files' paths.
#[pyfunction]
#[pyo3(signature = (config, folder, name="pointcore"))]
pub fn generate(python: Python<'_>, config: Configuration, folder: PathBuf, name: &str) -> PyResult<Vec<PathBuf>> {
    let config = config.text();
    detached(python, || pointcore_bindings::generate(&config, &folder, name))
}
