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
    /// taken meanwhile. `writes` is the unit that writes.
    pub fn order(&self, m: &mut Module, read: Flow<Run>, writes: Instance, write: Flow<Placed<Wired<P>>>) {
        let writer_idle = WriterPorts::<P>::ALL.idle.word_of(m, writes);
        self.read(m, read, writer_idle);
        let Placed { tile, pixel, value } = write.record;
        let address = self.address(m, "pixel_address", tile, pixel);
        let no_read = m.wire(&format!("{}no_read", self.name), !read.valid);
        let writes = (writes, WriterPorts::<P>::ALL.input);
        feed(m, self.config, (write.valid, write.ready), writes, no_read, Addressed { address, record: value });
    }

    /// Leads reads of pixels to memory, in cycles where they may be taken.
    pub fn read(&self, m: &mut Module, read: Flow<Run>, may_read: Expr) {
        let Run { tile, pixel, count } = read.record;
        let address = self.address(m, "run_address", tile, pixel);
        let reads = (self.reads, ReaderPorts::<P>::ALL.request);
        let request = ReadRequest { address, records: count };
        feed(m, &self.run_pixels, (read.valid, read.ready), reads, may_read, request);
    }

    /// Where a pixel lies.
    fn address(&self, m: &mut Module, what: &str, tile: Expr, pixel: Expr) -> Expr {
        let stride_bits = Layout::record::<P>(self.config).stride(self.memory_bits).ilog2();
        m.wire(&format!("{}{what}", self.name), place(self.base, cat([tile, pixel]), stride_bits))
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
    let buffer = Buffer::<P> { name: "", config, run_pixels, memory_bits, base, reads };
    buffer.order(&mut m, read.map(|PixelRun { tile, pixel, count }| Run { tile, pixel, count }), writes, write);
    let data = reader.record.of(&mut m, config, reads);
    Out::<P>::new("data", "valid", "The pixels.").export(&mut m, config, data);
    m
}
