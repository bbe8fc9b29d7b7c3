//! The renderer from scene to picture: generation, the host around it, runs on hardware and model.

pub mod activity;
mod bound;
pub mod depth_memory;
mod differences;
mod encode;
mod fates;
mod frame;
mod generate;
mod host;
mod machine;
pub mod mask;
pub mod memory;
pub(crate) mod moving;
mod page;
pub mod payload_memory;
mod recorded;
mod recorded_setup;
mod report;
mod run;
mod sequence;
mod session;

pub use bound::{FrameBound, bounds, copy_interval};
pub use differences::{
    DEPTH_ROUNDING, Differences, EDGE_ROUNDING, ROUNDING_LIMIT, merge_rounding, rounding_limit, sum_limit,
};
pub use encode::{END, EncodedFrame};
pub(crate) use fates::Front;
pub use fates::{Fates, copy_tiles};
pub use frame::assemble;
pub use generate::SplatCore;
pub use host::{EventCounts, SplatCounters, SplatHost};
pub use moving::{ExposedFrame, MovingSession, expose};
pub use page::{FramePictures, RunPage, StillPart};
pub use recorded::record;
pub use recorded_setup::record_setup;
pub use report::{Drawn, SplatReport, SplatRun};
pub use run::{SplatOutcome, SplatRunner};
pub use sequence::FrameFigures;
pub use session::{FrameFragment, RenderEngine, RenderError, RenderSession, RenderedFrame, reference};
