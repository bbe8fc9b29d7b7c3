//! The units on the bus, for the record that `formal/record.vh` lays out.

use super::Proof;
use pointcore_contract::bus::config::{REGISTER_BITS, WRITES_MAX};
use pointcore_contract::bus::packets::{FieldRange, Packet};
use pointcore_contract::bus::registers::{
    self as map, ErrorSources, MapEntry, Register, RegisterKind, RegisterMap, SearchRegisters, SplatRegisters,
    UniformBits, When,
};
use pointcore_contract::bus::units::window_bits;
use pointcore_contract::splat::config::{RUN_PIXELS_MAX, TILE_PIXELS};
use pointcore_contract::{fields, places, record, search, splat};
use pointcore_hdl::bus::cores::buffer;
use pointcore_hdl::bus::{packet_in, packet_out, reader, registers, window, writer};

/// Bytes of the record in C, and from one to the next in memory.
const BYTES: u32 = 12;
const STRIDE: u32 = 16;

/// Fields whose containers leave gaps between them. Where it is a packet, `a` has a range.
#[record(range: Option<(u32, u32)>)]
struct Gaps {
    /// Few bits.
    #[bits(3)]
    a: u8,
    /// Many bits.
    #[bits(20)]
    b: u32,
    /// One bit.
    c: bool,
    /// More than a byte.
    #[bits(9)]
    d: u16,
}

impl Packet for Gaps {
    fn ranges(range: &Option<(u32, u32)>) -> Vec<FieldRange> {
        let field = places::<Self>(range).a;
        field.zip(*range).map(|(field, (low, high))| FieldRange { field, low, high }).into_iter().collect()
    }
}

/// The same, with a flag that closes a run.
#[record(config: ())]
struct Closing {
    /// Few bits.
    #[bits(3)]
    a: u8,
    /// Many bits.
    #[bits(20)]
    b: u32,
    /// Closes a run.
    end: bool,
    /// More than a byte.
    #[bits(9)]
    d: u16,
}

impl Packet for Closing {
    fn end(config: &()) -> Option<usize> {
        places::<Self>(config).end
    }
}

/// Packets of several beats and of one, full and padded; with and without a field `end` and a range.
fn packets() -> Vec<Proof> {
    let sizes = |bits: u32| [("BITS", bits), ("BEATS", (8 * BYTES).div_ceil(bits))];
    let input_sizes = |bits, (low, high)| [sizes(bits), [("LOW", low), ("HIGH", high)]].concat();
    let input = |name, bits, range: Option<(u32, u32)>| {
        let sizes = input_sizes(bits, range.unwrap_or((0, 7)));
        Proof::new(name, packet_in::module::<Gaps>(&range, bits), &sizes)
    };
    let end = Proof::new("bus_packet_in_end", packet_in::module::<Closing>(&(), 32), &input_sizes(32, (0, 7)));
    let output = |name, bits| Proof::new(name, packet_out::module::<Gaps>(&None, bits), &sizes(bits));
    vec![
        Proof { flags: vec!["ENDS"], ..end },
        input("bus_packet_in_range", 64, Some((1, 5))),
        input("bus_packet_in_beat", 128, None),
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
        let unit = reader::limited::<Gaps>(&None, bits, records_max, LIMIT);
        Proof::new(name, unit, &[sizes(bits).as_slice(), &records].concat())
    };
    let writes = |name, bits| Proof::new(name, writer::limited::<Gaps>(&None, bits, LIMIT), &sizes(bits));
    vec![
        reads("bus_reader", 64, 3),
        reads("bus_reader_beat", 128, 3),
        reads("bus_reader_single", 64, 1),
        writes("bus_writer", 64),
        writes("bus_writer_beat", 128),
    ]
}

/// The renderer's buffer: with as many pixels in a tile and in a read, bursts and writes under way as in the top; with reads of two bursts;
/// and small, for what depends on addresses and for what waits.
fn buffers() -> [Proof; 4] {
    const TILE_BITS: u32 = 2;
    let buffer = |name, bits: u32, [tile_pixels, run_pixels]: [u32; 2], limit: u32| {
        let sizes = [
            ("BITS", bits),
            ("BEATS", 8 * STRIDE / bits),
            ("LIMIT", limit),
            ("TILE_BITS", TILE_BITS),
            ("TILE_PIXELS", tile_pixels),
            ("PIXEL_BITS", tile_pixels.ilog2()),
            ("RUN_PIXELS", run_pixels),
            ("RUN_BITS", u32::BITS - run_pixels.leading_zeros()),
        ];
        Proof::new(name, buffer::alone::<Gaps>(&None, bits, TILE_BITS, [tile_pixels, run_pixels], limit), &sizes)
    };
    let small = |name, flag| Proof { flags: vec![flag], ..buffer(name, 128, [4, 2], 2) };
    [
        buffer("splat_buffer", 64, [TILE_PIXELS, RUN_PIXELS_MAX], WRITES_MAX),
        buffer("splat_buffer_split", 32, [2 * TILE_PIXELS; 2], WRITES_MAX),
        small("splat_buffer_addresses", "ADDRESSES"),
        small("splat_buffer_waits", "WAITS"),
    ]
}

/// Bits of uniforms and of a setting in the map below.
const VALUE_BITS: u32 = 5;
const UNIFORMS: u32 = 3;

/// A map with a register of every kind at its place: what both cores have, the search core's settings, and some uniforms of the renderer's.
struct EveryKind;

/// Its settings: a base, the number of queries, and a number.
#[record(config: ())]
struct Settings {
    /// Address of something.
    #[bits(REGISTER_BITS)]
    base: u32,
    /// Queries of the next run.
    #[bits(REGISTER_BITS)]
    queries: u32,
    /// Some number.
    #[bits(VALUE_BITS)]
    scale: u8,
}

/// Its events.
#[record(config: ())]
struct Events {
    /// Something is seen.
    event_seen: bool,
}

impl RegisterMap for EveryKind {
    type Config = ();
    type Settings = Settings;
    type Events = Events;

    const STARTS: When = When::Ahead;

    fn registers(config: &()) -> Vec<Register> {
        let search = SearchRegisters::registers(&search::Config::default());
        let entries =
            Settings { base: MapEntry::base(0), queries: MapEntry::queries(0x8), scale: MapEntry::value(0x10) };
        let uniforms = SplatRegisters::registers(&splat::Config::default());
        let uniforms =
            uniforms.into_iter().filter(|register| register.kind == RegisterKind::Uniform).take(UNIFORMS as usize);
        let uniforms = uniforms.map(|register| Register { width: VALUE_BITS, ..register });
        let common = map::common(search[0].reset(), Self::STARTS, &fields::<Events>(config));
        common.into_iter().chain(map::settings::<Settings>(config, entries)).chain(uniforms).collect()
    }
}

fn registers() -> Proof {
    let every_kind = EveryKind::registers(&());
    let uniforms = UniformBits::of(&every_kind).expect("the map has uniforms");
    let sizes = [
        ("IDENTITY", every_kind[0].reset()),
        ("VALUE_BITS", VALUE_BITS),
        ("UNIFORM_COUNT", UNIFORMS),
        ("UNIFORM_BITS", uniforms.address),
    ];
    // Two sources for `burst_errors`, one for each of the others.
    let sources = ErrorSources { busy: 1, burst: 2, packet: 1, memory: 1 };
    Proof::new("bus_registers", registers::module::<EveryKind>(&(), sources), &sizes)
}

pub(super) fn proofs() -> impl Iterator<Item = Proof> {
    const INDEX_BITS: u32 = 2;
    let sizes = [("INDEX_BITS", INDEX_BITS), ("ADDRESS_BITS", window_bits(INDEX_BITS).address)];
    let window = Proof::new("bus_window", window::module(INDEX_BITS), &sizes);
    packets().into_iter().chain(memory()).chain(buffers()).chain([window, registers()])
}
