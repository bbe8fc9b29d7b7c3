//! What a comparison of the renderer's units leaves open.

use pointcore_contract::Direction;
use pointcore_contract::splat::Port;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Names of the ports of a direction, in the order of their words.
fn names(ports: &[Port], direction: Direction) -> impl Iterator<Item = &str> {
    ports.iter().filter(move |port| port.direction == direction).map(|port| port.name.as_str())
}

fn place(ports: &[Port], direction: Direction, name: &str) -> usize {
    names(ports, direction).position(|port| port == name).expect("masks name ports of their own unit")
}

/// A mask for [`Lockstep`](pointcore_tb::lockstep::Lockstep): an end record carries nothing else, so its other fields are left open.
pub fn end_records(ports: &[Port]) -> impl FnMut(&mut [u64], &mut [u64]) + Send + 'static {
    let outputs: Vec<_> = ports.iter().filter(|port| port.direction == Direction::Output).collect();
    let record = |(end, port): (usize, &&Port)| {
        let stream = port.name.strip_suffix("end").filter(|stream| stream.ends_with('_'))?;
        let fields = outputs[end + 1..].iter().take_while(|port| port.name.starts_with(stream)).count();
        Some((end, end + 1..end + 1 + fields))
    };
    let records: Vec<(usize, Range<usize>)> = outputs.iter().enumerate().filter_map(record).collect();
    move |hardware, golden| {
        for words in [hardware, golden] {
            for (end, fields) in &records {
                if words[*end] == 1 {
                    words[fields.clone()].fill(0);
                }
            }
        }
    }
}

/// The mask of the tile cache: end records, and the pixel to be drained while none is.
///
/// # Panics
/// When the ports are another unit's.
pub fn tile_cache(ports: &[Port]) -> impl FnMut(&mut [u64], &mut [u64]) + Send + 'static {
    let mut end_records = end_records(ports);
    let [enable, slot, pixel] =
        ["drain_enable", "drain_slot", "drain_pixel"].map(|name| place(ports, Direction::Output, name));
    move |hardware, golden| {
        end_records(hardware, golden);
        for words in [hardware, golden] {
            if words[enable] == 0 {
                (words[slot], words[pixel]) = (0, 0);
            }
        }
    }
}

/// The mask of the accumulator: a drained pixel shows from the cycle after its slot's next drain until the slot is ready again,
/// when samples read it. Inputs decide, so it watches what the model sees.
pub struct DrainedPixel {
    enable: usize,
    slot: usize,
    ready: usize,
    pixel: Vec<usize>,
    shows: Arc<AtomicBool>,
}

impl DrainedPixel {
    /// For the accumulator's ports in the order of the words.
    ///
    /// # Panics
    /// When the ports are another unit's.
    #[must_use]
    pub fn new(ports: &[Port]) -> Self {
        let [enable, slot, ready] =
            ["drain_enable", "drain_slot", "slot_ready"].map(|name| place(ports, Direction::Input, name));
        let outputs = names(ports, Direction::Output).enumerate();
        let pixel = outputs.filter(|(_, name)| name.starts_with("drain_")).map(|(place, _)| place).collect();
        Self { enable, slot, ready, pixel, shows: Arc::default() }
    }

    /// The model, watched.
    pub fn watch<M: FnMut(&[u64], &mut [u64])>(&self, mut model: M) -> impl FnMut(&[u64], &mut [u64]) + use<M> {
        let (enable, slot_port, ready, shows) = (self.enable, self.slot, self.ready, Arc::clone(&self.shows));
        // The slots of the last drain and of the one before.
        let (mut read, mut drained) = (None, None);
        move |inputs, outputs| {
            shows.store(drained.is_some(), Ordering::Relaxed);
            model(inputs, outputs);
            let mut unready = |slot: &u64| inputs[ready] >> slot & 1 == 0;
            if inputs[enable] == 1 {
                drained = read.filter(|slot| *slot == inputs[slot_port]);
                read = Some(inputs[slot_port]);
            }
            (read, drained) = (read.filter(&mut unready), drained.filter(&mut unready));
        }
    }

    /// The mask itself.
    pub fn mask(self) -> impl FnMut(&mut [u64], &mut [u64]) + Send + 'static {
        move |hardware, golden| {
            if !self.shows.load(Ordering::Relaxed) {
                for words in [hardware, golden] {
                    self.pixel.iter().for_each(|&place| words[place] = 0);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::{Config, ports};

    #[test]
    fn only_fields_behind_end_are_open() {
        let ports = ports::splitter(&Config::default());
        let mut mask = end_records(&ports);
        let count = ports.iter().filter(|port| port.direction == Direction::Output).count();
        // `in_ready`, `out_valid`, `out_end`, then the fields.
        let (mut hardware, mut golden) = (vec![1; count], vec![1; count]);
        golden[3] = 7;
        mask(&mut hardware, &mut golden);
        assert_eq!(hardware, golden);
        let (mut hardware, mut golden) = (vec![0; count], vec![0; count]);
        golden[3] = 7;
        mask(&mut hardware, &mut golden);
        assert_ne!(hardware, golden);
    }
}
