//! What a comparison of the renderer's units leaves open.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::SLOT_BANKS;
use pointcore_contract::splat::units::accumulator::{self, In, Out};
use pointcore_contract::{Direction, Interface};
use pointcore_golden::unit::Model;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The field of a record that closes a frame.
const END: &str = "end";

const BANKS: usize = SLOT_BANKS as usize;

/// Names of a unit's outputs, in the order of the contract.
#[must_use]
pub fn outputs(interface: &Interface) -> Vec<String> {
    let outputs = interface.ports().into_iter().filter(|port| port.direction == Direction::Output);
    outputs.map(|port| port.name).collect()
}

fn place(outputs: &[String], name: &str) -> usize {
    outputs.iter().position(|port| port == name).expect("a unit has the outputs of its interface")
}

/// A mask for [`Lockstep`](pointcore_tb::lockstep::Lockstep), for a unit whose outputs come in this order: an end record carries
/// nothing else, so its other fields are left open.
///
/// # Panics
/// When the outputs are another unit's.
pub fn end_records(
    interface: &Interface,
    outputs: &[String],
) -> impl FnMut(&mut [u64], &mut [u64]) + Send + 'static + use<> {
    let records = interface.groups.iter().filter(|group| group.kind.direction() == Direction::Output);
    let records = records.filter_map(|group| {
        let (ends, others): (Vec<_>, Vec<_>) = group.fields.iter().partition(|field| field.name == END);
        let place = |name: &str| place(outputs, &group.port_name(name));
        let others: Vec<usize> = others.iter().map(|field| place(&field.name)).collect();
        (!ends.is_empty()).then(|| (place(END), others))
    });
    let records: Vec<_> = records.collect();
    move |hardware, golden| {
        for words in [hardware, golden] {
            for (end, others) in &records {
                if words[*end] == 1 {
                    others.iter().for_each(|&other| words[other] = 0);
                }
            }
        }
    }
}

/// The mask of the accumulator: what a slot held before its first tile is anything, and shows when it gets that one. Inputs decide, so
/// it watches what the model sees.
pub struct HeldBefore {
    masks: Vec<usize>,
    shows: Arc<AtomicBool>,
}

impl HeldBefore {
    /// For an accumulator whose outputs come in this order.
    ///
    /// # Panics
    /// When the outputs are another unit's.
    #[must_use]
    pub fn new(config: &Config, outputs: &[String]) -> Self {
        let interface = (accumulator::UNIT.interface)(config);
        let name = accumulator::PORTS.masks.name;
        let group = interface.groups.iter().find(|group| group.name == name).expect("an accumulator shows masks");
        let masks = group.fields.iter().map(|field| place(outputs, &group.port_name(&field.name))).collect();
        Self { masks, shows: Arc::default() }
    }

    /// The model, watched.
    pub fn watch<M: Model<Config = Config, In = In, Out = Out>>(&self, model: M) -> Watched<M> {
        Watched { model, changed: [0; BANKS], is_known: [false; BANKS], shows: Arc::clone(&self.shows) }
    }

    /// The mask itself.
    pub fn mask(self) -> impl FnMut(&mut [u64], &mut [u64]) + Send + 'static {
        move |hardware, golden| {
            if !self.shows.load(Ordering::Relaxed) {
                for words in [hardware, golden] {
                    self.masks.iter().for_each(|&place| words[place] = 0);
                }
            }
        }
    }
}

/// A model of the accumulator under the eyes of a [`HeldBefore`].
#[derive(Clone)]
pub struct Watched<M> {
    model: M,
    /// By bank: a bit for each slot that had a tile.
    changed: [u64; BANKS],
    /// Whether the one that changed last had one before.
    is_known: [bool; BANKS],
    shows: Arc<AtomicBool>,
}

impl<M: Model<Config = Config, In = In, Out = Out>> Model for Watched<M> {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        self.shows.store(self.is_known.iter().all(|is_known| *is_known), Ordering::Relaxed);
        self.model.outputs()
    }

    fn clock(&mut self, inputs: &In) {
        let reads = self.model.outputs().sample_reads;
        if let Some(change) = inputs.change {
            let is_free = |bank: &usize| u32::from(change.banks) & !reads & (1 << bank) != 0;
            for bank in (0..BANKS).filter(is_free) {
                self.is_known[bank] = self.changed[bank] >> change.slot & 1 == 1;
                self.changed[bank] |= 1 << change.slot;
            }
        }
        self.model.clock(inputs);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::units::splitter;

    #[test]
    fn only_fields_behind_end_are_open() {
        let interface = (splitter::UNIT.interface)(&Config::default());
        let outputs = outputs(&interface);
        let mut mask = end_records(&interface, &outputs);
        let [end, tile] = ["out_end", "out_tile"].map(|name| place(&outputs, name));
        let mut masked = |ends: u64| {
            let (mut hardware, mut golden) = (vec![1; outputs.len()], vec![1; outputs.len()]);
            (hardware[end], golden[end], golden[tile]) = (ends, ends, 7);
            mask(&mut hardware, &mut golden);
            hardware == golden
        };
        assert!(masked(1) && !masked(0));
    }
}
