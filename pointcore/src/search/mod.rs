//! The search core on the host's side: point sets, kd-trees, the memory around the core, searches on hardware and model.

mod answers;
mod check;
mod derive;
mod error;
mod generate;
mod host;
pub mod kdtree;
mod memory;
mod order;
mod points;
mod query;
mod recorded;
mod report;
pub mod resources;
mod reuse;
mod run;
pub mod samples;
mod session;

pub use check::{Checked, Difference, check};
pub use derive::config_for;
pub use error::Error;
pub use generate::Core;
pub use host::Counters;
pub use kdtree::{Splitting, Tree};
pub use memory::{Extent, Memory, MemorySettings};
pub use order::Order;
pub use points::{PointSet, Source};
pub use query::{Neighbor, Query};
pub use recorded::record;
pub use report::{Bound, HitRate, Measured, Report};
pub use reuse::{Kind, Reuse};
pub use run::Outcome;
pub use session::{Engine, Session};
