//! How the memory answers: the arguments that `knn` and `process` share.

use super::numbers;
use pointcore::search::MemorySettings;

/// Requests among which an out-of-order memory chooses.
const REORDER_WINDOW: usize = 8;

/// Arguments of the memory.
#[derive(clap::Args)]
pub struct MemoryArguments {
    /// Cycles from a request to the memory to its answer, 1 to 500.
    #[arg(long, value_name = "CYCLES", default_value_t = MemorySettings::default().latency_cycles, value_parser = numbers::within(MemorySettings::LATENCY_CYCLES, "1 to 500 cycles"))]
    latency: u64,
    /// Bytes that the memory moves in a cycle, may be fractional; by default a beat of points.
    #[arg(long, value_name = "BYTES", value_parser = numbers::within(MemorySettings::BYTES_PER_CYCLE, "0.01 to 65536 bytes a cycle"))]
    bandwidth: Option<f64>,
    /// Bytes that the memory can only move together.
    #[arg(long, value_name = "BYTES", default_value_t = MemorySettings::default().burst_bytes, value_parser = numbers::within(1_u32.., "1 byte at least"))]
    burst: u32,
    /// Let answers of the memory overtake each other.
    #[arg(long)]
    out_of_order: bool,
}

impl MemoryArguments {
    /// How it answers.
    pub fn settings(&self) -> MemorySettings {
        MemorySettings {
            latency_cycles: self.latency,
            bytes_per_cycle: self.bandwidth,
            burst_bytes: self.burst,
            reorder_window: if self.out_of_order { REORDER_WINDOW } else { 1 },
        }
    }
}
