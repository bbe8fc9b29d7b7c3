//! pointcore for Python: the module `pointcore`, whose stubs are `pointcore.pyi`.

mod arguments;
mod error;
mod plan;
mod process;
mod render;
mod scene;
mod search;

use pyo3::prelude::*;

/// Surface splatting, neighbor search and programs on neighborhoods, on generated hardware.
#[pymodule]
mod pointcore {
    #[pymodule_export]
    use crate::error::{FileError, HardwareError, InputError, InternalError};
    #[pymodule_export]
    use crate::plan::{Plan, generate, plan};
    #[pymodule_export]
    use crate::process::{ProcessSession, Processed, process};
    #[pymodule_export]
    use crate::render::{Frame, RenderSession, render};
    #[pymodule_export]
    use crate::scene::Scene;
    #[pymodule_export]
    use crate::search::{Found, SearchSession, search};
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
