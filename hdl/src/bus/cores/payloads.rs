//! Payloads in memory (`docs/interfaces.md`): each rasterizer has a port for those of its splats.

use pointcore_contract::bus::config::READS_MAX;
use pointcore_contract::bus::units::splat_axi::Ports;
use pointcore_contract::bus::units::{reader::Ports as ReaderPorts, writer::Ports as WriterPorts};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::index_bits;
use pointcore_contract::splat::records::{PayloadPlace, PayloadWord, StoredWord};
use pointcore_contract::splat::units::top::PORTS;

use super::buffer::{Buffer, Placed, Run};
use super::splat::unfinished;
use super::wiring::Abort;
use crate::bus::{reader, writer};
use crate::units::ports::{StreamInPorts, StreamOutPorts, WordPort, export};
use rtl::{Expr, Instance, Module, address_width, bit, cat, lit};

const TOP: Ports = Ports::ALL;
const READS: ReaderPorts<PayloadWord> = ReaderPorts::ALL;
const WRITES: WriterPorts<PayloadWord> = WriterPorts::ALL;

/// What the other parts hear of a port.
pub(super) struct PortSignals {
    /// A burst is misshapen.
    pub misplaced: Expr,
    /// Memory answers with an error, to reads and to writes.
    pub errors: [Expr; 2],
    /// All that was written is answered.
    pub written: Expr,
    /// All words that were asked for have come.
    pub all_came: Expr,
}

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
    let (bits, words) = (config.bus.memory_bits, config.payload_beats);
    let name = format!("payload_{port}_");
    let requests = config.payload_ahead.clamp(2, READS_MAX);
    let reads = m.instance(&format!("{name}reads"), reader::limited::<PayloadWord>(config, bits, words, requests));
    let writes = m.instance(&format!("{name}writes"), writer::module::<PayloadWord>(config, bits));
    export(m, &bits, (reads, READS.memory), TOP.payload_reads[port]);
    export(m, &bits, (writes, WRITES.memory), TOP.payload_writes[port]);

    // A place takes a power of two of words.
    let word_bits = index_bits(words);
    let rasterizer = (config.rasterizers > 1).then(|| lit(config.rasterizer_bits(), port as u128));
    let place = |splat: Expr| rasterizer.map_or(splat, |rasterizer| cat([rasterizer, splat]));
    let wanted = PORTS.payload_read[port].of(m, config, core);
    let word = PORTS.payload_write[port].of(m, config, core);
    let asked_bits = address_width(words + 1);
    let asked = wanted.transfer().repeat(asked_bits) & lit(asked_bits, words.into());
    let read = wanted.map(|PayloadPlace { splat }| Run {
        tile: place(splat),
        pixel: lit(word_bits, 0),
        count: lit(asked_bits, words.into()),
    });
    let write = word.map(|StoredWord { splat, word, value }| Placed { tile: place(splat), pixel: word, value });
    let buffer =
        Buffer::<PayloadWord> { name: &name, config, run_pixels: words, memory_bits: bits, base, reads, writes };
    buffer.order(m, read, write);

    let came = READS.record.of(m, config, reads);
    let taken = PORTS.payload_data[port].offer(m, config, core, came.valid, came.record);
    m.drive(came.ready, taken | abort.drops);
    let most = config.payload_ahead * words;
    let awaited = unfinished(m, &format!("{name}awaited"), most, asked, came.transfer(), bit(false));
    let [misplaced, read_error] = [READS.misplaced, READS.error].map(|port| port.word_of(m, reads));
    let [write_error, written] = [WRITES.error, WRITES.idle].map(|port| port.word_of(m, writes));
    PortSignals { misplaced, errors: [read_error, write_error], written, all_came: awaited.is_zero() }
}
