//! What several units of the renderer share.

pub(crate) mod collected;
pub(crate) mod cover;
pub(crate) mod division;
pub(crate) mod place;
pub mod share;
pub(crate) mod shared;
