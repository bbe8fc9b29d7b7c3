//! Mutation testing: which small faults of the generated Verilog the tests notice.
//!
//! yosys lists single mutations of a design's netlist, evenly over its modules, cells and bits: a bit inverted, stuck, or
//! confused with another of its word. All of them go into one text, and a number chooses the one that is in force
//! (`schemata`), so that a design is verilated once. The tests that ship run with each: a unit's lockstep (`suite`),
//! or the test of a package (`self_test`). A unit's mutants are in its own modules: those of another unit in it are tried by
//! that one's tests. They are found if a test fails or does not end.
//!
//! Of those that are missed, some change nothing that can be seen; a proof removes them (`equivalence`). What then
//! remains is a gap in the tests, or could not be decided. Both count as missed.

mod campaign;
mod equivalence;
mod error;
mod modules;
mod process;
mod record;
mod schemata;
mod self_test;
mod side_by_side;
mod suite;

pub use campaign::{Campaign, Event, Scope, Score, Settings};
pub use error::MutationError;
pub use record::MutationRecord;
pub use self_test::SelfTest;
pub use suite::Suite;
