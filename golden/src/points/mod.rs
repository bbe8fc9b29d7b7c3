//! The point processor: search and process core, cycle for cycle.

mod top;

pub use top::{Latencies, Top};
