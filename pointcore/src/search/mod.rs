//! The search core on the host's side: point sets, kd-trees, the memory around the core, searches on hardware and model.

mod answers;
mod check;
mod counters;
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
mod work;

pub use check::{Checked, WrongAnswer, check};
pub use counters::{Counts, SearchCounters};
pub use derive::config_for;
pub use error::SearchError;
pub use generate::SearchCore;
pub use kdtree::{Splitting, Tree};
pub use memory::{MemorySettings, PointMemory, RequestSize};
pub use order::Order;
pub use points::{PointSet, PointSource};
pub use query::{Neighbor, Query};
pub use recorded::record;
pub use report::{Bound, HitRate, SearchReport, SearchRun};
pub use reuse::{QueryKind, Reuse};
pub use run::SearchOutcome;
pub use session::{SearchEngine, Session};
