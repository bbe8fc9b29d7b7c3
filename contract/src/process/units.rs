//! The process core's units at their ports.

use super::config::Config;
use super::records::{Gather, Gathered, KernelInput, LineFetch, Neighbor, Settings, Sums};
use crate::{record, unit};

/// Neighbors that may wait for their turn to be read: as many as a memory's latency has cycles.
pub const NEIGHBORS_UNDER_WAY: u32 = 64;

/// Lines that may be under way.
pub const LINES_UNDER_WAY: u32 = 16;

/// What the gathering of neighbors did.
#[record(config: Config)]
pub struct GatherEvents {
    /// A line that was wanted was there.
    #[name("event_line_hit")]
    pub hit: bool,
    /// A line that was wanted was not there.
    #[name("event_line_miss")]
    pub miss: bool,
}

/// Makes points with attributes of indices, and keeps lines of them.
#[unit(process_gather, config: Config)]
pub struct Gatherer {
    /// Neighbors wanted.
    gather: In<Gather>,
    /// Neighbors in the order in which they were wanted.
    gathered: Out<Gathered>,
    /// Requests to the memory.
    fetch: Out<LineFetch>,
    /// The points of the lines from memory, in the order of the requests.
    fill: In<Neighbor>,
    /// Nothing that is kept counts any more: the points have changed. Not while a neighbor is wanted.
    forget: Input<bool>,
    /// What happened in the last cycle.
    #[port("")]
    events: Output<GatherEvents>,
}

/// Goes through neighbors and keeps their sums.
#[unit(process_kernel, config: Config)]
pub struct Kernel {
    /// Constants of the run.
    #[port("setting")]
    settings: Input<Settings>,
    /// The neighbors of a query after the other.
    neighbor: In<KernelInput>,
    /// The sums of a query after the other.
    sums: Out<Sums>,
}
