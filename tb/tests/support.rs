//! What the tests of units share.

use std::sync::Arc;

use pointcore::verilated::{Builder, Library, Options, Source};
use pointcore_hdl::rtl::{Module, elaborate};

/// A unit, elaborated and verilated; its outputs must be functions of registers only.
pub fn verilate(unit: &Module) -> Arc<Library> {
    let design = elaborate(unit).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(design.combinational_paths(), [], "{} has a path from input to output", design.top());
    let builder = Builder::new().unwrap_or_else(|error| panic!("{error}"));
    builder.build(&Source::from(&design), Options::default()).unwrap_or_else(|error| panic!("{error}"))
}
