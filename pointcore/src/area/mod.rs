//! What hardware takes: counted before synthesis, and estimated for a device from what was measured of other hardware.

pub mod count;
pub mod device;
pub mod estimate;
pub mod fit;
pub mod proxy;
pub mod recorded;
