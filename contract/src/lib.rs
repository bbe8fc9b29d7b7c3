//! The contract between the golden models and the hardware descriptions: number formats, configurations and record
//! layouts. Nothing here computes a result of the hardware.

pub mod bus;
pub mod camera;
pub mod configuration;
pub mod format;
pub mod rendering;
pub mod search;
pub mod splat;
pub mod surface;
pub mod table;

pub use camera::Camera;
pub use format::{Fixed, Format, Signedness, Subnormals};
pub use rendering::{FragmentDepth, Rendering, Sampling};
pub use surface::Splat;
pub use table::TableShape;
