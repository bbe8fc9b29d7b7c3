//! The point processor as a library: a program over the neighbors that its own search finds.

mod counters;
mod generate;
mod host;
mod recorded;
mod session;
#[cfg(test)]
mod tests;

pub use counters::PointsCounters;
pub use generate::PointsCore;
pub use host::{Task, Work};
pub use recorded::record;
pub use session::{PointsOutcome, PointsSession};
