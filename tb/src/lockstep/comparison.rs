//! Equality of outputs, up to what the unit leaves open.

use super::failure::PortDifference;
use super::stream::Streams;
use crate::verilated::{Direction, Port};

/// Sets the outputs that do not matter to the same value on both sides: `mask(hardware, golden)`.
pub type Mask = Box<dyn FnMut(&mut [u64], &mut [u64]) + Send>;

/// Compares outputs; scratch space included, so that nothing is allocated in a cycle.
pub struct Comparison {
    streams: Streams,
    mask: Option<Mask>,
    hardware: Vec<u64>,
    golden: Vec<u64>,
}

impl Comparison {
    pub fn new(streams: Streams, outputs: usize) -> Self {
        Self { streams, mask: None, hardware: vec![0; outputs], golden: vec![0; outputs] }
    }

    pub fn set_mask(&mut self, mask: Mask) {
        self.mask = Some(mask);
    }

    /// Whether the outputs agree. Equal words need no mask, which is the common case and the fast one.
    pub fn agree(&mut self, hardware: &[u64], golden: &[u64]) -> bool {
        if hardware == golden {
            return true;
        }
        self.hardware.copy_from_slice(hardware);
        self.golden.copy_from_slice(golden);
        mask_idle_streams(&self.streams, &mut self.hardware);
        mask_idle_streams(&self.streams, &mut self.golden);
        if let Some(mask) = &mut self.mask {
            mask(&mut self.hardware, &mut self.golden);
        }
        self.hardware == self.golden
    }

    /// The ports that made the last [`Comparison::agree`] false.
    pub fn differences(&self, outputs: &[Port]) -> Vec<PortDifference> {
        let pairs = self.hardware.iter().zip(&self.golden).zip(outputs);
        let differing = pairs.filter(|((hardware, golden), _)| hardware != golden);
        differing
            .map(|((&hardware, &golden), port)| PortDifference { port: port.name.clone(), hardware, golden })
            .collect()
    }
}

/// The fields of a stream that offers nothing mean nothing.
fn mask_idle_streams(streams: &Streams, outputs: &mut [u64]) {
    for stream in streams.iter().filter(|stream| stream.direction == Direction::Output) {
        if outputs[stream.valid] == 0 {
            stream.fields.iter().for_each(|&field| outputs[field] = 0);
        }
    }
}
