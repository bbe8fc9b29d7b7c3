//! What is kept of a neighbor.

use pointcore_contract::record;
use pointcore_contract::search::Config;

/// Which point it is and how far away.
#[record(config: Config)]
pub(crate) struct Neighbor {
    /// The point's place in the point memory.
    #[bits(config.index_bits)]
    pub index: u32,
    /// Its squared distance.
    #[bits(config.geometry.width())]
    pub distance2: u32,
}
