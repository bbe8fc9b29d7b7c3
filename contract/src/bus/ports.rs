//! Ports of the bus units in order, `rst` first; every unit also has `clk`.

use super::axi::Bus;
use super::config::{ADDRESS_BITS, BORDER_BYTES, BURST_BEATS_MAX, TREE_WORD_BITS};
use super::layout::Layout;
use super::list::Ports;
use super::registers::{ERRORS, Kind, Register};
use crate::splat::config::index_bits;
use crate::{Field, Port, search, splat};

/// Whether packets of these fields say themselves which is a run's last.
#[must_use]
pub fn has_end(fields: &[Field]) -> bool {
    fields.iter().any(|field| field.name == "end")
}

/// Ports of `bus_packet_in`.
#[must_use]
pub fn packet_in(fields: &[Field], stream_bits: u32) -> Vec<Port> {
    let ports = Ports::new().input("opens", 1);
    let ports = if has_end(fields) { ports } else { ports.input("last", 1) };
    let ports = ports.bus(Bus::StreamIn(stream_bits), "s_axis").stream_out("out", fields);
    ports.output("taken", 1).output("refused", 1).list()
}

/// Ports of `bus_packet_out`.
#[must_use]
pub fn packet_out(fields: &[Field], stream_bits: u32) -> Vec<Port> {
    let ports = Ports::new().stream_in("in", fields);
    ports.bus(Bus::StreamOut(stream_bits), "m_axis").output("sent", 1).output("idle", 1).list()
}

/// Ports of `bus_reader`; requests are for up to `records_max` records.
#[must_use]
pub fn reader(fields: &[Field], memory_bits: u32, records_max: u32) -> Vec<Port> {
    let request = [Field::new("address", ADDRESS_BITS), Field::new("records", index_bits(records_max + 1))];
    let ports = Ports::new().stream_in("request", &request);
    ports
        .bus(Bus::ReadMaster(memory_bits), "m_axi")
        .stream_out("record", fields)
        .output("error", 1)
        .output("misplaced", 1)
        .list()
}

/// Ports of `bus_writer`.
#[must_use]
pub fn writer(fields: &[Field], memory_bits: u32) -> Vec<Port> {
    let mut record = vec![Field::new("address", ADDRESS_BITS)];
    record.extend_from_slice(fields);
    let ports = Ports::new().stream_in("in", &record);
    ports.bus(Bus::WriteMaster(memory_bits), "m_axi").output("error", 1).output("idle", 1).list()
}

/// Ports of `bus_window` of `2^index_bits` words.
#[must_use]
pub fn window(index_bits: u32) -> Vec<Port> {
    let write = [Field::new("index", index_bits), Field::new("data", TREE_WORD_BITS)];
    Ports::new()
        .input("locked", 1)
        .bus(Bus::Slave(TREE_WORD_BITS), "s_axi")
        .pulse_out("write", &write)
        .output("refused_burst", 1)
        .output("refused_busy", 1)
        .output("occupied", 1)
        .list()
}

/// Where errors come from that are not of the registers themselves: how many sources count into each of `busy_errors`,
/// `burst_errors`, `packet_errors` and `memory_errors`.
pub type ErrorSources = [u32; ERRORS.len() - 1];

/// The names of the inputs for errors from elsewhere, without that of `access_errors`.
pub const ERROR_INPUTS: [&str; ERRORS.len() - 1] = ["busy_error", "burst_error", "packet_error", "memory_error"];

/// The settings of a map: what the registers put out.
#[must_use]
pub fn settings(map: &[Register]) -> Vec<Field> {
    let setting = |register: &&Register| matches!(register.kind, Kind::Setting { .. } | Kind::Queries);
    map.iter().filter(setting).map(|register| Field::new(&register.name, register.width)).collect()
}

/// The events that a map counts, beside packets.
#[must_use]
pub fn events(map: &[Register]) -> Vec<&str> {
    let events = map.iter().filter(|register| register.name.starts_with("event_"));
    events.map(|register| register.name.as_str()).collect()
}

/// Bits that number a map's uniforms, and bits of their values; none where there are none.
#[must_use]
pub fn uniforms(map: &[Register]) -> Option<(u32, u32)> {
    let uniforms: Vec<_> = map.iter().filter(|register| register.kind == Kind::Uniform).collect();
    let width = uniforms.first()?.width;
    Some((index_bits(uniforms.len() as u32), width))
}

/// Ports of `bus_registers`.
#[must_use]
pub fn registers(map: &[Register], sources: ErrorSources) -> Vec<Port> {
    let ports = Ports::new().bus(Bus::Registers, "s_axil").input("finished", 1).input("occupied", 1);
    let errors = ERROR_INPUTS.iter().zip(sources).filter(|(_, sources)| *sources > 0);
    let ports = errors.fold(ports, |ports, (name, sources)| ports.input(*name, sources));
    let ports = ports.input("packet_taken", 1).input("packet_sent", 1);
    let ports = events(map).into_iter().fold(ports, |ports, name| ports.input(name, 1));
    let ports = ports.output("busy", 1).output("start", 1).output("core_reset", 1).output("irq", 1);
    let ports = ports.outputs("", &settings(map));
    match uniforms(map) {
        None => ports.list(),
        Some((address, data)) => {
            ports.pulse_out("uniform", &[Field::new("address", address), Field::new("data", data)]).list()
        }
    }
}

/// Ports of `splat_axi`.
#[must_use]
pub fn splat(config: &splat::Config) -> Vec<Port> {
    let bus = &config.bus;
    let ports = Ports::new().bus(Bus::Registers, "s_axil").output("irq", 1);
    let ports = ports.bus(Bus::StreamIn(bus.stream_bits), "s_axis_splat");
    let ports = ports.bus(Bus::StreamOut(bus.stream_bits), "m_axis_fragment");
    let ports = ports.bus(Bus::ReadMaster(bus.memory_bits), "m_axi");
    ports.bus(Bus::WriteMaster(bus.memory_bits), "m_axi").list()
}

/// Ports of `search_axi`.
#[must_use]
pub fn search(config: &search::Config) -> Vec<Port> {
    let bus = &config.bus;
    let ports = Ports::new().bus(Bus::Registers, "s_axil").output("irq", 1);
    let ports = ports.bus(Bus::StreamIn(bus.stream_bits), "s_axis_query");
    let ports = ports.bus(Bus::StreamOut(bus.stream_bits), "m_axis_result");
    let ports = ports.bus(Bus::ReadMaster(bus.memory_bits), "m_axi");
    match config.tree_cache {
        0 => ports.bus(Bus::Slave(TREE_WORD_BITS), "s_axi").list(),
        _ => ports.bus(Bus::ReadMaster(bus.memory_bits), "m_axi_tree").list(),
    }
}

/// Bits of the index of a core's window: nodes in its lower half, leaves in its upper one.
#[must_use]
pub const fn window_index_bits(config: &search::Config) -> u32 {
    config.node_bits()
}

/// The most records that the search core asks of its memory at a time.
#[must_use]
pub const fn beats_max(config: &search::Config) -> u32 {
    config.bucket.div_ceil(config.lanes)
}

/// Records between two places where a burst must end.
#[must_use]
pub fn chunk_records(fields: &[Field], memory_bits: u32) -> u32 {
    let beat = memory_bits / 8;
    BORDER_BYTES.min(BURST_BEATS_MAX * beat) / Layout::of(fields).stride(memory_bits)
}
