//! The whole core: all units wired up, cycle for cycle.
//!
//! In a cycle every unit first shows its outputs, which depend on registers only, then all are clocked.

use super::uniforms::write_uniform;
use super::{
    Accumulator, Latencies, Normalizer, Rasterizer, Reorder, Setup, Splitter, TileCache, Transform, Weighting,
    accumulator, normalizer, rasterizer, reorder, setup, splitter, tile_cache, transform, weighting,
};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::Uniforms;
use pointcore_contract::splat::units::Events;
pub use pointcore_contract::splat::units::top::{In, Out};

/// What every unit shows in a cycle: all that passes between them.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The transform unit.
    pub transform: transform::Out,
    /// The setup unit.
    pub setup: setup::Out,
    /// The splitter.
    pub splitter: splitter::Out,
    /// The reorder stage.
    pub reorder: reorder::Out,
    /// The tile cache.
    pub tile_cache: tile_cache::Out,
    /// The rasterizer.
    pub rasterizer: rasterizer::Out,
    /// The weighting unit.
    pub weighting: weighting::Out,
    /// The accumulator.
    pub accumulator: accumulator::Out,
    /// The normalizer.
    pub normalizer: normalizer::Out,
}

/// The whole core.
#[derive(Clone, Debug)]
pub struct Top {
    config: Config,
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
            config: config.clone(),
            uniforms: Uniforms::default(),
            filter_scale_bits: u32::MAX >> (u32::BITS - config.filter_scale_format().width()),
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

    /// What every unit shows in this cycle.
    #[must_use]
    pub fn shown(&self) -> Shown {
        Shown {
            transform: self.transform.outputs(),
            setup: self.setup.outputs(),
            splitter: self.splitter.outputs(),
            reorder: self.reorder.outputs(),
            tile_cache: self.tile_cache.outputs(),
            rasterizer: self.rasterizer.outputs(),
            weighting: self.weighting.outputs(),
            accumulator: self.accumulator.outputs(),
            normalizer: self.normalizer.outputs(),
        }
    }

    /// One clock edge of units that show this: a [`clock`](Model::clock) for whoever has looked at what passes between them.
    pub fn step(&mut self, inputs: &In, shown: &Shown) {
        let Shown { transform, setup, splitter, reorder, tile_cache, rasterizer, weighting, accumulator, normalizer } =
            shown;
        let uniforms = &self.uniforms;
        self.transform.clock(&transform::In {
            input: inputs.splat,
            out_ready: setup.in_ready,
            model_view: uniforms.model_view,
            near_plane: uniforms.near_plane,
        });
        self.setup.clock(&setup::In {
            input: transform.out,
            out_ready: splitter.in_ready,
            viewport: uniforms.viewport,
            epsilon: uniforms.epsilon,
            near_plane: uniforms.near_plane,
            filter_radius: uniforms.filter_radius,
        });
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
        if let Some(write) = inputs.uniform {
            write_uniform(&mut self.uniforms, &self.config, write);
        }
    }
}

impl Model for Top {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let tile_cache = self.tile_cache.outputs();
        Out {
            splat_ready: self.transform.outputs().in_ready,
            read: tile_cache.read,
            data_ready: tile_cache.data_ready,
            write: tile_cache.write,
            fragment: self.normalizer.outputs().out,
            events: Events {
                rasterizer: self.rasterizer.outputs().events,
                accumulator: self.accumulator.outputs().events,
            },
        }
    }

    fn clock(&mut self, inputs: &In) {
        let shown = self.shown();
        self.step(inputs, &shown);
    }
}
