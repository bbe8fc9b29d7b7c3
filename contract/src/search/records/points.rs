//! Records of points and their squared distances.

use super::{AXES, Thread};
use crate::record;
use crate::search::Config;

/// The most points a beat holds.
pub const LANES_MAX: usize = 8;

/// A request for the points of a leaf.
#[record(config: Config)]
pub struct Fetch {
    /// Thread under which it is answered.
    pub thread: Thread,
    /// First beat.
    #[bits(config.beat_bits())]
    pub address: u32,
    /// Number of beats, at least one.
    #[bits(config.beats_bits())]
    pub beats: u8,
}

/// Whose a beat is and where it lies.
#[record(config: Config)]
pub struct BeatPlace {
    /// Thread.
    pub thread: Thread,
    /// Address in the point memory.
    #[bits(config.beat_bits())]
    pub address: u32,
    /// Closes its leaf.
    pub last: bool,
}

/// As many points as the core has lanes.
#[record(config: Config)]
pub struct Points {
    /// A point a lane; NaN where there is none.
    #[count(config.lanes)]
    #[name(format!("{}{i}", AXES[j]))]
    #[bits(config.geometry.width())]
    pub lane: [[u32; 3]; LANES_MAX],
}

/// A beat of points from memory; the beats of a request come in order and together, requests in any order.
#[record(config: Config)]
pub struct Beat {
    /// Thread and address.
    pub place: BeatPlace,
    /// The points.
    pub points: Points,
}

/// A beat of squared distances; lane `i` is the point `address * lanes + i`.
#[record(config: Config)]
pub struct Candidates {
    /// Thread and address.
    pub place: BeatPlace,
    /// A squared distance a lane; NaN where there is no point.
    #[count(config.lanes)]
    #[name(format!("distance{i}"))]
    #[bits(config.square_bits())]
    pub distances: [u32; LANES_MAX],
}

/// A thread's search radius after a leaf.
#[record(config: Config)]
pub struct Radius {
    /// Thread.
    pub thread: Thread,
    /// Squared radius.
    #[bits(config.square_bits())]
    pub radius2: u32,
}
