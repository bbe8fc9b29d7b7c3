//! How the memory answers: the arguments that `run`, `knn` and `process` share.

use super::numbers;
use pointcore::memory::MemorySettings;

/// Requests among which an out-of-order memory chooses.
const REORDER_WINDOW: usize = 8;

/// Arguments of the memory's bus.
#[derive(clap::Args)]
pub struct BusArguments {
    /// Cycles from a request to the memory to its answer, 1 to 500; by default 40 for points, 24 for the reconstruction buffer.
    #[arg(long, value_name = "CYCLES", value_parser = numbers::within(MemorySettings::LATENCY_CYCLES, "1 to 500 cycles"))]
    latency: Option<u64>,
    /// Bytes that the memory moves in a cycle, may be fractional; by default a beat of points, or a pixel each way.
    #[arg(long, value_name = "BYTES", value_parser = numbers::within(MemorySettings::BYTES_PER_CYCLE, "0.01 to 65536 bytes a cycle"))]
    bandwidth: Option<f64>,
    /// Bytes that the memory can only move together, 1 by default.
    #[arg(long, value_name = "BYTES", value_parser = numbers::within(1_u32.., "1 byte at least"))]
    burst: Option<u32>,
}

impl BusArguments {
    /// Whether any is given.
    pub const fn is_given(&self) -> bool {
        self.latency.is_some() || self.bandwidth.is_some() || self.burst.is_some()
    }

    /// How the memory answers that otherwise does as `usual`.
    pub fn settings(&self, usual: MemorySettings) -> MemorySettings {
        MemorySettings {
            latency_cycles: self.latency.unwrap_or(usual.latency_cycles),
            bytes_per_cycle: self.bandwidth.or(usual.bytes_per_cycle),
            burst_bytes: self.burst.unwrap_or(usual.burst_bytes),
            ..usual
        }
    }
}

/// Arguments of a memory of points.
#[derive(clap::Args)]
pub struct MemoryArguments {
    #[command(flatten)]
    bus: BusArguments,
    /// Let answers of the memory overtake each other.
    #[arg(long)]
    out_of_order: bool,
}

impl MemoryArguments {
    /// How it answers.
    pub fn settings(&self) -> MemorySettings {
        let reorder_window = if self.out_of_order { REORDER_WINDOW } else { 1 };
        MemorySettings { reorder_window, ..self.bus.settings(MemorySettings::default()) }
    }
}
