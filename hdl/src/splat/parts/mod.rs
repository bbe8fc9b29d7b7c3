//! What several units of the renderer share.

pub(crate) mod collected;
pub(crate) mod division;
pub(crate) mod extreme;
pub(crate) mod place;
pub(crate) mod share;
pub(crate) mod turns;
