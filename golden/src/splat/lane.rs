//! Lane: a rasterizer and all that it has to itself, from copies to finished pixels (thesis 5.5.3).

use super::{
    Accumulator, Latencies, MotionRasterizer, Occlusion, Payloads, Prefetch, Rasterizer, Reorder, TileCache, Weighting,
    accumulator, occlusion, payloads, prefetch, rasterizer, reorder, tile_cache, weighting,
};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{ArrivedCopy, TileCopy};
use pointcore_contract::splat::units::LaneEvents;
pub use pointcore_contract::splat::units::lane::{In, Out};

/// What every unit of a lane shows in a cycle.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The payloads.
    pub payloads: payloads::Out,
    /// The reorder stage.
    pub reorder: reorder::Out,
    /// What asks for payloads, where they are in memory.
    pub prefetch: Option<prefetch::Out>,
    /// The tile cache.
    pub tile_cache: tile_cache::Out,
    /// The rasterizer.
    pub rasterizer: rasterizer::Out,
    /// What leaves out samples behind depths in memory, if anything does.
    pub occlusion: Option<occlusion::Out>,
    /// The weighting unit.
    pub weighting: weighting::Out,
    /// The accumulator.
    pub accumulator: accumulator::Out,
}

impl Shown {
    /// What the lane did in the last cycle.
    #[must_use]
    pub const fn events(&self) -> LaneEvents {
        let hidden = matches!(&self.occlusion, Some(occlusion) if occlusion.hidden);
        LaneEvents { rasterizer: self.rasterizer.events, accumulator: self.accumulator.events, hidden }
    }

    /// What of it is seen from outside.
    #[must_use]
    pub const fn ports(&self) -> Out {
        let tile_cache::Out { read, data_ready, write, pixel, .. } = self.tile_cache;
        let payloads::Out { in_ready, data_ready: payload_data_ready, write: payload_write, .. } = self.payloads;
        let payload_read = match &self.prefetch {
            Some(prefetch) => prefetch.read,
            None => None,
        };
        let (depth_read, depth_data_ready) = match &self.occlusion {
            Some(occlusion) => (occlusion.depth_read, occlusion.depth_data_ready),
            None => (None, false),
        };
        Out {
            in_ready,
            read,
            data_ready,
            write,
            pixel,
            payload_read,
            payload_data_ready,
            payload_write,
            depth_read,
            depth_data_ready,
            events: self.events(),
        }
    }
}

/// The rasterizer that a configuration has.
#[derive(Clone, Debug)]
enum Drawing {
    Still(Rasterizer),
    Moving(MotionRasterizer),
}

impl Drawing {
    fn new(config: &Config, latency: u32) -> Self {
        if config.has_motion() {
            Self::Moving(MotionRasterizer::new(config, latency))
        } else {
            Self::Still(Rasterizer::new(config, latency))
        }
    }

    fn outputs(&self) -> rasterizer::Out {
        match self {
            Self::Still(unit) => unit.outputs(),
            Self::Moving(unit) => unit.outputs(),
        }
    }

    fn clock(&mut self, inputs: &rasterizer::In) {
        match self {
            Self::Still(unit) => unit.clock(inputs),
            Self::Moving(unit) => unit.clock(inputs),
        }
    }
}

/// A lane.
#[derive(Clone, Debug)]
pub struct Lane {
    payloads: Payloads,
    reorder: Reorder,
    prefetch: Option<Prefetch>,
    tile_cache: TileCache,
    rasterizer: Drawing,
    occlusion: Option<Occlusion>,
    weighting: Weighting,
    accumulator: Accumulator,
}

impl Lane {
    /// The lane after reset, with pipelines of the given lengths.
    #[must_use]
    pub fn new(config: &Config, latencies: &Latencies) -> Self {
        Self {
            payloads: Payloads::new(config),
            reorder: Reorder::new(config),
            prefetch: config.has_payloads_in_memory().then(|| Prefetch::new(config)),
            tile_cache: TileCache::new(config),
            rasterizer: Drawing::new(config, latencies.rasterizer),
            occlusion: config.tests_samples().then(|| Occlusion::new(config)),
            weighting: Weighting::new(config, latencies.weighting),
            accumulator: Accumulator::new(config),
        }
    }

    /// What every unit shows in this cycle.
    #[must_use]
    pub fn shown(&self) -> Shown {
        Shown {
            payloads: self.payloads.outputs(),
            reorder: self.reorder.outputs(),
            prefetch: self.prefetch.as_ref().map(Model::outputs),
            tile_cache: self.tile_cache.outputs(),
            rasterizer: self.rasterizer.outputs(),
            occlusion: self.occlusion.as_ref().map(Model::outputs),
            weighting: self.weighting.outputs(),
            accumulator: self.accumulator.outputs(),
        }
    }

    /// One clock edge of units that show this.
    pub fn step(&mut self, inputs: &In, shown: &Shown) {
        let Shown { payloads, reorder, prefetch, tile_cache, rasterizer, occlusion, weighting, accumulator } = shown;
        self.payloads.clock(&payloads::In {
            input: inputs.input,
            copy_ready: reorder.in_ready && !tile_cache.full,
            placed: tile_cache.out,
            out_ready: rasterizer.in_ready,
            data: inputs.payload_data,
            write_ready: inputs.payload_write_ready,
        });
        let copy = payloads.copy.filter(|_| !tile_cache.full);
        let (ordered, reorder_ready) = match prefetch {
            Some(prefetch) => (prefetch.out, prefetch.in_ready),
            None => (reorder.out, tile_cache.in_ready),
        };
        self.reorder.clock(&reorder::In { input: copy, out_ready: reorder_ready });
        if let Some(prefetch) = &mut self.prefetch {
            prefetch.clock(&prefetch::In {
                input: reorder.out,
                out_ready: tile_cache.in_ready,
                read_ready: inputs.payload_read_ready,
                left: payloads.read,
            });
        }
        self.tile_cache.clock(&tile_cache::In {
            input: ordered,
            arrives: copy.filter(|_| reorder.in_ready).map(|TileCopy { end, tile, splat, .. }| ArrivedCopy {
                end,
                tile,
                splat,
            }),
            out_ready: payloads.placed_ready,
            read_ready: inputs.read_ready,
            data: inputs.data,
            write_ready: inputs.write_ready,
            pixel_ready: inputs.pixel_ready,
            number: inputs.number,
            frame_sent: inputs.frame_sent,
            retire: accumulator.retire,
            masks: accumulator.masks,
            sample_writes: accumulator.sample_writes,
            sample_reads: accumulator.sample_reads,
            drained: accumulator.drained,
        });
        let (sample, sample_ready) = match occlusion {
            Some(occlusion) => (occlusion.out, occlusion.in_ready),
            None => (rasterizer.out, weighting.in_ready),
        };
        self.rasterizer.clock(&rasterizer::In {
            input: payloads.out,
            out_ready: sample_ready,
            filter_scale: inputs.filter_scale,
            depth_a: inputs.depth_a,
        });
        if let Some(occlusion) = &mut self.occlusion {
            occlusion.clock(&occlusion::In {
                input: rasterizer.out,
                out_ready: weighting.in_ready,
                placed: tile_cache.placed,
                depth_read_ready: inputs.depth_read_ready,
                depth_data: inputs.depth_data,
            });
        }
        self.weighting.clock(&weighting::In { input: sample, out_ready: accumulator.in_ready });
        self.accumulator.clock(&accumulator::In {
            input: weighting.out,
            slot_ready: tile_cache.slot_ready,
            change: tile_cache.change,
            fill: tile_cache.fill,
            drain: tile_cache.drain,
        });
    }
}

impl Model for Lane {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        self.shown().ports()
    }

    fn clock(&mut self, inputs: &In) {
        let shown = self.shown();
        self.step(inputs, &shown);
    }
}
