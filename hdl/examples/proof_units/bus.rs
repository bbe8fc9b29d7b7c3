//! The units on the bus, for the record that `formal/record.vh` lays out.

use super::Proof;
use pointcore_contract::bus::config::WRITES_MAX;
use pointcore_contract::bus::packets::FieldRange;
use pointcore_contract::bus::ports;
use pointcore_contract::bus::registers::{self as map, Kind, Register};
use pointcore_contract::splat::config::TILE_PIXELS;
use pointcore_contract::{Field, search, splat};
use pointcore_hdl::bus::cores::buffer;
use pointcore_hdl::bus::{packet_in, packet_out, reader, registers, window, writer};

/// Bytes of the record in C, and from one to the next in memory.
const BYTES: u32 = 12;
const STRIDE: u32 = 16;

/// Fields whose containers leave gaps between them; the third, of one bit, is called as told.
fn record(third: &str) -> Vec<Field> {
    [("a", 3), ("b", 20), (third, 1), ("d", 9)].map(|(name, width)| Field::new(name, width)).to_vec()
}

/// Packets of several beats and of one, full and padded; with and without a field `end` and a range.
fn packets() -> Vec<Proof> {
    let sizes = |bits: u32| [("BITS", bits), ("BEATS", (8 * BYTES).div_ceil(bits))];
    let input = |name, bits, third, (low, high)| {
        let range = FieldRange { name: "a", low, high };
        let sizes = [sizes(bits), [("LOW", low), ("HIGH", high)]].concat();
        Proof::new(name, packet_in::module(&record(third), bits, (high < 7).then_some(&range)), &sizes)
    };
    let output = |name, bits| Proof::new(name, packet_out::module(&record("c"), bits), &sizes(bits));
    vec![
        Proof { flags: vec!["ENDS"], ..input("bus_packet_in_end", 32, "end", (0, 7)) },
        input("bus_packet_in_range", 64, "c", (1, 5)),
        input("bus_packet_in_beat", 128, "c", (0, 7)),
        output("bus_packet_out", 32),
        output("bus_packet_out_beat", 128),
    ]
}

/// Bursts that may be under way.
const LIMIT: u32 = 3;

/// Records of several beats and of one, requests for several records and for one.
fn memory() -> Vec<Proof> {
    let sizes = |bits: u32| [("BITS", bits), ("BEATS", 8 * STRIDE / bits), ("LIMIT", LIMIT)];
    let reads = |name, bits, records_max: u32| {
        let records = [("RECORDS_MAX", records_max), ("RECORDS_BITS", u32::BITS - records_max.leading_zeros())];
        let unit = reader::limited(&record("c"), bits, records_max, LIMIT);
        Proof::new(name, unit, &[sizes(bits).as_slice(), &records].concat())
    };
    let writes = |name, bits| Proof::new(name, writer::limited(&record("c"), bits, LIMIT), &sizes(bits));
    vec![
        reads("bus_reader", 64, 3),
        reads("bus_reader_beat", 128, 3),
        reads("bus_reader_single", 64, 1),
        writes("bus_writer", 64),
        writes("bus_writer_beat", 128),
    ]
}

/// The renderer's buffer: with as many pixels in a tile, bursts and writes under way as in the top, a tile read in one burst and in two;
/// and small, for what depends on addresses and for what waits.
fn buffers() -> [Proof; 4] {
    const TILE_BITS: u32 = 2;
    let buffer = |name, bits: u32, tile_pixels: u32, limit: u32| {
        let sizes = [
            ("BITS", bits),
            ("BEATS", 8 * STRIDE / bits),
            ("LIMIT", limit),
            ("TILE_BITS", TILE_BITS),
            ("TILE_PIXELS", tile_pixels),
            ("PIXEL_BITS", tile_pixels.ilog2()),
        ];
        Proof::new(name, buffer::alone(&record("c"), bits, TILE_BITS, tile_pixels, limit), &sizes)
    };
    let small = |name, flag| Proof { flags: vec![flag], ..buffer(name, 128, 2, 2) };
    [
        buffer("splat_buffer", 64, TILE_PIXELS, WRITES_MAX),
        buffer("splat_buffer_split", 32, 2 * TILE_PIXELS, WRITES_MAX),
        small("splat_buffer_addresses", "ADDRESSES"),
        small("splat_buffer_waits", "WAITS"),
    ]
}

/// Bits of uniforms and of a setting in the map below.
const VALUE_BITS: u32 = 5;
const UNIFORMS: u32 = 3;

/// A map with a register of every kind at its place: what both cores have, the search core's settings, and some of the renderer's uniforms.
fn registers() -> Proof {
    let splat = map::splat(&splat::Config::default());
    let search = map::search(&search::Config { neighbor_cache: 2, ..search::Config::default() });
    let id = search[0].reset();
    let renamed = |register: Register| match register.name.as_str() {
        _ if register.address < map::EVENTS => Some(register),
        _ if register.address == map::EVENTS => Some(Register { name: "event_seen".to_owned(), ..register }),
        "points_base" => Some(Register { name: "base".to_owned(), ..register }),
        "queries" => Some(register),
        "cache_far_scale" => Some(Register { name: "scale".to_owned(), width: VALUE_BITS, ..register }),
        _ => None,
    };
    let uniforms = splat.into_iter().filter(|register| register.kind == Kind::Uniform).take(UNIFORMS as usize);
    let uniforms = uniforms.map(|register| Register { width: VALUE_BITS, ..register });
    let every_kind: Vec<_> = search.into_iter().filter_map(renamed).chain(uniforms).collect();
    let (uniform_bits, _) = ports::uniforms(&every_kind).expect("the map has uniforms");
    let sizes =
        [("IDENTITY", id), ("VALUE_BITS", VALUE_BITS), ("UNIFORM_COUNT", UNIFORMS), ("UNIFORM_BITS", uniform_bits)];
    // Two sources for `burst_errors`, one for each of the others.
    Proof::new("bus_registers", registers::module(&every_kind, [1, 2, 1, 1]), &sizes)
}

pub(super) fn proofs() -> impl Iterator<Item = Proof> {
    const INDEX_BITS: u32 = 2;
    let window = Proof::new("bus_window", window::module(INDEX_BITS), &[("INDEX_BITS", INDEX_BITS)]);
    packets().into_iter().chain(memory()).chain(buffers()).chain([window, registers()])
}
