//! The reconstruction buffer in memory (`docs/interfaces.md`): the renderer's reads of tiles and writes of pixels, in their order; proved in
//! `formal/splat_buffer.sv`.

use pointcore_contract::Field;
use pointcore_contract::bus::{Bus, Layout};

use super::wiring::{export, feed, place};
use crate::bus::reader::{self, Request};
use crate::bus::{ADDRESS_BITS, layout, writer};
use crate::units::wires::Bundle;
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
        let request = Request { address, records: count }.named(&self.tile_pixels);
        feed(m, (read.valid, read.ready), (self.reads, "request"), writer_idle, request);
        let index = cat([write.field("tile"), write.field("pixel")]);
        let address = m.wire("pixel_address", place(self.base, index, stride_bits));
        // Tile and pixel come before what the pixel holds.
        let values = write.fields[2..].iter().cloned();
        let written = std::iter::once(("address".to_owned(), address)).chain(values);
        let no_read = m.wire("no_read", !read.valid);
        feed(m, (write.valid, write.ready), (self.writes, "in"), no_read, written);
    }
}

/// The buffer without its core: few tiles, so many bursts and writes under way at most that a proof can go through.
#[must_use]
pub fn alone(pixel: &[Field], memory_bits: u32, tile_bits: u32, tile_pixels: u32, limit: u32) -> Module {
    let mut m = Module::new("splat_buffer", "The renderer's reconstruction buffer in memory.");
    let reads = m.instance("reads", reader::limited(pixel, memory_bits, tile_pixels, limit));
    let writes = m.instance("writes", writer::limited(pixel, memory_bits, limit));
    export(&mut m, reads, Bus::ReadMaster(memory_bits), "m_axi", "m_axi");
    export(&mut m, writes, Bus::WriteMaster(memory_bits), "m_axi", "m_axi");
    let base = m.input("base", ADDRESS_BITS);
    let read = m.stream_in("read", &[("tile", tile_bits)]);
    let place = [Field::new("tile", tile_bits), Field::new("pixel", address_width(tile_pixels))];
    let write = m.stream_in("write", &layout(&[place.as_slice(), pixel].concat()));
    let buffer = Buffer { pixel, tile_pixels, memory_bits, base, reads, writes };
    buffer.order(&mut m, &read, &write);
    let data = m.stream_from(reads, "record");
    m.stream_export("data", &data);
    m
}
