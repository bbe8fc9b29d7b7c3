//! The renderer of surface splats, unit by unit as docs/splat.md and its pages describe it.
//!
//! A unit is a [`Model`](crate::unit::Model) over what the contract says that it sees and shows; [`Ported`](crate::unit::Ported) gives
//! it ports.

pub mod accumulator;
pub mod arbiter;
pub mod attribute;
pub mod collector;
pub mod depth_test;
pub mod distributor;
pub mod fragment_collector;
pub mod heap;
pub mod lane;
pub mod lists;
pub mod merge;
pub mod motion_evaluation;
pub mod motion_setup;
pub mod normalizer;
pub mod occlusion;
pub mod payloads;
pub mod prefetch;
pub mod rasterizer;
pub mod reorder;
pub mod setup;
pub mod splitter;
pub mod tile_cache;
pub mod top;
pub mod transform;
pub mod uniforms;
pub mod weighting;

mod parts;

pub use accumulator::Accumulator;
pub use arbiter::Arbiter;
pub use collector::Collector;
pub use depth_test::DepthTest;
pub use distributor::Distributor;
pub use fragment_collector::FragmentCollector;
pub use heap::Heap;
pub use lane::Lane;
pub use lists::Lists;
pub use merge::Merge;
pub use motion_evaluation::MotionEvaluation;
pub use motion_setup::{MotionSetup, MotionUniforms};
pub use normalizer::Normalizer;
pub use occlusion::Occlusion;
pub use parts::share::Share;
pub use payloads::Payloads;
pub use prefetch::Prefetch;
pub use rasterizer::{MotionRasterizer, Rasterizer};
pub use reorder::Reorder;
pub use setup::{Dropped, Setup, Slant};
pub use splitter::Splitter;
pub use tile_cache::TileCache;
pub use top::Top;
pub use transform::Transform;
pub use weighting::Weighting;

/// Stages of the compiled pipelines, from the manifests that the generator writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Latencies {
    /// Of the transform unit.
    pub transform: u32,
    /// Of the setup unit.
    pub setup: u32,
    /// Of the rasterizer.
    pub rasterizer: u32,
    /// Of the weighting unit.
    pub weighting: u32,
    /// Of the normalizer.
    pub normalizer: u32,
}
