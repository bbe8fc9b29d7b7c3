//! The bus of a memory: one transfer at a time, at so many bytes a cycle, in whole bursts.

use super::MemorySettings;
use std::ops::Range;

/// A bus.
#[derive(Clone, Debug)]
pub struct Bus {
    bytes_per_cycle: f64,
    burst_bytes: u32,
    /// When the last transfer ends, in cycles.
    free: f64,
    bytes: u64,
}

impl Bus {
    /// An idle bus; without a bandwidth among the settings, it moves `beat_bytes` a cycle.
    #[must_use]
    pub fn new(settings: &MemorySettings, beat_bytes: u32) -> Self {
        let bytes_per_cycle = settings.bytes_per_cycle.unwrap_or(beat_bytes.into());
        Self { bytes_per_cycle, burst_bytes: settings.burst_bytes, free: 0.0, bytes: 0 }
    }

    /// Bytes that it can move in a cycle.
    #[must_use]
    pub const fn bytes_per_cycle(&self) -> f64 {
        self.bytes_per_cycle
    }

    /// Bytes moved, whole bursts.
    #[must_use]
    pub const fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Cycles that all transfers took together.
    #[must_use]
    pub fn busy_cycles(&self) -> f64 {
        self.bytes as f64 / self.bytes_per_cycle
    }

    fn whole_bursts(&self, bytes: u64) -> u64 {
        bytes.next_multiple_of(self.burst_bytes.into())
    }

    /// Cycles that a transfer takes.
    #[must_use]
    pub fn transfer_cycles(&self, bytes: u64) -> f64 {
        self.whole_bursts(bytes) as f64 / self.bytes_per_cycle
    }

    /// Whether a transfer can begin before cycle `now` ends.
    #[must_use]
    pub fn is_free(&self, now: u64) -> bool {
        self.free < (now + 1) as f64
    }

    /// Takes the bus for a transfer as soon as it is free, not before cycle `now`; returns when the transfer begins, in cycles.
    pub fn transfer(&mut self, bytes: u64, now: u64) -> f64 {
        let begin = self.free.max(now as f64);
        self.free = begin + self.transfer_cycles(bytes);
        self.bytes += self.whole_bursts(bytes);
        begin
    }
}

/// Writes of one port, of which those that follow each other in a burst cost it once.
#[derive(Clone, Copy, Debug)]
pub(super) struct WrittenBursts {
    burst_bytes: u32,
    /// The burst written last, by block and number.
    last: Option<(usize, u32)>,
}

impl WrittenBursts {
    /// A port to which nothing was written.
    #[must_use]
    pub const fn new(settings: &MemorySettings) -> Self {
        Self { burst_bytes: settings.burst_bytes, last: None }
    }

    /// Bytes that a write of these bytes of a block costs, whole bursts. Every block begins a burst.
    pub fn bytes(&mut self, block: usize, bytes: Range<u32>) -> u64 {
        let bursts = bytes.start / self.burst_bytes..=(bytes.end - 1) / self.burst_bytes;
        let last = (block, *bursts.end());
        let begun = bursts.filter(|burst| self.last != Some((block, *burst))).count();
        self.last = Some(last);
        begun as u64 * u64::from(self.burst_bytes)
    }
}
