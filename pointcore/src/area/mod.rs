//! What a configuration takes of a device, estimated from what was measured of others.

pub mod estimate;
pub mod fit;
pub mod proxy;
