//! The reconstruction buffer in memory (`docs/interfaces.md`): the renderer's reads of tiles and writes of pixels, in their order; proved in
//! `formal/splat_buffer.sv`.

use pointcore_contract::bus::{Layout, ports};
use pointcore_contract::splat::Field;

use super::wiring::{export, feed, place, request};
use crate::bus::{ADDRESS_BITS, reader, writer};
use crate::units::records::{Record, stream_in};
use rtl::{Expr, Instance, Module, Stream, address_width, cat, lit};

/// What lies in memory, and how memory is reached.
pub(super) struct Buffer<'a> {
    /// A pixel's fields.
    pub pixel: &'a [Field],
    /// Pixels of a tile, a power of two.
    pub tile_pixels: u32,
    /// Bits of a beat.
    pub memory_bits: u32,
    /// Where the first tile lies.
    pub base: Expr,
    /// The unit that reads.
    pub reads: Instance,
    /// The unit that writes.
    pub writes: Instance,
}

impl Buffer<'_> {
    /// Leads reads and writes to memory. A read sees every write before it: it waits until all are answered, and no other is taken
    /// meanwhile.
    pub fn order(&self, m: &mut Module, read: &Stream, write: &Stream) {
        let stride_bits = Layout::of(self.pixel).stride(self.memory_bits).ilog2();
        let writer_idle = m.out(self.writes, "idle");
        let tile_bits = stride_bits + self.tile_pixels.ilog2();
        let address = m.wire("tile_address", place(self.base, read.field("tile"), tile_bits));
        let count = lit(self.tile_pixels.ilog2() + 1, self.tile_pixels.into());
        feed(m, read, (self.reads, "request"), writer_idle, &request(address, count));
        let index = cat([write.field("tile"), write.field("pixel")]);
        let address = m.wire("pixel_address", place(self.base, index, stride_bits));
        let mut fields = vec![("address".to_owned(), ADDRESS_BITS)];
        fields.extend_from_slice(self.pixel);
        let written = Record::new(&fields, |name| if name == "address" { address } else { write.field(name) });
        let no_read = m.wire("no_read", !read.valid);
        feed(m, write, (self.writes, "in"), no_read, &written);
    }
}

/// The buffer without its core: few tiles, so many bursts and writes under way at most that a proof can go through.
#[must_use]
pub fn alone(pixel: &[Field], memory_bits: u32, tile_bits: u32, tile_pixels: u32, limit: u32) -> Module {
    let mut m = Module::new("splat_buffer", "The renderer's reconstruction buffer in memory.");
    let reads = m.instance("reads", reader::limited(pixel, memory_bits, tile_pixels, limit));
    let writes = m.instance("writes", writer::limited(pixel, memory_bits, limit));
    export(&mut m, reads, &ports::reader(pixel, memory_bits, tile_pixels), "m_axi", "m_axi");
    export(&mut m, writes, &ports::writer(pixel, memory_bits), "m_axi", "m_axi");
    let base = m.input("base", ADDRESS_BITS);
    let read = m.stream_in("read", &[("tile", tile_bits)]);
    let place = [("tile".to_owned(), tile_bits), ("pixel".to_owned(), address_width(tile_pixels) as u32)];
    let write = stream_in(&mut m, "write", &[place.as_slice(), pixel].concat());
    let buffer = Buffer { pixel, tile_pixels, memory_bits, base, reads, writes };
    buffer.order(&mut m, &read, &write);
    let data = m.stream_from(reads, "record");
    m.stream_export("data", &data);
    m
}
