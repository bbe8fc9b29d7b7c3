//! The whole core: all units wired up, cycle for cycle.
//!
//! In a cycle every unit first shows its outputs, which depend on registers only, then all are clocked.

pub mod lanes;

use super::uniforms::write_uniform;
use super::{
    Latencies, Merge, MotionSetup, Normalizer, Setup, Splitter, Transform, lane, merge, motion_setup, normalizer,
    setup, splitter, transform,
};
use crate::unit::Model;
use lanes::Lanes;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::Uniforms;
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
    /// The lanes.
    pub lanes: lanes::Shown,
    /// The end of a frame had left all of them in the cycle before.
    pub frame_sent: bool,
    /// The normalizers, one a port.
    pub normalizers: Vec<normalizer::Out>,
    /// What tests fragments against depths in memory, one a port, if anything does.
    pub merges: Vec<merge::Out>,
}

impl Shown {
    /// What each port of the lanes sees, but for copies.
    #[must_use]
    pub fn ports_see(&self, inputs: &In, uniforms: &Uniforms) -> Vec<lane::In> {
        let of_port = |(port, normalizer): (usize, &normalizer::Out)| lane::In {
            read_ready: inputs.read_ready[port],
            data: inputs.data[port],
            write_ready: inputs.write_ready[port],
            pixel_ready: normalizer.in_ready,
            frame_sent: self.frame_sent,
            filter_scale: uniforms.filter_scale,
            depth_a: uniforms.viewport.depth_a,
            ..lane::In::default()
        };
        self.normalizers.iter().enumerate().map(of_port).collect()
    }
}

/// The setup unit that a configuration has.
#[derive(Clone, Debug)]
enum Projection {
    Still(Setup),
    Moving(MotionSetup),
}

impl Projection {
    fn new(config: &Config, latency: u32) -> Self {
        if config.has_motion() {
            Self::Moving(MotionSetup::new(config, latency))
        } else {
            Self::Still(Setup::new(config, latency))
        }
    }

    fn outputs(&self) -> setup::Out {
        match self {
            Self::Still(unit) => unit.outputs(),
            Self::Moving(unit) => {
                let motion_setup::Out { in_ready, out } = unit.outputs();
                setup::Out { in_ready, out }
            }
        }
    }

    fn clock(&mut self, inputs: setup::In) {
        match self {
            Self::Still(unit) => unit.clock(&inputs),
            Self::Moving(unit) => {
                let setup::In { input, out_ready, viewport, epsilon, near_plane, .. } = inputs;
                unit.clock(&motion_setup::In { input, out_ready, viewport, epsilon, near_plane });
            }
        }
    }
}

/// The whole core.
#[derive(Clone, Debug)]
pub struct Top {
    config: Config,
    uniforms: Uniforms,
    transform: Transform,
    setup: Projection,
    splitter: Splitter,
    lanes: Lanes,
    frame_set_up: bool,
    /// By port to memory: the end of a frame has left, that of others may not have.
    ended: Vec<bool>,
    frame_sent: bool,
    normalizers: Vec<Normalizer>,
    merges: Vec<Merge>,
}

impl Top {
    /// The core after reset, with pipelines of the given lengths.
    #[must_use]
    pub fn new(config: &Config, latencies: &Latencies) -> Self {
        Self {
            config: config.clone(),
            uniforms: Uniforms::default(),
            transform: Transform::new(config, latencies.transform),
            setup: Projection::new(config, latencies.setup),
            splitter: Splitter::new(config),
            lanes: Lanes::new(config, latencies),
            frame_set_up: false,
            ended: vec![false; config.memory_ports as usize],
            frame_sent: false,
            normalizers: vec![Normalizer::new(config, latencies.normalizer); config.memory_ports as usize],
            merges: vec![Merge::new(config); config.depth_writers() as usize],
        }
    }

    /// What every unit shows in this cycle.
    #[must_use]
    pub fn shown(&self) -> Shown {
        Shown {
            transform: self.transform.outputs(),
            setup: self.setup.outputs(),
            splitter: self.splitter.outputs(),
            lanes: self.lanes.shown(),
            frame_sent: self.frame_sent,
            normalizers: self.normalizers.iter().map(Model::outputs).collect(),
            merges: self.merges.iter().map(Model::outputs).collect(),
        }
    }

    /// One clock edge of units that show this: a [`clock`](Model::clock) for whoever has looked at what passes between them.
    pub fn step(&mut self, inputs: &In, shown: &Shown) {
        let Shown { transform, setup, splitter, lanes, .. } = shown;
        let uniforms = &self.uniforms;
        self.transform.clock(&transform::In {
            input: inputs.splat,
            out_ready: setup.in_ready,
            model_view: uniforms.model_view,
            near_plane: uniforms.near_plane,
        });
        self.setup.clock(setup::In {
            input: transform.out,
            out_ready: splitter.in_ready,
            viewport: uniforms.viewport,
            epsilon: uniforms.epsilon,
            near_plane: uniforms.near_plane,
            filter_radius: uniforms.filter_radius,
        });
        self.frame_set_up = setup.out.is_some_and(|splat| splat.end) && splitter.in_ready;
        self.splitter.clock(&splitter::In { input: setup.out, out_ready: lanes.in_ready() });
        let ports = shown.ports_see(inputs, uniforms);
        self.lanes.step(splitter.out, &ports, inputs, lanes);
        for (port, lane::Out { pixel, .. }) in lanes.at_ports().enumerate() {
            self.ended[port] |= pixel.is_some_and(|pixel| pixel.end) && shown.normalizers[port].in_ready;
            self.normalizers[port].clock(&normalizer::In {
                input: pixel,
                out_ready: shown.merges.get(port).map_or(inputs.fragment_ready[port], |merge| merge.in_ready),
                shutter: uniforms.shutter,
            });
        }
        for (port, merge) in self.merges.iter_mut().enumerate() {
            merge.clock(&merge::In {
                input: shown.normalizers[port].out,
                out_ready: inputs.fragment_ready[port],
                depth_read_ready: inputs.depth_read_ready[port],
                depth_data: inputs.depth_data[port],
                depth_write_ready: inputs.depth_write_ready[port],
            });
        }
        self.frame_sent = self.ended.iter().all(|ended| *ended);
        if self.frame_sent {
            self.ended.fill(false);
        }
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
        let lanes = self.lanes.shown();
        let mut out = Out {
            splat_ready: self.transform.outputs().in_ready,
            frame_set_up: self.frame_set_up,
            events: lanes.events(),
            ..Out::default()
        };
        for (port, (at_port, normalizer)) in lanes.at_ports().zip(&self.normalizers).enumerate() {
            (out.read[port], out.data_ready[port]) = (at_port.read, at_port.data_ready);
            (out.write[port], out.fragment[port]) = (at_port.write, normalizer.outputs().out);
        }
        for (port, merge) in self.merges.iter().map(Model::outputs).enumerate() {
            out.fragment[port] = merge.out;
            (out.depth_read[port], out.depth_data_ready[port]) = (merge.depth_read, merge.depth_data_ready);
            out.depth_write[port] = merge.depth_write;
            out.events.hidden += u8::from(merge.hidden);
        }
        for (port, lane) in lanes.lanes.iter().enumerate().take(self.config.payload_ports() as usize) {
            let lane::Out { payload_read, payload_data_ready, payload_write, .. } = lane.ports();
            (out.payload_read[port], out.payload_data_ready[port]) = (payload_read, payload_data_ready);
            out.payload_write[port] = payload_write;
        }
        if self.config.tests_samples() {
            for (port, lane) in lanes.lanes.iter().enumerate() {
                let lane::Out { depth_read, depth_data_ready, .. } = lane.ports();
                (out.depth_read[port], out.depth_data_ready[port]) = (depth_read, depth_data_ready);
            }
        }
        out
    }

    fn clock(&mut self, inputs: &In) {
        let shown = self.shown();
        self.step(inputs, &shown);
    }
}
