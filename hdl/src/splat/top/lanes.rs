//! Places all lanes of a core: distributors lead to them, arbiters and collectors from them, as binary trees whose leaves they are.

use std::collections::BTreeMap;
use std::rc::Rc;

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::FinishedPixel;
use pointcore_contract::splat::units::{AccumulatorEvents, Events, RasterizerEvents, distributor, lane};

use crate::compiler::{CompileError, Manifest, Options};
use crate::splat::arbiter::{self, Client};
use crate::splat::lane::Lane;
use crate::splat::parts::collected::{self, Source};
use crate::splat::{distributor as distributors, lane as lanes};
use crate::units::ports::{OutputPorts, WordPort, pipe};
use crate::units::wires::Wires;
use rtl::{Expr, Instance, Module, lit};

/// The lanes, and what the compiler decided about their datapaths.
pub(super) struct Lanes {
    lanes: Vec<Instance>,
    /// What all copies go to: it has a lane's ports there.
    pub root: Instance,
    /// What leads to memory and to a normalizer each.
    pub ports: Vec<Port>,
    /// By unit: those of one lane are those of all.
    pub manifests: BTreeMap<String, Manifest>,
}

/// What lanes put out together.
#[derive(Clone, Copy)]
pub(super) struct Port {
    /// Reads and writes of pixels.
    pub memory: Client,
    /// Finished pixels.
    pub pixel: Source<FinishedPixel>,
}

/// What the trees are made of.
struct Planting<'a> {
    m: &'a mut Module,
    config: &'a Config,
    lane: Rc<Module>,
    lanes: Vec<Instance>,
    ports: Vec<Port>,
}

impl Planting<'_> {
    /// Places the node so many levels below the root, whose numbers begin with these bits, and all below it. Returns what copies go to,
    /// and what comes from there: above the ports nothing.
    fn node(&mut self, level: u32, number: u32) -> (Instance, Option<Port>) {
        let (instance, port) =
            if level == self.config.rasterizer_bits() { self.leaf(number) } else { self.inner(level, number) };
        if level == self.config.memory_ports.ilog2() {
            self.ports.extend(port);
            return (instance, None);
        }
        (instance, port)
    }

    fn leaf(&mut self, number: u32) -> (Instance, Option<Port>) {
        let instance = self.m.instance(&format!("lane_{number}"), self.lane.clone());
        self.lanes.push(instance);
        let lane::Ports { read, data, write, pixel, .. } = lane::PORTS;
        (instance, Some(Port { memory: Client { instance, read, data, write }, pixel: (instance, pixel) }))
    }

    fn inner(&mut self, level: u32, number: u32) -> (Instance, Option<Port>) {
        let [(low, low_port), (high, high_port)] =
            [2 * number, 2 * number + 1].map(|number| self.node(level + 1, number));
        let Self { ref mut m, config, .. } = *self;
        let name = |unit: &str| format!("{unit}_{level}_{number}");
        let distributor = m.instance(&name("distributor"), distributors::module(config, level));
        pipe(m, config, (distributor, distributor::PORTS.low), (low, lane::PORTS.input));
        pipe(m, config, (distributor, distributor::PORTS.high), (high, lane::PORTS.input));
        let port = low_port.zip(high_port).map(|(low, high)| Port {
            memory: arbiter::join(m, config, &name("arbiter"), [low.memory, high.memory]),
            pixel: collected::join(m, config, &name("collector"), [low.pixel, high.pixel]),
        });
        (distributor, port)
    }
}

impl Lanes {
    /// Places all lanes.
    pub fn place(m: &mut Module, config: &Config, options: &Options) -> Result<Self, CompileError> {
        let Lane { module, manifests } = lanes::lane(config, options)?;
        let mut planting = Planting { m, config, lane: Rc::new(module), lanes: vec![], ports: vec![] };
        let (root, _) = planting.node(0, 0);
        let Planting { lanes, ports, .. } = planting;
        if config.rasterizers > 1 {
            for (number, &lane) in (0..).zip(&lanes) {
                lane::PORTS.number.feed_word(m, lane, lit(config.rasterizer_bits(), number));
            }
        }
        Ok(Self { lanes, root, ports, manifests })
    }

    /// Each of them, by number.
    pub fn each(&self) -> impl Iterator<Item = Instance> + '_ {
        self.lanes.iter().copied()
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

    /// Feeds all of them what depths begin with.
    pub fn depth_a(&self, m: &mut Module, depth_a: Expr) {
        for &lane in &self.lanes {
            lane::PORTS.depth_a.feed_word(m, lane, depth_a);
        }
    }

    /// In how many of them something happened in the last cycle. How many fragments something hid is left open.
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
            hidden: if config.tests_samples() {
                sum(width, events.iter().map(|events| events.hidden))
            } else {
                Expr::default()
            },
        }
    }
}

/// How many of the bits are set.
pub(super) fn sum(width: u32, bits: impl Iterator<Item = Expr>) -> Expr {
    bits.map(|bit| bit.zext(width)).reduce(|sum, bit| sum + bit).expect("there is a lane")
}
