//! What a run of the point processor counts.

use crate::tally::{Counts, Tally};
use pointcore_contract::points::Config;
use pointcore_contract::points::units::Events;

/// What a run counted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointsCounters {
    /// Cycles from the first query offered to the last result.
    pub cycles: u64,
    /// Cycles in which the core reported each of its events.
    pub(super) events: Tally,
    /// Bytes that the memory moved, whole bursts.
    pub bytes: u64,
    /// Cycles in which a query was on offer and not taken.
    pub query_wait: u64,
}

impl PointsCounters {
    pub(super) fn new(config: &Config) -> Self {
        Self { events: Tally::new::<Events>(config), ..Self::default() }
    }

    /// Cycles in which the core reported each event; 0 for those that it does not have.
    #[must_use]
    pub fn events(&self, config: &Config) -> Events<Counts> {
        self.events.read(config)
    }
}
