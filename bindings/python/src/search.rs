//! Neighbor search.

use crate::arguments::{Configuration, back_end, rows, whole};
use crate::error::detached;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pointcore_bindings::{BackEnd, SearchSettings};
use pyo3::prelude::*;

/// Points in a tree, and a core that searches it.
#[pyclass(frozen, module = "pointcore")]
pub struct SearchSession {
    search: pointcore_bindings::Search,
    k: u32,
}

/// Neighbors of some queries.
#[pyclass(frozen, get_all, module = "pointcore")]
pub struct Found {
    indices: Py<PyArray2<i64>>,
    distances2: Py<PyArray2<f32>>,
    counts: Py<PyArray1<u32>>,
    cycles: u64,
}

impl SearchSession {
    fn open(points: &Bound<'_, PyAny>, k: u32, back_end: BackEnd, config: Option<Configuration>) -> PyResult<Self> {
        let (python, points, config) = (points.py(), rows("points", points)?, config.map(|config| config.text()));
        let settings = SearchSettings { k, configuration: config.as_deref(), back_end };
        let search = detached(python, || pointcore_bindings::Search::open(points, settings))?;
        Ok(Self { search, k })
    }

    fn found(&self, queries: &Bound<'_, PyAny>, k: u32, radius: Option<f64>) -> PyResult<Found> {
        let (python, queries) = (queries.py(), rows("queries", queries)?);
        let shape = [queries.len(), k as usize];
        let found = detached(python, || self.search.search(&queries, k, radius))?;
        Ok(Found {
            indices: PyArray1::from_vec(python, found.indices).reshape(shape)?.unbind(),
            distances2: PyArray1::from_vec(python, found.distances2).reshape(shape)?.unbind(),
            counts: PyArray1::from_vec(python, found.counts).unbind(),
            cycles: found.cycles,
        })
    }
}

#[pymethods]
impl SearchSession {
    #[new]
    #[pyo3(signature = (points, k=10, *, backend="golden", lockstep=false, config=None))]
    fn new(
        points: &Bound<'_, PyAny>,
        k: i64,
        backend: &str,
        lockstep: bool,
        config: Option<Configuration>,
    ) -> PyResult<Self> {
        Self::open(points, whole("k", k)?, back_end(backend, lockstep)?, config)
    }

    /// The nearest k neighbors of each query, or those of them within a radius.
    #[pyo3(signature = (queries, k=None, radius=None))]
    fn search(&self, queries: &Bound<'_, PyAny>, k: Option<i64>, radius: Option<f64>) -> PyResult<Found> {
        let k = k.map_or(Ok(self.k), |k| whole("k", k))?;
        self.found(queries, k, radius)
    }
}

/// The nearest k points of each query, or those of them within a radius.
#[pyfunction]
#[pyo3(signature = (points, queries, k=10, radius=None, *, backend="golden", lockstep=false, config=None))]
pub fn search(
    points: &Bound<'_, PyAny>,
    queries: &Bound<'_, PyAny>,
    k: i64,
    radius: Option<f64>,
    backend: &str,
    lockstep: bool,
    config: Option<Configuration>,
) -> PyResult<Found> {
    let k = whole("k", k)?;
    SearchSession::open(points, k, back_end(backend, lockstep)?, config)?.found(queries, k, radius)
}
