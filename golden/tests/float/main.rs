//! The floating-point models against the host, an independent library, an independent generator's vectors and exact
//! integers.
//!
//! With `-- --nocapture` every comparison prints `fp.OPERATOR.FORMAT.cases N` and `fp.OPERATOR.FORMAT.mismatches N`.

mod apfloat;
mod fixed;
mod host;
mod newton;
mod roots;
// The models know no testbench: of it this file alone, which needs nothing besides.
#[path = "../../../tb/src/skipped.rs"]
mod skipped;
mod support;
mod tables;
mod vectors;
