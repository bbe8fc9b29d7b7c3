//! All lanes of a core: distributors lead to them and collectors from them, as two binary trees whose leaves they are.
//!
//! Nodes are numbered as those of a heap: the root is 1, and below node `i` are `2i` and `2i + 1`; lane `n` of `count` is node
//! `count + n`.

use crate::splat::{Collector, Distributor, Lane, Latencies, collector, distributor, lane};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::units::Events;

/// What lanes and the units between them show in a cycle.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The distributors, the root first.
    pub distributors: Vec<distributor::Out>,
    /// The lanes, by number.
    pub lanes: Vec<lane::Shown>,
    /// The collectors, the root first.
    pub collectors: Vec<collector::Out>,
}

impl Shown {
    /// What node `node` shows to the outside.
    fn node(&self, node: usize) -> lane::Out {
        match self.collectors.get(node - 1) {
            Some(&collector::Out { read, data_ready, write, pixel, .. }) => {
                let in_ready = self.distributors[node - 1].in_ready;
                lane::Out { in_ready, read, data_ready, write, pixel, ..lane::Out::default() }
            }
            None => self.lanes[node - self.lanes.len()].ports(),
        }
    }

    /// What all show together, but for their events.
    #[must_use]
    pub fn ports(&self) -> lane::Out {
        self.node(1)
    }

    /// What each node sees where the root sees `inputs`; a lane's inputs are at `lanes.len()` and its number.
    #[must_use]
    pub fn seen(&self, inputs: &lane::In) -> Vec<lane::In> {
        let mut seen = vec![lane::In::default(); 2 * self.lanes.len()];
        seen[1] = *inputs;
        for (node, (distributes, collects)) in (1..).zip(self.distributors.iter().zip(&self.collectors)) {
            let above = seen[node];
            seen[2 * node] = lane::In {
                input: distributes.low,
                read_ready: collects.low_read_ready,
                data: collects.low_data,
                write_ready: collects.low_write_ready,
                pixel_ready: collects.low_pixel_ready,
                ..above
            };
            seen[2 * node + 1] = lane::In {
                input: distributes.high,
                read_ready: collects.high_read_ready,
                data: collects.high_data,
                write_ready: collects.high_write_ready,
                pixel_ready: collects.high_pixel_ready,
                ..above
            };
        }
        (0..).zip(&mut seen[self.lanes.len()..]).for_each(|(number, lane)| lane.number = number);
        seen
    }

    /// In how many lanes something happened in the last cycle.
    #[must_use]
    pub fn events(&self) -> Events {
        let mut counts = Events::default();
        for lane in &self.lanes {
            let (rasterizer, accumulator) = (lane.rasterizer.events, lane.accumulator.events);
            counts.sample += u8::from(rasterizer.sample);
            counts.starved += u8::from(rasterizer.starved);
            counts.blocked += u8::from(rasterizer.blocked);
            counts.accumulate += u8::from(accumulator.accumulate);
            counts.hazard += u8::from(accumulator.hazard);
            counts.slot_wait += u8::from(accumulator.slot_wait);
        }
        counts
    }
}

/// The lanes.
#[derive(Clone, Debug)]
pub struct Lanes {
    distributors: Vec<Distributor>,
    lanes: Vec<Lane>,
    collectors: Vec<Collector>,
}

impl Lanes {
    /// All after reset, with pipelines of the given lengths.
    #[must_use]
    pub fn new(config: &Config, latencies: &Latencies) -> Self {
        let count = config.rasterizers;
        Self {
            distributors: (1..count).map(|node| Distributor::new(config, node.ilog2())).collect(),
            lanes: vec![Lane::new(config, latencies); count as usize],
            collectors: vec![Collector::default(); count as usize - 1],
        }
    }

    /// What all of them show in this cycle.
    #[must_use]
    pub fn shown(&self) -> Shown {
        Shown {
            distributors: self.distributors.iter().map(Model::outputs).collect(),
            lanes: self.lanes.iter().map(Lane::shown).collect(),
            collectors: self.collectors.iter().map(Model::outputs).collect(),
        }
    }

    /// One clock edge of units that show this; `inputs` are what the root sees.
    pub fn step(&mut self, inputs: &lane::In, shown: &Shown) {
        let seen = shown.seen(inputs);
        for (node, (distributor, collector)) in (1..).zip(self.distributors.iter_mut().zip(&mut self.collectors)) {
            let above = seen[node];
            let [low, high] = [2 * node, 2 * node + 1].map(|below| shown.node(below));
            distributor.clock(&distributor::In {
                input: above.input,
                low_ready: low.in_ready,
                high_ready: high.in_ready,
            });
            collector.clock(&collector::In {
                low_read: low.read,
                low_data_ready: low.data_ready,
                low_write: low.write,
                low_pixel: low.pixel,
                high_read: high.read,
                high_data_ready: high.data_ready,
                high_write: high.write,
                high_pixel: high.pixel,
                read_ready: above.read_ready,
                data: above.data,
                write_ready: above.write_ready,
                pixel_ready: above.pixel_ready,
            });
        }
        let inputs = &seen[self.lanes.len()..];
        for ((lane, inputs), shown) in self.lanes.iter_mut().zip(inputs).zip(&shown.lanes) {
            lane.step(inputs, shown);
        }
    }
}
