//! Payloads in memory (`docs/interfaces.md`): each rasterizer has a port for those of its splats.

use pointcore_contract::bus::config::READS_MAX;
use pointcore_contract::bus::units::splat_axi::Ports;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::index_bits;
use pointcore_contract::splat::records::{PayloadPlace, PayloadWord, StoredWord};
use pointcore_contract::splat::units::top::PORTS;

use super::buffer::{Placed, Run};
use super::port::{MemoryPort, PortSignals};
use super::wiring::Abort;
use crate::units::ports::StreamOutPorts;
use rtl::{Expr, Instance, Module, address_width, cat, lit};

const TOP: Ports = Ports::ALL;

/// Connects a core's ports to payloads, the rasterizers' one behind the other from `base` on.
pub(super) fn connect(m: &mut Module, config: &Config, core: Instance, base: Expr, abort: Abort) -> Vec<PortSignals> {
    (0..config.payload_ports() as usize).map(|port| connect_port(m, config, core, (port, base), abort)).collect()
}

fn connect_port(
    m: &mut Module,
    config: &Config,
    core: Instance,
    (port, base): (usize, Expr),
    abort: Abort,
) -> PortSignals {
    let words = config.payload_beats;
    // A place takes a power of two of words.
    let word_bits = index_bits(words);
    let rasterizer = (config.rasterizers > 1).then(|| lit(config.rasterizer_bits(), port as u128));
    let place = |splat: Expr| rasterizer.map_or(splat, |rasterizer| cat([rasterizer, splat]));
    let read = PORTS.payload_read[port].of(m, config, core).map(|PayloadPlace { splat }| Run {
        tile: place(splat),
        pixel: lit(word_bits, 0),
        count: lit(address_width(words + 1), words.into()),
    });
    let write = PORTS.payload_write[port].of(m, config, core);
    let write = write.map(|StoredWord { splat, word, value }| Placed { tile: place(splat), pixel: word, value });
    let memory = MemoryPort::<PayloadWord> {
        name: &format!("payload_{port}_"),
        config,
        bits: config.bus.memory_bits,
        records_max: words,
        reads_max: config.payload_ahead.clamp(2, READS_MAX),
        awaited_max: config.payload_ahead * words,
        base,
        bus: TOP.payload_reads[port],
    };
    memory.connect(m, read, (core, PORTS.payload_data[port]), Some((write, TOP.payload_writes[port])), abort)
}
