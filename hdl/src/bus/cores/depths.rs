//! Depths in memory (`docs/interfaces.md`), which fragments are tested against, or samples of what moves: each stream of fragments, or each
//! rasterizer, has a port for those of its tiles.

use pointcore_contract::bus::config::READS_MAX;
use pointcore_contract::bus::units::splat_axi::Ports;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{MERGED_DEPTH_BITS, RUN_PIXELS_MAX, TILE_PIXELS};
use pointcore_contract::splat::records::{Depth, DepthRun, StoredDepth};
use pointcore_contract::splat::units::top::PORTS;

use super::buffer::{Placed, Run};
use super::port::{MemoryPort, PortSignals};
use super::wiring::Abort;
use crate::units::ports::StreamOutPorts;
use rtl::{Expr, Instance, Module};

const TOP: Ports = Ports::ALL;

/// Connects a core's ports to the depths from `base` on.
pub(super) fn connect(m: &mut Module, config: &Config, core: Instance, base: Expr, abort: Abort) -> Vec<PortSignals> {
    // A tile's depths are asked for when it gets its slot.
    let ahead = if config.tests_samples() { config.tile_slots * TILE_PIXELS } else { config.merge_ahead };
    let connect_port = |port: usize| {
        let read = PORTS.depth_read[port].of(m, config, core);
        let memory = MemoryPort::<Depth> {
            name: &format!("depth_{port}_"),
            config,
            bits: MERGED_DEPTH_BITS,
            records_max: RUN_PIXELS_MAX,
            reads_max: ahead.min(READS_MAX),
            awaited_max: ahead,
            base,
            bus: TOP.depth_reads[port],
        };
        let read = read.map(|DepthRun { tile, pixel, count }| Run { tile, pixel, count });
        let write = config.tests_fragments().then(|| {
            let write = PORTS.depth_write[port].of(m, config, core);
            (write.map(|StoredDepth { tile, pixel, value }| Placed { tile, pixel, value }), TOP.depth_writes[port])
        });
        memory.connect(m, read, (core, PORTS.depth_data[port]), write, abort)
    };
    (0..config.merge_ports() as usize).map(connect_port).collect()
}
