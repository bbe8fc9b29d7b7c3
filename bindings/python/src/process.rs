//! Programs on neighborhoods.

use crate::arguments::{Configuration, back_end, named, rows, whole};
use crate::error::{detached, wrong};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pointcore_bindings::{BackEnd, Points, ProcessSettings, ProgramSource, Results, Values};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;

/// A program, and what carries it out.
#[pyclass(frozen, module = "pointcore")]
pub struct ProcessSession(pointcore_bindings::Process);

/// What left with queries.
#[pyclass(frozen, get_all, module = "pointcore")]
pub struct Processed {
    outputs: Py<PyDict>,
    positions: Py<PyArray2<f64>>,
    iterations: Py<PyArray1<u32>>,
    neighbors: Option<Py<PyArray1<u32>>>,
    capped: Py<PyArray1<bool>>,
    cycles: Option<u64>,
    report: Py<PyAny>,
}

/// A program: said, or a file's path.
#[derive(FromPyObject)]
pub enum Program {
    /// A name, a path or a text.
    #[pyo3(transparent)]
    Said(String),
    /// A path.
    #[pyo3(transparent)]
    File(PathBuf),
}

/// What is asked of a program, as Python passes it.
struct Asked {
    points: Points,
    queries: Option<Points>,
    settings: ProcessSettings,
}

impl ProcessSession {
    fn open(python: Python<'_>, program: &Program, back_end: BackEnd, config: Option<Configuration>) -> PyResult<Self> {
        let config = config.map(|config| config.text());
        let program = match program {
            Program::Said(text) => ProgramSource::Said(text),
            Program::File(path) => ProgramSource::File(path),
        };
        detached(python, || pointcore_bindings::Process::open(program, config.as_deref(), back_end)).map(Self)
    }

    fn run(&self, python: Python<'_>, asked: Asked) -> PyResult<Processed> {
        let Asked { points, queries, settings } = asked;
        let results = detached(python, || self.0.run(&points, queries.as_ref(), &settings))?;
        Processed::of(python, results)
    }
}

impl Asked {
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn of(
        points: &Bound<'_, PyAny>,
        k: Option<i64>,
        radius: Option<f64>,
        iterations: i64,
        passes: i64,
        queries: Option<&Bound<'_, PyAny>>,
        attributes: Option<&Bound<'_, PyDict>>,
        query_attributes: Option<&Bound<'_, PyDict>>,
        settings: Option<&Bound<'_, PyDict>>,
        pattern: Option<[i64; 2]>,
    ) -> PyResult<Self> {
        if queries.is_none() && query_attributes.is_some() {
            return Err(wrong("query_attributes go with queries: points have attributes".to_owned()));
        }
        let queries = queries.map(|queries| {
            let attributes = named("query_attributes", query_attributes)?;
            Ok::<_, PyErr>(Points { places: rows("queries", queries)?, attributes })
        });
        let side = |side: i64| whole("a side of the pattern", side);
        let pattern = pattern.map(|[columns, rows]| Ok::<_, PyErr>([side(columns)?, side(rows)?]));
        Ok(Self {
            points: Points { places: rows("points", points)?, attributes: named("attributes", attributes)? },
            queries: queries.transpose()?,
            settings: ProcessSettings {
                k: k.map(|k| whole("k", k)).transpose()?,
                radius,
                iterations: whole("iterations", iterations)?,
                passes: whole("passes", passes)?,
                pattern: pattern.transpose()?,
                settings: named("settings", settings)?,
            },
        })
    }
}

impl Processed {
    fn of(python: Python<'_>, results: Results) -> PyResult<Self> {
        let outputs = PyDict::new(python);
        let count = results.positions.len();
        for output in results.outputs {
            let shape = [count, output.components];
            let array = match output.numbers {
                Values::Double(numbers) => PyArray1::from_vec(python, numbers).into_any(),
                Values::Float(numbers) => PyArray1::from_vec(python, numbers).into_any(),
                Values::Int(numbers) => PyArray1::from_vec(python, numbers).into_any(),
                Values::Bool(flags) => PyArray1::from_vec(python, flags).into_any(),
            };
            let array = if output.components == 1 { array } else { array.call_method1("reshape", (shape,))? };
            outputs.set_item(output.name, array)?;
        }
        let positions = PyArray1::from_vec(python, results.positions.into_flattened()).reshape([count, 3])?;
        Ok(Self {
            outputs: outputs.unbind(),
            positions: positions.unbind(),
            iterations: PyArray1::from_vec(python, results.iterations).unbind(),
            neighbors: results.neighbors.map(|counts| PyArray1::from_vec(python, counts).unbind()),
            capped: PyArray1::from_vec(python, results.capped).unbind(),
            cycles: results.cycles,
            report: python.import("json")?.call_method1("loads", (results.report,))?.unbind(),
        })
    }
}

#[pymethods]
impl Processed {
    /// Whether each query says that its results are valid; None if the program does not say.
    #[getter]
    fn valid<'py>(&self, python: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.outputs.bind(python).get_item("valid")
    }

    /// An output.
    fn __getitem__<'py>(&self, python: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        self.outputs.bind(python).as_any().get_item(name)
    }
}

#[pymethods]
impl ProcessSession {
    #[new]
    #[pyo3(signature = (program, *, backend="interpreter", lockstep=false, config=None))]
    fn new(
        python: Python<'_>,
        program: Program,
        backend: &str,
        lockstep: bool,
        config: Option<Configuration>,
    ) -> PyResult<Self> {
        Self::open(python, &program, back_end(backend, lockstep)?, config)
    }

    /// Carries the program out for each point, or for each query.
    #[pyo3(signature = (points, k=None, radius=None, *, iterations=16, passes=1, queries=None, attributes=None,
        query_attributes=None, settings=None, pattern=None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn process(
        &self,
        points: &Bound<'_, PyAny>,
        k: Option<i64>,
        radius: Option<f64>,
        iterations: i64,
        passes: i64,
        queries: Option<&Bound<'_, PyAny>>,
        attributes: Option<&Bound<'_, PyDict>>,
        query_attributes: Option<&Bound<'_, PyDict>>,
        settings: Option<&Bound<'_, PyDict>>,
        pattern: Option<[i64; 2]>,
    ) -> PyResult<Processed> {
        let asked =
            Asked::of(points, k, radius, iterations, passes, queries, attributes, query_attributes, settings, pattern)?;
        self.run(points.py(), asked)
    }
}

/// Carries a program out for each point, or for each query.
#[pyfunction]
#[pyo3(signature = (points, program, k=None, radius=None, *, iterations=16, passes=1, queries=None, attributes=None,
    query_attributes=None, settings=None, pattern=None, backend="interpreter", lockstep=false, config=None))]
#[expect(clippy::too_many_arguments, reason = "Python names them")]
pub fn process(
    points: &Bound<'_, PyAny>,
    program: Program,
    k: Option<i64>,
    radius: Option<f64>,
    iterations: i64,
    passes: i64,
    queries: Option<&Bound<'_, PyAny>>,
    attributes: Option<&Bound<'_, PyDict>>,
    query_attributes: Option<&Bound<'_, PyDict>>,
    settings: Option<&Bound<'_, PyDict>>,
    pattern: Option<[i64; 2]>,
    backend: &str,
    lockstep: bool,
    config: Option<Configuration>,
) -> PyResult<Processed> {
    let asked =
        Asked::of(points, k, radius, iterations, passes, queries, attributes, query_attributes, settings, pattern)?;
    ProcessSession::open(points.py(), &program, back_end(backend, lockstep)?, config)?.run(points.py(), asked)
}
