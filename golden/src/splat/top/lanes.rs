//! All lanes of a core: distributors lead to them, arbiters and collectors from them, as binary trees whose leaves they are.
//!
//! Nodes are numbered as those of a heap: the root is 1, and below node `i` are `2i` and `2i + 1`; lane `n` of `count` is node
//! `count + n`. Each of several ports to memory is the root of a tree of its own, port `p` of `ports` is node `ports + p`.

use crate::splat::{Arbiter, Collector, Distributor, Lane, Latencies, arbiter, distributor, lane};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::SplatCopy;
use pointcore_contract::splat::units::top::In;
use pointcore_contract::splat::units::{Events, LaneEvents, collector};

/// What lanes and the units between them show in a cycle.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The distributors, the root first.
    pub distributors: Vec<distributor::Out>,
    /// The lanes, by number.
    pub lanes: Vec<lane::Shown>,
    /// The arbiters, the roots first.
    pub arbiters: Vec<arbiter::Out>,
    /// The collectors, likewise.
    pub collectors: Vec<collector::Out>,
}

impl Shown {
    /// Ports to memory: arbiters are nodes from this number on.
    fn ports(&self) -> usize {
        self.lanes.len() - self.arbiters.len()
    }

    /// Whether node `node` takes a copy.
    fn takes(&self, node: usize) -> bool {
        match self.distributors.get(node - 1) {
            Some(distributor) => distributor.in_ready,
            None => self.lanes[node - self.lanes.len()].payloads.in_ready,
        }
    }

    /// What node `node`, a port's or below, shows to memory.
    fn node(&self, node: usize) -> lane::Out {
        let inner = node - self.ports();
        match (self.arbiters.get(inner), self.collectors.get(inner)) {
            (Some(&arbiter::Out { read, data_ready, write, .. }), Some(&collector::Out { out: pixel, .. })) => {
                lane::Out { read, data_ready, write, pixel, ..lane::Out::default() }
            }
            _ => self.lanes[node - self.lanes.len()].ports(),
        }
    }

    /// Whether a copy is taken.
    #[must_use]
    pub fn in_ready(&self) -> bool {
        self.takes(1)
    }

    /// What each port shows to memory and to its normalizer.
    pub fn at_ports(&self) -> impl Iterator<Item = lane::Out> + '_ {
        (self.ports()..2 * self.ports()).map(|node| self.node(node))
    }

    /// What each node sees where the splitter shows a copy, each port sees one of `ports`, and the core `inputs`; a lane's are at
    /// `lanes.len()` and its number.
    #[must_use]
    pub fn seen(&self, copy: Option<SplatCopy>, ports: &[lane::In], inputs: &In) -> Vec<lane::In> {
        let mut seen = vec![lane::In::default(); 2 * self.lanes.len()];
        seen[ports.len()..2 * ports.len()].copy_from_slice(ports);
        for (node, (arbiter, collector)) in (ports.len()..).zip(self.arbiters.iter().zip(&self.collectors)) {
            let above = seen[node];
            seen[2 * node] = lane::In {
                read_ready: arbiter.low_read_ready,
                data: arbiter.low_data,
                write_ready: arbiter.low_write_ready,
                pixel_ready: collector.low_ready,
                ..above
            };
            seen[2 * node + 1] = lane::In {
                read_ready: arbiter.high_read_ready,
                data: arbiter.high_data,
                write_ready: arbiter.high_write_ready,
                pixel_ready: collector.high_ready,
                ..above
            };
        }
        seen[1].input = copy;
        for (node, distributor) in (1..).zip(&self.distributors) {
            seen[2 * node].input = distributor.low;
            seen[2 * node + 1].input = distributor.high;
        }
        for (number, lane) in seen[self.lanes.len()..].iter_mut().enumerate() {
            lane.number = number as u8;
            lane.payload_read_ready = inputs.payload_read_ready[number];
            lane.payload_data = inputs.payload_data[number];
            lane.payload_write_ready = inputs.payload_write_ready[number];
            lane.depth_read_ready = inputs.depth_read_ready[number];
            lane.depth_data = inputs.depth_data[number];
        }
        seen
    }

    /// In how many lanes something happened in the last cycle.
    #[must_use]
    pub fn events(&self) -> Events {
        let mut counts = Events::default();
        for lane in &self.lanes {
            let LaneEvents { rasterizer, accumulator, hidden } = lane.events();
            counts.sample += u8::from(rasterizer.sample);
            counts.starved += u8::from(rasterizer.starved);
            counts.blocked += u8::from(rasterizer.blocked);
            counts.accumulate += u8::from(accumulator.accumulate);
            counts.hazard += u8::from(accumulator.hazard);
            counts.slot_wait += u8::from(accumulator.slot_wait);
            counts.hidden += u8::from(hidden);
        }
        counts
    }
}

/// The lanes.
#[derive(Clone, Debug)]
pub struct Lanes {
    distributors: Vec<Distributor>,
    lanes: Vec<Lane>,
    arbiters: Vec<Arbiter>,
    collectors: Vec<Collector>,
}

impl Lanes {
    /// All after reset, with pipelines of the given lengths.
    #[must_use]
    pub fn new(config: &Config, latencies: &Latencies) -> Self {
        let count = config.rasterizers;
        let inner = (count - config.memory_ports) as usize;
        Self {
            distributors: (1..count).map(|node| Distributor::new(config, node.ilog2())).collect(),
            lanes: vec![Lane::new(config, latencies); count as usize],
            arbiters: vec![Arbiter::default(); inner],
            collectors: vec![Collector::default(); inner],
        }
    }

    /// What all of them show in this cycle.
    #[must_use]
    pub fn shown(&self) -> Shown {
        Shown {
            distributors: self.distributors.iter().map(Model::outputs).collect(),
            lanes: self.lanes.iter().map(Lane::shown).collect(),
            arbiters: self.arbiters.iter().map(Model::outputs).collect(),
            collectors: self.collectors.iter().map(Model::outputs).collect(),
        }
    }

    /// One clock edge of units that show this, where the splitter shows a copy, each port sees one of `ports`, and the core `inputs`.
    pub fn step(&mut self, copy: Option<SplatCopy>, ports: &[lane::In], inputs: &In, shown: &Shown) {
        let seen = shown.seen(copy, ports, inputs);
        for (node, distributor) in (1..).zip(&mut self.distributors) {
            distributor.clock(&distributor::In {
                input: seen[node].input,
                low_ready: shown.takes(2 * node),
                high_ready: shown.takes(2 * node + 1),
            });
        }
        for (node, (arbiter, collector)) in (ports.len()..).zip(self.arbiters.iter_mut().zip(&mut self.collectors)) {
            let above = seen[node];
            let [low, high] = [2 * node, 2 * node + 1].map(|below| shown.node(below));
            arbiter.clock(&arbiter::In {
                low_read: low.read,
                low_data_ready: low.data_ready,
                low_write: low.write,
                high_read: high.read,
                high_data_ready: high.data_ready,
                high_write: high.write,
                read_ready: above.read_ready,
                data: above.data,
                write_ready: above.write_ready,
            });
            collector.clock(&collector::In { low: low.pixel, high: high.pixel, out_ready: above.pixel_ready });
        }
        let inputs = &seen[self.lanes.len()..];
        for ((lane, inputs), shown) in self.lanes.iter_mut().zip(inputs).zip(&shown.lanes) {
            lane.step(inputs, shown);
        }
    }
}
