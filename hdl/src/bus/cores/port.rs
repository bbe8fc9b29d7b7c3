//! A port by which the renderer reads and writes what only it, or who draws before it, has in memory: payloads, depths.

use pointcore_contract::bus::axi::{ReadMaster, WriteMaster};
use pointcore_contract::bus::units::{reader::Ports as ReaderPorts, writer::Ports as WriterPorts};
use pointcore_contract::unit::In;
use pointcore_contract::{Record, Words};

use super::buffer::{Buffer, Placed, Run};
use super::splat::unfinished;
use super::wiring::Abort;
use crate::bus::{reader, writer};
use crate::units::ports::{Flow, StreamInPorts, StreamOutPorts, WordPort, export};
use crate::units::wires::Wired;
use rtl::{Expr, Instance, Module, bit};

/// A port, and what passes it.
pub(super) struct MemoryPort<'a, P: Record> {
    /// What its instances' names begin with.
    pub name: &'a str,
    /// What a record depends on.
    pub config: &'a P::Config,
    /// Bits of a beat.
    pub bits: u32,
    /// Records of a read at most.
    pub records_max: u32,
    /// Reads that may be under way.
    pub reads_max: u32,
    /// Records that may have been asked for and not come.
    pub awaited_max: u32,
    /// Where the first record lies.
    pub base: Expr,
    /// The bus that is read by.
    pub bus: ReadMaster,
}

/// What the other parts hear of a port.
pub(super) struct PortSignals {
    /// A burst is misshapen.
    pub misplaced: Expr,
    /// Memory answers with an error, to reads and, where there are any, to writes.
    pub errors: Vec<Expr>,
    /// All that was written is answered.
    pub written: Expr,
    /// All records that were asked for have come.
    pub all_came: Expr,
}

impl<P: Record<Domain = Words>> MemoryPort<'_, P> {
    /// Leads a core's reads to memory, and what comes from there to the core's `data`; and what it writes, if it does, by a bus.
    pub fn connect(
        self,
        m: &mut Module,
        read: Flow<Run>,
        (core, data): (Instance, In<P>),
        write: Option<(Flow<Placed<Wired<P>>>, WriteMaster)>,
        abort: Abort,
    ) -> PortSignals {
        let (reader_ports, writer_ports) = (ReaderPorts::<P>::ALL, WriterPorts::<P>::ALL);
        let Self { name, config, bits, records_max, reads_max, awaited_max, base, bus } = self;
        let reads = m.instance(&format!("{name}reads"), reader::limited::<P>(config, bits, records_max, reads_max));
        let writes = write.map(|(write, bus)| {
            let writes = m.instance(&format!("{name}writes"), writer::module::<P>(config, bits));
            (writes, write, bus)
        });
        export(m, &bits, (reads, reader_ports.memory), bus);
        let count = read.record.count;
        let asked = (read.valid & read.ready).repeat(count.width()) & count;
        let buffer = Buffer::<P> { name, config, run_pixels: records_max, memory_bits: bits, base, reads };
        match writes {
            Some((writes, write, bus)) => {
                export(m, &bits, (writes, writer_ports.memory), bus);
                buffer.order(m, read, writes, write);
            }
            None => buffer.read(m, read, bit(true)),
        }

        let came = reader_ports.record.of(m, config, reads);
        let taken = data.offer(m, config, core, came.valid, came.record);
        m.drive(came.ready, taken | abort.drops);
        let awaited = unfinished(m, &format!("{name}awaited"), awaited_max, asked, came.transfer(), bit(false));
        let [misplaced, read_error] = [reader_ports.misplaced, reader_ports.error].map(|port| port.word_of(m, reads));
        let mut signals =
            PortSignals { misplaced, errors: vec![read_error], written: bit(true), all_came: awaited.is_zero() };
        if let Some((writes, ..)) = writes {
            signals.errors.push(writer_ports.error.word_of(m, writes));
            signals.written = writer_ports.idle.word_of(m, writes);
        }
        signals
    }
}
