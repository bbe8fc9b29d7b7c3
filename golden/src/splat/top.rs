//! The whole core: all units wired up, cycle for cycle.
//!
//! In a cycle every unit first shows its outputs, which depend on registers only, then all are clocked.

use super::records::{Fragment, Pixel, PlacedPixel, Shape, Splat};
use super::tile_cache::Tile;
use super::uniforms::{UniformWrite, Uniforms};
use super::{
    Accumulator, Latencies, Normalizer, Rasterizer, Reorder, Setup, Splitter, TileCache, Transform, Weighting,
    accumulator, normalizer, rasterizer, reorder, setup, splitter, tile_cache, transform, weighting,
};
use crate::unit::{Model, Record, Visitor, stream};
use pointcore_contract::splat::Config;

/// What the core sees.
#[derive(Clone, Copy, Debug, Default)]
pub struct In {
    /// Write to a uniform register, not while a frame is under way.
    pub uniform: Option<UniformWrite>,
    /// Splats in world space.
    pub splat: Option<Splat>,
    /// Whether the memory takes a read request.
    pub read_ready: bool,
    /// Pixels of the tiles requested, in pixel order.
    pub data: Option<Pixel>,
    /// Whether the memory takes a write.
    pub write_ready: bool,
    /// Whether the consumer takes a fragment.
    pub fragment_ready: bool,
}

/// What the core shows.
#[derive(Clone, Copy, Debug, Default)]
pub struct Out {
    /// Whether a splat is accepted.
    pub splat_ready: bool,
    /// Request for the pixels of a tile.
    pub read: Option<Tile>,
    /// Whether a pixel is accepted.
    pub data_ready: bool,
    /// Pixels of evicted tiles.
    pub write: Option<PlacedPixel>,
    /// Fragments of the image.
    pub fragment: Option<Fragment>,
    /// The rasterizer's events.
    pub rasterizer: rasterizer::Events,
    /// The accumulator's events.
    pub accumulator: accumulator::Events,
}

/// The whole core.
#[derive(Clone, Debug)]
pub struct Top {
    shape: Shape,
    uniforms: Uniforms,
    /// The bits that the register has.
    filter_scale_bits: u32,
    transform: Transform,
    setup: Setup,
    splitter: Splitter,
    reorder: Reorder,
    tile_cache: TileCache,
    rasterizer: Rasterizer,
    weighting: Weighting,
    accumulator: Accumulator,
    normalizer: Normalizer,
}

impl Top {
    /// The core after reset, with pipelines of the given lengths.
    #[must_use]
    pub fn new(config: &Config, latencies: &Latencies) -> Self {
        Self {
            shape: Shape::new(config),
            uniforms: Uniforms::default(),
            filter_scale_bits: u32::MAX >> (u32::BITS - config.uniform_format("filter_scale").width()),
            transform: Transform::new(config, latencies.transform),
            setup: Setup::new(config, latencies.setup),
            splitter: Splitter::new(config),
            reorder: Reorder::new(config),
            tile_cache: TileCache::new(config),
            rasterizer: Rasterizer::new(config, latencies.rasterizer),
            weighting: Weighting::new(config, latencies.weighting),
            accumulator: Accumulator::new(config),
            normalizer: Normalizer::new(config, latencies.normalizer),
        }
    }
}

impl Model for Top {
    type Shape = Shape;
    type In = In;
    type Out = Out;

    fn shape(&self) -> Shape {
        self.shape
    }

    fn outputs(&self) -> Out {
        let tile_cache = self.tile_cache.outputs();
        Out {
            splat_ready: self.transform.outputs().in_ready,
            read: tile_cache.read,
            data_ready: tile_cache.data_ready,
            write: tile_cache.write,
            fragment: self.normalizer.outputs().out,
            rasterizer: self.rasterizer.outputs().events,
            accumulator: self.accumulator.outputs().events,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let transform = self.transform.outputs();
        let setup = self.setup.outputs();
        let splitter = self.splitter.outputs();
        let reorder = self.reorder.outputs();
        let tile_cache = self.tile_cache.outputs();
        let rasterizer = self.rasterizer.outputs();
        let weighting = self.weighting.outputs();
        let accumulator = self.accumulator.outputs();
        let normalizer = self.normalizer.outputs();

        let uniforms = &self.uniforms;
        self.transform.clock(&transform::In {
            input: inputs.splat,
            out_ready: setup.in_ready,
            uniforms: uniforms.transform,
        });
        self.setup.clock(&setup::In { input: transform.out, out_ready: splitter.in_ready, uniforms: uniforms.setup });
        self.splitter.clock(&splitter::In { input: setup.out, out_ready: reorder.in_ready });
        self.reorder.clock(&reorder::In { input: splitter.out, out_ready: tile_cache.in_ready });
        self.tile_cache.clock(&tile_cache::In {
            input: reorder.out,
            out_ready: rasterizer.in_ready,
            read_ready: inputs.read_ready,
            data: inputs.data,
            write_ready: inputs.write_ready,
            pixel_ready: normalizer.in_ready,
            retire: accumulator.retire,
            frame_end: accumulator.frame_end,
            drained: accumulator.drained,
        });
        self.rasterizer.clock(&rasterizer::In {
            input: tile_cache.out,
            out_ready: weighting.in_ready,
            filter_scale: uniforms.filter_scale & self.filter_scale_bits,
        });
        self.weighting.clock(&weighting::In { input: rasterizer.out, out_ready: accumulator.in_ready });
        self.accumulator.clock(&accumulator::In {
            input: weighting.out,
            slot_ready: tile_cache.slot_ready,
            fill: tile_cache.fill,
            drain: tile_cache.drain,
        });
        self.normalizer.clock(&normalizer::In { input: tile_cache.pixel, out_ready: inputs.fragment_ready });
        if let Some(UniformWrite { address, data }) = inputs.uniform {
            self.uniforms.write(address, data);
        }
    }
}

impl Record<Shape> for In {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        stream(visitor, shape, "uniform_", &mut self.uniform);
        stream(visitor, shape, "splat_", &mut self.splat);
        visitor.field("read_ready", &mut self.read_ready);
        stream(visitor, shape, "data_", &mut self.data);
        visitor.field("write_ready", &mut self.write_ready);
        visitor.field("fragment_ready", &mut self.fragment_ready);
    }
}

impl Record<Shape> for Out {
    fn visit(&mut self, shape: Shape, visitor: &mut impl Visitor) {
        visitor.field("splat_ready", &mut self.splat_ready);
        stream(visitor, shape, "read_", &mut self.read);
        visitor.field("data_ready", &mut self.data_ready);
        stream(visitor, shape, "write_", &mut self.write);
        stream(visitor, shape, "fragment_", &mut self.fragment);
        self.rasterizer.visit(visitor);
        self.accumulator.visit(visitor);
    }
}
