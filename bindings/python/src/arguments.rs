//! What Python passes: arrays of any strides, numbers, configurations.

use crate::error::{raised, wrong};
use crate::plan::Plan;
use numpy::{PyArrayDyn, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
use pointcore_bindings::{BackEnd, Named, shape_text};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

/// The kind of numpy's types of floats, and those of whole numbers and truth values.
const FLOATS: &str = "f";
const WHOLE: &str = "iub";
/// The kinds of those that count.
const INDICES: &str = "iu";

/// The numbers of an array of floats in the order of its indices, and its shape.
fn numbers(name: &str, given: &Bound<'_, PyAny>, shape: &str) -> PyResult<(Vec<f64>, Vec<usize>)> {
    let Ok(array) = given.cast::<PyUntypedArray>() else {
        let found = given.get_type().name()?;
        return Err(wrong(format!("{name} is of type {found}: expected a numpy array of float32 or float64, {shape}")));
    };
    let (kind, size) = type_of(array)?;
    if !FLOATS.contains(kind) || !matches!(size, 4 | 8) {
        return Err(wrong(format!("{name} has dtype {}: expected float32 or float64", array.dtype())));
    }
    in_order(array)
}

/// The kind of an array's numbers, and their bytes.
fn type_of(array: &Bound<'_, PyUntypedArray>) -> PyResult<(char, usize)> {
    let dtype = array.dtype();
    Ok((dtype.getattr("kind")?.extract()?, dtype.getattr("itemsize")?.extract()?))
}

/// The numbers of an array in the order of its indices, and its shape.
fn in_order(array: &Bound<'_, PyUntypedArray>) -> PyResult<(Vec<f64>, Vec<usize>)> {
    // numpy knows how to read every layout, alignment and order of bytes.
    let python = array.py();
    let settings = [("dtype", "float64")].into_py_dict(python)?;
    let ordered = python.import("numpy")?.call_method("ascontiguousarray", (array,), Some(&settings))?;
    let ordered = ordered.cast_into::<PyArrayDyn<f64>>()?;
    let numbers = ordered.readonly().as_slice()?.to_vec();
    Ok((numbers, array.shape().to_vec()))
}

/// An array of shape (N, 3).
pub fn rows(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<[f64; 3]>> {
    let (numbers, shape) = numbers(name, given, "of shape (N, 3)")?;
    match shape[..] {
        [_, 3] => Ok(numbers.as_chunks::<3>().0.to_vec()),
        _ => Err(wrong(format!("{name} has shape {}: expected (N, 3)", shape_text(&shape)))),
    }
}

/// An array of whole numbers of shape (N, 3).
pub fn triples(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<[u32; 3]>> {
    let Ok(array) = given.cast::<PyUntypedArray>() else {
        let found = given.get_type().name()?;
        return Err(wrong(format!(
            "{name} is of type {found}: expected a numpy array of whole numbers, of shape (N, 3)"
        )));
    };
    let (kind, _) = type_of(array)?;
    if !INDICES.contains(kind) {
        return Err(wrong(format!("{name} has dtype {}: expected whole numbers", array.dtype())));
    }
    let (numbers, shape) = in_order(array)?;
    let [_, 3] = shape[..] else {
        return Err(wrong(format!("{name} has shape {}: expected (N, 3)", shape_text(&shape))));
    };
    let index = |number: f64| {
        // Numbers above 2^53 are rounded, and too large all the same.
        let is_index = (0.0..=f64::from(u32::MAX)).contains(&number);
        is_index.then_some(number as u32).ok_or_else(|| wrong(format!("{name} has {number}: expected indices")))
    };
    numbers.as_chunks::<3>().0.iter().map(|&[a, b, c]| Ok([index(a)?, index(b)?, index(c)?])).collect()
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

/// Numbers by their names: of each a number, a row of them, or an array.
pub fn named(what: &str, given: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<Named>> {
    let one = |(key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = key.extract().map_err(|_| wrong(format!("{what} has the key {key}: expected a name")))?;
        let (values, shape) = if let Ok(array) = value.cast::<PyUntypedArray>() {
            let (kind, size) = type_of(array)?;
            let is_number = WHOLE.contains(kind) || (FLOATS.contains(kind) && matches!(size, 4 | 8));
            if !is_number {
                let dtype = array.dtype();
                return Err(wrong(format!(
                    "`{name}` of {what} has dtype {dtype}: expected numbers of 64 bits at most"
                )));
            }
            in_order(array)?
        } else if let Ok(number) = value.extract::<f64>() {
            (vec![number], vec![])
        } else if let Ok(row) = value.extract::<Vec<f64>>() {
            let shape = vec![row.len()];
            (row, shape)
        } else {
            let found = value.get_type().name()?;
            let expected = "expected a number, a sequence of three, or a numpy array";
            return Err(wrong(format!("`{name}` of {what} is of type {found}: {expected}")));
        };
        Ok(Named { name, values, shape })
    };
    given.map_or_else(|| Ok(vec![]), |given| given.iter().map(one).collect())
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
