//! Scenes that move while the shutter is open (thesis ch. 4): what moves on hardware with bins of the exposure, and what stands still on hardware
//! without.

mod encode;
mod exposure;
mod lens;
mod session;

pub(crate) use encode::{moving_record, moving_records, shutter_weights};
pub use exposure::expose;
pub(crate) use lens::Lens;
pub use session::{ExposedFrame, MovingSession};
