//! What several units of the bus share.

pub(crate) mod beats;
pub(crate) mod spread;
