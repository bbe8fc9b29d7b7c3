//! The renderer, the surface-splat renderer, unit by unit as docs/splat.md describes it.
//!
//! A unit is a [`Model`](crate::unit::Model) over the typed records of [`records`]; [`Ported`](crate::unit::Ported) gives it the
//! ports of the specification.

pub mod accumulator;
pub mod attribute;
pub mod depth_test;
pub mod heap;
pub mod normalizer;
pub mod rasterizer;
pub mod records;
pub mod reorder;
pub mod setup;
pub mod splitter;
pub mod tile_cache;
pub mod top;
pub mod transform;
pub mod uniforms;
pub mod weighting;

mod division;
mod fixed_distance;
mod fixed_footprint;

pub use accumulator::Accumulator;
pub use depth_test::DepthTest;
pub use heap::Heap;
pub use normalizer::Normalizer;
pub use rasterizer::Rasterizer;
pub use reorder::Reorder;
pub use setup::{Setup, Slant};
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::check_ports;
    use pointcore_contract::splat::{AttributeFormat, Coefficient, Config, Feature, Fraction, RasterFormat, ports};

    #[test]
    fn every_record_follows_its_port_list() {
        let filterless = Config { continuous: 1, screen_filter: Feature::Off, ..Config::default() };
        let cardinal = Config { continuous: 0, cardinal: 14, ..Config::default() };
        let fixed = Config { attribute: AttributeFormat::Fixed(Fraction::Eight), ..Config::default() };
        let rasterizer = Some(RasterFormat::Fixed(Coefficient::Eighteen));
        let integers = Config { rasterizer, ..Config::default() };
        for config in [Config::default(), filterless, cardinal, fixed, integers] {
            let latencies = Latencies { transform: 1, setup: 1, rasterizer: 1, weighting: 1, normalizer: 1 };
            check_ports(&Transform::new(&config, 1), &ports::transform(&config));
            check_ports(&Setup::new(&config, 1), &ports::setup(&config));
            check_ports(&Splitter::new(&config), &ports::splitter(&config));
            check_ports(&Heap::new(&config), &ports::heap(&config));
            check_ports(&Reorder::new(&config), &ports::reorder(&config));
            check_ports(&TileCache::new(&config), &ports::tile_cache(&config));
            check_ports(&Rasterizer::new(&config, 1), &ports::rasterizer(&config));
            check_ports(&Weighting::new(&config, 1), &ports::weighting(&config));
            check_ports(&DepthTest::new(&config), &ports::depth_test(&config));
            check_ports(&Accumulator::new(&config), &ports::accumulator(&config));
            check_ports(&Normalizer::new(&config, 1), &ports::normalizer(&config));
            check_ports(&Top::new(&config, &latencies), &ports::top(&config));
        }
    }
}
