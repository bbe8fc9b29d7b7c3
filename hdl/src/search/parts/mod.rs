//! What several units of the search share.

pub(crate) mod coordinates;
pub(crate) mod head_queue;
pub(crate) mod neighbor;
pub(crate) mod radii;
pub(crate) mod sets;
