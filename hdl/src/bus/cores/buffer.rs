//! The reconstruction buffer in memory (`docs/interfaces.md`): the renderer's reads and writes of pixels, in their order; proved in
//! `formal/splat_buffer.sv`.

use pointcore_contract::bus::Layout;
use pointcore_contract::bus::units::{
    Addressed, ReadRequest, reader::Ports as ReaderPorts, writer::Ports as WriterPorts,
};
use pointcore_contract::unit::{In, Out};
use pointcore_contract::{Record, record};

use super::wiring::{feed, place};
use crate::bus::{ADDRESS_BITS, reader, writer};
use crate::units::ports::{Flow, StreamInPorts, StreamOutPorts, WordPort, export};
use crate::units::wires::{Bundle, Wired, Wires, layout};
use rtl::{Expr, Instance, Module, address_width, cat};

/// What lies in memory, and how memory is reached.
pub(super) struct Buffer<'a, P: Record> {
    /// What its wires' names begin with.
    pub name: &'a str,
    /// What a pixel depends on.
    pub config: &'a P::Config,
    /// Pixels of a read at most.
    pub run_pixels: u32,
    /// Bits of a beat.
    pub memory_bits: u32,
    /// Where the first tile lies.
    pub base: Expr,
    /// The unit that reads.
    pub reads: Instance,
    /// The unit that writes.
    pub writes: Instance,
}

/// Pixels that are read.
#[derive(Clone, Copy)]
pub(super) struct Run {
    /// Their tile.
    pub tile: Expr,
    /// Which of the tile's is the first.
    pub pixel: Expr,
    /// How many they are.
    pub count: Expr,
}

/// A pixel with its place.
#[derive(Clone, Copy)]
pub(super) struct Placed<B> {
    /// Its tile.
    pub tile: Expr,
    /// Which of the tile's it is.
    pub pixel: Expr,
    /// What it holds.
    pub value: B,
}

impl<P: Record> Buffer<'_, P> {
    /// Leads reads and writes of pixels to memory. A read sees every write before it: it waits until all are answered, and no other is
    /// taken meanwhile.
    pub fn order(&self, m: &mut Module, read: Flow<Run>, write: Flow<Placed<Wired<P>>>) {
        let stride_bits = Layout::record::<P>(self.config).stride(self.memory_bits).ilog2();
        let writer_idle = WriterPorts::<P>::ALL.idle.word_of(m, self.writes);
        let Run { tile, pixel, count } = read.record;
        let named = |what: &str| format!("{}{what}", self.name);
        let address = m.wire(&named("run_address"), place(self.base, cat([tile, pixel]), stride_bits));
        let reads = (self.reads, ReaderPorts::<P>::ALL.request);
        let request = ReadRequest { address, records: count };
        feed(m, &self.run_pixels, (read.valid, read.ready), reads, writer_idle, request);
        let Placed { tile, pixel, value } = write.record;
        let address = m.wire(&named("pixel_address"), place(self.base, cat([tile, pixel]), stride_bits));
        let no_read = m.wire(&named("no_read"), !read.valid);
        let writes = (self.writes, WriterPorts::<P>::ALL.input);
        feed(m, self.config, (write.valid, write.ready), writes, no_read, Addressed { address, record: value });
    }
}

/// Bits of a place in the buffer.
#[derive(Clone, Copy)]
struct PlaceBits {
    tile: u32,
    pixel: u32,
    count: u32,
}

/// Pixels that are read.
#[record(bits: PlaceBits)]
struct PixelRun {
    /// Tile index.
    #[bits(bits.tile)]
    tile: u32,
    /// First pixel of the tile.
    #[bits(bits.pixel)]
    pixel: u32,
    /// Pixels.
    #[bits(bits.count)]
    count: u32,
}

/// Where a pixel lies.
#[record(bits: PlaceBits)]
struct PixelPlace {
    /// Tile index.
    #[bits(bits.tile)]
    tile: u32,
    /// Pixel of the tile.
    #[bits(bits.pixel)]
    pixel: u32,
}

/// The buffer without its core: few tiles of so many pixels, so many in a read, and so many bursts and writes under way at most that a
/// proof can go through.
#[must_use]
pub fn alone<P: Record>(
    config: &P::Config,
    memory_bits: u32,
    tile_bits: u32,
    [tile_pixels, run_pixels]: [u32; 2],
    limit: u32,
) -> Module {
    let mut m = Module::new("splat_buffer", "The renderer's reconstruction buffer in memory.");
    let reads = m.instance("reads", reader::limited::<P>(config, memory_bits, run_pixels, limit));
    let writes = m.instance("writes", writer::limited::<P>(config, memory_bits, limit));
    let (reader, writer) = (ReaderPorts::<P>::ALL, WriterPorts::<P>::ALL);
    export(&mut m, &memory_bits, (reads, reader.memory), reader.memory);
    export(&mut m, &memory_bits, (writes, writer.memory), writer.memory);
    let base = m.input("base", ADDRESS_BITS);
    let bits = PlaceBits { tile: tile_bits, pixel: address_width(tile_pixels), count: address_width(run_pixels + 1) };
    let read = In::<PixelRun>::new("read", "valid", "Pixels wanted.").declare(&mut m, &bits);
    // The place, then what the pixel holds.
    let write = m.stream_in("write", &[layout::<PixelPlace>(&bits), layout::<P>(config)].concat());
    let mut values = write.fields.iter().map(|(_, value)| *value);
    let PixelPlace { tile, pixel } = PixelPlace::<Wires>::from_values(&bits, values.by_ref());
    let value = <Wired<P>>::from_values(config, values);
    let write = Flow { valid: write.valid, record: Placed { tile, pixel, value }, ready: write.ready };
    let buffer = Buffer::<P> { name: "", config, run_pixels, memory_bits, base, reads, writes };
    buffer.order(&mut m, read.map(|PixelRun { tile, pixel, count }| Run { tile, pixel, count }), write);
    let data = reader.record.of(&mut m, config, reads);
    Out::<P>::new("data", "valid", "The pixels.").export(&mut m, config, data);
    m
}
