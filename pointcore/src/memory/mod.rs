//! External memory as the cores see it: latency, bandwidth, bursts, and completion in or out of order.
//!
//! Requests of all ports share one bus. A request waits for the latency, then its transfer occupies the bus for its bytes,
//! rounded up to whole bursts, at the given bandwidth; its beats leave in order and together, one a cycle and port at most. What the
//! core does not take waits in the controller while the bus goes on.

mod bus;
mod read_write;

pub use bus::Bus;
pub use read_write::{ReadWriteMemory, Traffic};

use bus::WrittenBursts;

use serde::Serialize;
use std::collections::VecDeque;
use std::ops::RangeInclusive;

/// A setting of the memory without meaning.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("the memory's {setting} is {value}: expected {expected}")]
pub struct MemoryError {
    /// What is set.
    pub setting: &'static str,
    /// To what.
    pub value: f64,
    /// What would be right.
    pub expected: &'static str,
}

/// How the memory answers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MemorySettings {
    /// Cycles from a request to the first beat of its answer, if the bus is free.
    pub latency_cycles: u64,
    /// Bytes that the bus moves in a cycle; `None` for as many as the core's port.
    pub bytes_per_cycle: Option<f64>,
    /// Bytes that the memory can only move together; 1 for any number.
    pub burst_bytes: u32,
    /// Among how many of the oldest requests the next one to be answered is chosen at random; 1 keeps their order.
    pub reorder_window: usize,
}

impl Default for MemorySettings {
    fn default() -> Self {
        Self { latency_cycles: 40, bytes_per_cycle: None, burst_bytes: 1, reorder_window: 1 }
    }
}

impl MemorySettings {
    /// Cycles of latency that make sense.
    pub const LATENCY_CYCLES: RangeInclusive<u64> = 1..=500;
    /// Bandwidths that make sense: from a serial flash to anything on a die.
    pub const BYTES_PER_CYCLE: RangeInclusive<f64> = 0.01..=65_536.0;

    /// Checks every setting.
    ///
    /// # Errors
    /// The first one that no memory has.
    pub fn validate(&self) -> Result<(), MemoryError> {
        let wrong = |setting, value, expected| Err(MemoryError { setting, value, expected });
        if !Self::LATENCY_CYCLES.contains(&self.latency_cycles) {
            return wrong("latency", self.latency_cycles as f64, "1 to 500 cycles");
        }
        match self.bytes_per_cycle {
            Some(bytes) if !Self::BYTES_PER_CYCLE.contains(&bytes) => {
                return wrong("bandwidth", bytes, "0.01 to 65536 bytes a cycle");
            }
            _ => {}
        }
        if self.burst_bytes == 0 {
            return wrong("burst", 0.0, "1 byte at least");
        }
        if self.reorder_window == 0 {
            return wrong("reorder window", 0.0, "1 request at least");
        }
        Ok(())
    }
}

/// What a request asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RequestSize {
    /// Beats of the answer, at least one.
    pub beats: u32,
    /// Bytes of a beat.
    pub beat_bytes: u32,
}

impl RequestSize {
    /// Bytes of the answer.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        u64::from(self.beats) * u64::from(self.beat_bytes)
    }
}

#[derive(Clone, Debug)]
struct Request<K> {
    port: usize,
    key: K,
    extent: RequestSize,
    ready: u64,
}

/// An answer on the bus or behind it.
#[derive(Clone, Debug)]
struct Answer<K> {
    key: K,
    extent: RequestSize,
    /// When the bus began with it, in cycles.
    begin: f64,
    sent: u32,
}

/// A memory with some ports; requests and answers bear a key.
#[derive(Clone, Debug)]
pub struct ExternalMemory<K> {
    settings: MemorySettings,
    bus: Bus,
    random: fastrand::Rng,
    requests: VecDeque<Request<K>>,
    /// Whether a port's requests are answered in their order, whatever the settings say.
    is_ordered: Vec<bool>,
    answers: Vec<VecDeque<Answer<K>>>,
    /// Requests accepted.
    pub requests_taken: u64,
}

impl<K: Copy> ExternalMemory<K> {
    /// An idle memory with so many ports; without a bandwidth among the settings, the bus moves `beat_bytes` a cycle. `seed` decides
    /// the order of answers.
    #[must_use]
    pub fn new(settings: MemorySettings, ports: usize, beat_bytes: u32, seed: u64) -> Self {
        Self {
            settings,
            bus: Bus::new(&settings, beat_bytes),
            random: fastrand::Rng::with_seed(seed),
            requests: VecDeque::new(),
            is_ordered: vec![false; ports],
            answers: (0..ports).map(|_| VecDeque::new()).collect(),
            requests_taken: 0,
        }
    }

    /// Answers the requests of a port in their order.
    #[must_use]
    pub fn ordered(mut self, port: usize) -> Self {
        self.is_ordered[port] = true;
        self
    }

    /// The bus that all ports share.
    #[must_use]
    pub const fn bus(&self) -> &Bus {
        &self.bus
    }

    /// The bus, for what takes it besides the answers.
    pub const fn bus_mut(&mut self) -> &mut Bus {
        &mut self.bus
    }

    /// Cycles from a request to the end of its answer on an idle bus.
    #[must_use]
    pub fn answer_cycles(&self, extent: RequestSize) -> u64 {
        self.settings.latency_cycles + self.bus.transfer_cycles(extent.bytes()).ceil() as u64
    }

    /// Accepts a request in cycle `now`.
    pub fn request(&mut self, port: usize, key: K, extent: RequestSize, now: u64) {
        self.requests_taken += 1;
        self.requests.push_back(Request { port, key, extent, ready: now + self.settings.latency_cycles });
    }

    /// Gives the bus to requests as long as it gets free before cycle `now` ends.
    pub fn advance(&mut self, now: u64) {
        while self.bus.is_free(now) {
            let window = self.requests.len().min(self.settings.reorder_window);
            let ready = (0..window).filter(|index| self.requests[*index].ready <= now);
            let chosen = if self.settings.reorder_window == 1 {
                ready.min()
            } else {
                self.random.choice(ready.collect::<Vec<_>>())
            };
            let chosen = chosen.map(|index| self.in_order(index)).and_then(|index| self.requests.remove(index));
            let Some(Request { port, key, extent, .. }) = chosen else { return };
            let begin = self.bus.transfer(extent.bytes(), now);
            self.answers[port].push_back(Answer { key, extent, begin, sent: 0 });
        }
    }

    /// The request to be answered in the place of a chosen one: the oldest of its port, where that is ordered.
    fn in_order(&self, chosen: usize) -> usize {
        let port = self.requests[chosen].port;
        let oldest = || self.requests.iter().position(|request| request.port == port);
        if self.is_ordered[port] { oldest().unwrap_or(chosen) } else { chosen }
    }

    /// The beat on offer at a port in cycle `now`: the key of its request and its number in the answer.
    #[must_use]
    pub fn offer(&self, port: usize, now: u64) -> Option<(K, u32)> {
        let answer = self.answers[port].front()?;
        let bytes = (answer.sent + 1) * answer.extent.beat_bytes;
        let complete = answer.begin + f64::from(bytes) / self.bus.bytes_per_cycle();
        (complete <= (now + 1) as f64).then_some((answer.key, answer.sent))
    }

    /// The beat on offer at a port was taken.
    pub fn take(&mut self, port: usize) {
        let answers = &mut self.answers[port];
        if let Some(answer) = answers.front_mut() {
            answer.sent += 1;
            if answer.sent == answer.extent.beats {
                answers.pop_front();
            }
        }
    }
}

#[cfg(test)]
mod tests;
