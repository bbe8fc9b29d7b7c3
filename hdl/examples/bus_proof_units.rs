//! `bus_proof_units DIR` writes the bus units that are proved (`formal/`) at small sizes: of each its Verilog `<proof>.v`, and the
//! sizes that its harness needs in `<proof>.vh`.

use pointcore_hdl::bus::{packet_in, packet_out, reader, registers, window, writer};
use pointcore_hdl::rtl::{Module, elaborate};
use pointcore_spec::bus::packets::FieldRange;
use pointcore_spec::bus::{Kind, Register, registers as maps};
use pointcore_spec::core_a::Field;
use pointcore_spec::{core_a, core_b};
use std::error::Error;
use std::path::Path;

/// Bits of a beat: the least that a field's container has.
const BEAT_BITS: u32 = 8;
/// Bits of a field besides `end`.
const FIELD_BITS: u32 = 2;

/// A unit to be proved.
struct Proof {
    name: &'static str,
    unit: Module,
    sizes: Vec<(&'static str, u32)>,
}

fn field(name: &str, width: u32) -> Field {
    (name.to_owned(), width)
}

/// A record of three beats: `first`, `second`, `third`, a beat each.
fn record() -> Vec<Field> {
    ["first", "second", "third"].map(|name| field(name, FIELD_BITS)).to_vec()
}

/// A record of one beat.
fn single() -> Vec<Field> {
    vec![field("first", FIELD_BITS)]
}

/// A record of two beats: `end`, and `second` in the second.
fn ending() -> Vec<Field> {
    vec![field("end", 1), field("second", FIELD_BITS)]
}

fn packet_ins() -> Vec<Proof> {
    let proof = |name, fields: &[Field], range| Proof {
        name,
        unit: packet_in::module(fields, BEAT_BITS, range),
        sizes: vec![("BEATS", fields.len() as u32), ("WIDTH", BEAT_BITS), ("FIELD", FIELD_BITS)],
    };
    vec![
        proof("bus_packet_in", &record(), Some(&FieldRange { name: "second", low: 1, high: 2 })),
        proof("bus_packet_in_single", &single(), None),
        proof("bus_packet_in_ending", &ending(), None),
    ]
}

fn packet_outs() -> Vec<Proof> {
    let proof = |name, fields: &[Field]| Proof {
        name,
        unit: packet_out::module(fields, BEAT_BITS),
        sizes: vec![("BEATS", fields.len() as u32), ("WIDTH", BEAT_BITS), ("FIELD", FIELD_BITS)],
    };
    vec![proof("bus_packet_out", &record()), proof("bus_packet_out_single", &single())]
}

/// Records that are asked for in bursts of several, and alone.
fn readers() -> Vec<Proof> {
    let proof = |name, fields: &[Field], beats, records| Proof {
        name,
        unit: reader::module(fields, BEAT_BITS, records),
        sizes: vec![("BEATS", beats), ("WIDTH", BEAT_BITS), ("FIELD", FIELD_BITS), ("RECORDS", records)],
    };
    // Two bytes; the record of three fields takes four.
    vec![proof("bus_reader", &ending(), 2, 3), proof("bus_reader_single", &record(), 4, 1)]
}

fn writers() -> Vec<Proof> {
    let proof = |name, fields: &[Field], beats| Proof {
        name,
        unit: writer::module(fields, BEAT_BITS),
        sizes: vec![("BEATS", beats), ("WIDTH", BEAT_BITS), ("FIELD", FIELD_BITS)],
    };
    vec![proof("bus_writer", &record(), 4), proof("bus_writer_single", &single(), 1)]
}

fn windows() -> Vec<Proof> {
    const INDEX_BITS: u32 = 2;
    vec![Proof { name: "bus_window", unit: window::module(INDEX_BITS), sizes: vec![("INDEX_BITS", INDEX_BITS)] }]
}

/// Core B's registers without events, core A's with two uniforms.
fn maps() -> Vec<Proof> {
    let proof = |name, map: Vec<Register>| Proof {
        name,
        unit: registers::module(&map, [1; 4]),
        sizes: vec![("COUNTERS", map.iter().filter(|register| is_counter(register)).count() as u32)],
    };
    let is_event = |register: &Register| register.name.starts_with("event_");
    let queries = maps::core_b(&core_b::Config::default()).into_iter().filter(|register| !is_event(register));
    let uniforms = maps::core_a(&core_a::Config::default()).into_iter().filter(|register| !is_event(register));
    let uniforms = uniforms.filter(|register| register.address < maps::UNIFORMS + 8);
    vec![proof("bus_registers", queries.collect()), proof("bus_registers_uniforms", uniforms.collect())]
}

fn is_counter(register: &Register) -> bool {
    matches!(register.kind, Kind::Errors | Kind::Run)
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("usage: bus_proof_units DIR")?;
    let folder = Path::new(&folder);
    std::fs::create_dir_all(folder)?;
    for Proof { name, unit, sizes } in
        [packet_ins(), packet_outs(), readers(), writers(), windows(), maps()].into_iter().flatten()
    {
        let design = elaborate(&unit)?;
        let sizes = sizes.iter().map(|(size, value)| format!("localparam {size} = {value};\n"));
        let header: String = std::iter::once(format!("`define UNIT {}\n", design.top())).chain(sizes).collect();
        std::fs::write(folder.join(format!("{name}.v")), design.verilog())?;
        std::fs::write(folder.join(format!("{name}.vh")), header)?;
    }
    Ok(())
}
