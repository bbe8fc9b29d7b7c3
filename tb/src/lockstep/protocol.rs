//! The rules of a stream, watched from the outside: once raised, `valid` and its data hold until the transfer.

use super::failure::ProtocolViolation;
use super::stream::{StreamPorts, Streams};

/// Watches all streams of a top module and counts their transfers.
#[derive(Debug)]
pub struct Protocol {
    watched: Vec<Watched>,
    /// Position of the reset among the inputs: it ends all promises.
    reset: Option<usize>,
}

#[derive(Debug)]
struct Watched {
    stream: StreamPorts,
    transfers: u64,
    /// Whether an item was offered and not taken in the cycle before; its fields are in `offered`.
    waiting: bool,
    offered: Vec<u64>,
}

impl Protocol {
    pub fn new(streams: &Streams, reset: Option<usize>) -> Self {
        let watch = |stream: &StreamPorts| Watched {
            stream: stream.clone(),
            transfers: 0,
            waiting: false,
            offered: vec![0; stream.fields.len()],
        };
        Self { watched: streams.iter().map(watch).collect(), reset }
    }

    /// Checks one cycle against the one before.
    pub fn check(&mut self, inputs: &[u64], outputs: &[u64]) -> Result<(), ProtocolViolation> {
        let in_reset = self.reset.is_some_and(|reset| inputs[reset] != 0);
        for watched in &mut self.watched {
            let stream = &watched.stream;
            let (forward, _) = stream.sides(inputs, outputs);
            let valid = forward[stream.valid] != 0;
            if watched.waiting && !valid {
                return Err(ProtocolViolation::Withdrawn { stream: stream.name.clone() });
            }
            let fields = || stream.fields.iter().map(|&field| forward[field]);
            if watched.waiting && !fields().eq(watched.offered.iter().copied()) {
                return Err(ProtocolViolation::Changed { stream: stream.name.clone() });
            }
            let taken = stream.transfers(inputs, outputs);
            watched.waiting = valid && !taken && !in_reset;
            watched.transfers += u64::from(taken && !in_reset);
            if watched.waiting {
                watched.offered.iter_mut().zip(fields()).for_each(|(before, now)| *before = now);
            }
        }
        Ok(())
    }

    /// Transfers of each stream so far.
    pub fn transfers(&self) -> impl Iterator<Item = (&StreamPorts, u64)> {
        self.watched.iter().map(|watched| (&watched.stream, watched.transfers))
    }
}
