//! Places all lanes of a core: distributors lead to them and collectors from them, as two binary trees whose leaves they are.

use std::collections::BTreeMap;
use std::rc::Rc;

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{FinishedPixel, Pixel, PixelRun, StoredPixel};
use pointcore_contract::splat::units::{AccumulatorEvents, Events, RasterizerEvents, collector, distributor, lane};
use pointcore_contract::unit::{In, Out};

use crate::compiler::{CompileError, Manifest, Options};
use crate::splat::lane::Lane;
use crate::splat::{collector as collectors, distributor as distributors, lane as lanes};
use crate::units::ports::{OutputPorts, WordPort, pipe};
use crate::units::wires::Wires;
use rtl::{Expr, Instance, Module, lit};

/// The lanes, and what the compiler decided about their datapaths.
pub(super) struct Lanes {
    lanes: Vec<Instance>,
    /// What all copies go to, and what leads to memory and normalizer: both have the ports of a lane there.
    pub root: Node,
    /// By unit: those of one lane are those of all.
    pub manifests: BTreeMap<String, Manifest>,
}

/// A node of both trees: a lane takes its place in either.
#[derive(Clone, Copy)]
pub(super) struct Node {
    /// The distributor.
    pub distributor: Instance,
    /// The collector.
    pub collector: Instance,
}

/// A collector's ports to one of its sides.
struct Side {
    read: In<PixelRun>,
    data: Out<Pixel>,
    write: In<StoredPixel>,
    pixel: In<FinishedPixel>,
}

const LOW: Side = {
    let collector::Ports { low_read, low_data, low_write, low_pixel, .. } = collector::PORTS;
    Side { read: low_read, data: low_data, write: low_write, pixel: low_pixel }
};

const HIGH: Side = {
    let collector::Ports { high_read, high_data, high_write, high_pixel, .. } = collector::PORTS;
    Side { read: high_read, data: high_data, write: high_write, pixel: high_pixel }
};

impl Side {
    /// Connects it with the node below.
    fn connect(self, m: &mut Module, config: &Config, collector: Instance, below: Node) {
        pipe(m, config, (below.collector, lane::PORTS.read), (collector, self.read));
        pipe(m, config, (collector, self.data), (below.collector, lane::PORTS.data));
        pipe(m, config, (below.collector, lane::PORTS.write), (collector, self.write));
        pipe(m, config, (below.collector, lane::PORTS.pixel), (collector, self.pixel));
    }
}

/// What the trees are made of.
struct Planting<'a> {
    m: &'a mut Module,
    config: &'a Config,
    lane: Rc<Module>,
    lanes: Vec<Instance>,
}

impl Planting<'_> {
    /// Places the node so many levels below the root, whose numbers begin with these bits, and all below it.
    fn node(&mut self, level: u32, number: u32) -> Node {
        if level == self.config.rasterizer_bits() {
            let lane = self.m.instance(&format!("lane_{number}"), self.lane.clone());
            self.lanes.push(lane);
            return Node { distributor: lane, collector: lane };
        }
        let [low, high] = [2 * number, 2 * number + 1].map(|number| self.node(level + 1, number));
        let Self { ref mut m, config, .. } = *self;
        let name = |unit: &str| format!("{unit}_{level}_{number}");
        let distributor = m.instance(&name("distributor"), distributors::module(config, level));
        pipe(m, config, (distributor, distributor::PORTS.low), (low.distributor, lane::PORTS.input));
        pipe(m, config, (distributor, distributor::PORTS.high), (high.distributor, lane::PORTS.input));
        let collector = m.instance(&name("collector"), collectors::module(config));
        LOW.connect(m, config, collector, low);
        HIGH.connect(m, config, collector, high);
        Node { distributor, collector }
    }
}

impl Lanes {
    /// Places all lanes.
    pub fn place(m: &mut Module, config: &Config, options: &Options) -> Result<Self, CompileError> {
        let Lane { module, manifests } = lanes::lane(config, options)?;
        let mut planting = Planting { m, config, lane: Rc::new(module), lanes: vec![] };
        let root = planting.node(0, 0);
        let lanes = planting.lanes;
        if config.rasterizers > 1 {
            for (number, &lane) in (0..).zip(&lanes) {
                lane::PORTS.number.feed_word(m, lane, lit(config.rasterizer_bits(), number));
            }
        }
        Ok(Self { lanes, root, manifests })
    }

    /// Tells all of them that the end of a frame has left.
    pub fn frame_sent(&self, m: &mut Module, sent: Expr) {
        for &lane in &self.lanes {
            lane::PORTS.frame_sent.feed_word(m, lane, sent);
        }
    }

    /// Feeds all of them the scale of the screen filter.
    pub fn filter_scale(&self, m: &mut Module, scale: Expr) {
        for &lane in &self.lanes {
            lane::PORTS.filter_scale.feed_word(m, lane, scale);
        }
    }

    /// In how many of them something happened in the last cycle.
    pub fn events(&self, m: &mut Module, config: &Config) -> Events<Wires> {
        let width = config.rasterizer_bits() + 1;
        let events: Vec<_> = self.lanes.iter().map(|&lane| lane::PORTS.events.of(m, config, lane)).collect();
        let rasterizers = |happens: fn(RasterizerEvents<Wires>) -> Expr| {
            sum(width, events.iter().map(|events| happens(events.rasterizer)))
        };
        let accumulators = |happens: fn(AccumulatorEvents<Wires>) -> Expr| {
            sum(width, events.iter().map(|events| happens(events.accumulator)))
        };
        Events {
            sample: rasterizers(|events| events.sample),
            starved: rasterizers(|events| events.starved),
            blocked: rasterizers(|events| events.blocked),
            accumulate: accumulators(|events| events.accumulate),
            hazard: accumulators(|events| events.hazard),
            slot_wait: accumulators(|events| events.slot_wait),
        }
    }
}

/// How many of the bits are set.
fn sum(width: u32, bits: impl Iterator<Item = Expr>) -> Expr {
    bits.map(|bit| bit.zext(width)).reduce(|sum, bit| sum + bit).expect("there is a lane")
}
