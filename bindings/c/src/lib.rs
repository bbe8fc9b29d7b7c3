//! pointcore for C: the functions of `pointcore.h`.
//!
//! Every function that can fail returns a [`Status`], and [`pointcore_error_message`] says why. No panic leaves it.
//! What is opened is closed by the function beside it, and belongs to whoever opened it; handles may be used by several
//! threads at a time, until one closes them.

mod arguments;
#[cfg(test)]
mod header;
mod plan;
mod process;
mod processed;
mod render;
mod scene;
mod search;
mod status;

pub use plan::*;
pub use process::*;
pub use processed::*;
pub use render::*;
pub use scene::*;
pub use search::*;
pub use status::*;
