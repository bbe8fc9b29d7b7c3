//! What Python passes: arrays of any strides, numbers, configurations.

use crate::error::{raised, wrong};
use crate::plan::Plan;
use numpy::{PyArrayDyn, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
use pointcore_bindings::BackEnd;
use pyo3::prelude::*;
use pyo3::types::IntoPyDict;

/// The numbers of an array in the order of its indices, and its shape.
fn numbers(name: &str, given: &Bound<'_, PyAny>, shape: &str) -> PyResult<(Vec<f64>, Vec<usize>)> {
    let Ok(array) = given.cast::<PyUntypedArray>() else {
        let found = given.get_type().name()?;
        return Err(wrong(format!("{name} is of type {found}: expected a numpy array of float32 or float64, {shape}")));
    };
    let dtype = array.dtype();
    let (kind, size): (char, usize) = (dtype.getattr("kind")?.extract()?, dtype.getattr("itemsize")?.extract()?);
    if kind != 'f' || !matches!(size, 4 | 8) {
        return Err(wrong(format!("{name} has dtype {dtype}: expected float32 or float64")));
    }
    // numpy knows how to read every layout, alignment and order of bytes.
    let python = given.py();
    let settings = [("dtype", "float64")].into_py_dict(python)?;
    let ordered = python.import("numpy")?.call_method("ascontiguousarray", (array,), Some(&settings))?;
    let ordered = ordered.cast_into::<PyArrayDyn<f64>>()?;
    let numbers = ordered.readonly().as_slice()?.to_vec();
    Ok((numbers, array.shape().to_vec()))
}

fn shape_text(shape: &[usize]) -> String {
    let sizes: Vec<_> = shape.iter().map(usize::to_string).collect();
    let comma = if sizes.len() == 1 { "," } else { "" };
    format!("({}{comma})", sizes.join(", "))
}

/// An array of shape (N, 3).
pub fn rows(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<[f64; 3]>> {
    let (numbers, shape) = numbers(name, given, "of shape (N, 3)")?;
    match shape[..] {
        [_, 3] => Ok(numbers.as_chunks::<3>().0.to_vec()),
        _ => Err(wrong(format!("{name} has shape {}: expected (N, 3)", shape_text(&shape)))),
    }
}

/// A number for all, or an array of shape (N,).
pub fn number_or_column(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    if let Ok(number) = given.extract::<f64>() {
        return Ok(vec![number]);
    }
    let (numbers, shape) = numbers(name, given, "of shape (N,), or a number")?;
    match shape[..] {
        [_] => Ok(numbers),
        _ => Err(wrong(format!("{name} has shape {}: expected (N,), or a number", shape_text(&shape)))),
    }
}

/// A whole number from 0 up.
pub fn whole<T: TryFrom<i64>>(name: &str, number: i64) -> PyResult<T> {
    T::try_from(number).map_err(|_| wrong(format!("{name} is {number}: expected a whole number from 0 up")))
}

/// The back end of a name.
pub fn back_end(name: &str, in_lockstep: bool) -> PyResult<BackEnd> {
    BackEnd::named(name, in_lockstep).map_err(raised)
}

/// A configuration: TOML, or that of a plan.
#[derive(FromPyObject)]
pub enum Configuration {
    /// TOML.
    #[pyo3(transparent)]
    Text(String),
    /// A plan.
    #[pyo3(transparent)]
    Plan(Py<Plan>),
}

impl Configuration {
    /// As TOML.
    pub fn text(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Plan(plan) => plan.get().0.toml(),
        }
    }
}
