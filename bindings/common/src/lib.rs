//! What pointcore offers to other languages, in plain numbers: [`Render`], [`Search`], [`Process`], [`Plan`] and [`generate()`].
//!
//! The libraries for C and for Python stand on this crate. Each adds what its language asks for, and nothing else: how
//! arrays come in and go out, who owns what, how an error is told.

mod attributes;
mod back_end;
mod error;
mod generate;
mod plan;
mod process;
mod render;
mod scene;
mod search;

pub use attributes::{Named, Points, shape_text};
pub use back_end::BackEnd;
pub use error::{BindingError, ErrorKind, guarded};
pub use generate::generate;
pub use plan::Plan;
pub use pointcore::scene::Sides;
pub use process::{Output, Process, ProcessSettings, ProgramSource, Results, Values};
pub use render::{Frame, Render};
pub use scene::{Mesh, Scene, Splats, View, Viewpoint};
pub use search::{Found, NONE, Search, SearchSettings};

/// Handles of other languages may be used by several threads at a time.
const fn shared<T: Send + Sync>() {}
const _: () = {
    shared::<Search>();
    shared::<Render>();
    shared::<Process>();
    shared::<Results>();
    shared::<Scene>();
    shared::<Plan>();
};
