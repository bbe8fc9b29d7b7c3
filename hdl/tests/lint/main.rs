//! What the tools make of the cores and of the units on the bus.

mod bus;
#[path = "../../../rtl/tests/rtl/lint.rs"]
mod lint;
mod search;
mod stream;
