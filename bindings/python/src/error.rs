//! Errors as exceptions, and work without the interpreter's lock.

use pointcore_bindings::{BindingError, ErrorKind, guarded};
use pyo3::create_exception;
use pyo3::exceptions::{PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;

create_exception!(pointcore, InputError, PyValueError, "What was given makes no sense.");
create_exception!(pointcore, FileError, PyOSError, "A file cannot be read or written.");
create_exception!(
    pointcore,
    HardwareError,
    PyRuntimeError,
    "The hardware could not be generated, built or run, a tool is missing, or hardware and model differ."
);
create_exception!(pointcore, InternalError, PyRuntimeError, "A fault of pointcore itself.");

/// The exception of an error.
pub fn raised(error: BindingError) -> PyErr {
    let message = error.message;
    match error.kind {
        ErrorKind::Input => InputError::new_err(message),
        ErrorKind::File => FileError::new_err(message),
        ErrorKind::Hardware => HardwareError::new_err(message),
        _ => InternalError::new_err(message),
    }
}

/// The exception of what makes no sense.
pub fn wrong(message: String) -> PyErr {
    InputError::new_err(message)
}

/// Runs long work while other threads of Python go on.
pub fn detached<T: Send>(python: Python<'_>, run: impl FnOnce() -> Result<T, BindingError> + Send) -> PyResult<T> {
    python.detach(|| guarded(run)).map_err(raised)
}
