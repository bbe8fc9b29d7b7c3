//! Ports of the bus units in order, `rst` first; every unit also has `clk`.

use super::config::{
    ADDRESS_BITS, BORDER_BYTES, BURST_BEATS_MAX, ID_BITS, REGISTER_ADDRESS_BITS, REGISTER_BITS, TREE_WORD_BITS,
};
use super::layout::Layout;
use super::registers::{ERRORS, Kind, Register};
use crate::Port;
use crate::search;
use crate::splat::config::index_bits;
use crate::splat::ports::Ports;
use crate::splat::{self, Field};

const LENGTH_BITS: u32 = index_bits(BURST_BEATS_MAX);
const SIZE_BITS: u32 = 3;
const BURST_BITS: u32 = 2;
const RESPONSE_BITS: u32 = 2;
const REGISTER_BYTES: u32 = REGISTER_BITS / 8;

fn field(name: &str, width: u32) -> Field {
    (name.to_owned(), width)
}

/// Whether packets of these fields say themselves which is a run's last.
#[must_use]
pub fn has_end(fields: &[Field]) -> bool {
    fields.iter().any(|(name, _)| name == "end")
}

/// Ports of `bus_packet_in`.
#[must_use]
pub fn packet_in(fields: &[Field], stream_bits: u32) -> Vec<Port> {
    let ports = Ports::new().input("opens", 1);
    let ports = if has_end(fields) { ports } else { ports.input("last", 1) };
    let ports = axis_in(ports, "s_axis", stream_bits).stream_out("out", fields);
    ports.output("taken", 1).output("refused", 1).list()
}

/// Ports of `bus_packet_out`.
#[must_use]
pub fn packet_out(fields: &[Field], stream_bits: u32) -> Vec<Port> {
    let ports = Ports::new().stream_in("in", fields);
    axis_out(ports, "m_axis", stream_bits).output("sent", 1).output("idle", 1).list()
}

/// Ports of `bus_reader`; requests are for up to `records_max` records.
#[must_use]
pub fn reader(fields: &[Field], memory_bits: u32, records_max: u32) -> Vec<Port> {
    let request = [field("address", ADDRESS_BITS), field("records", index_bits(records_max + 1))];
    let ports = Ports::new().stream_in("request", &request);
    axi_read_master(ports, "m_axi", memory_bits)
        .stream_out("record", fields)
        .output("error", 1)
        .output("misplaced", 1)
        .list()
}

/// Ports of `bus_writer`.
#[must_use]
pub fn writer(fields: &[Field], memory_bits: u32) -> Vec<Port> {
    let mut record = vec![field("address", ADDRESS_BITS)];
    record.extend_from_slice(fields);
    let ports = Ports::new().stream_in("in", &record);
    axi_write_master(ports, "m_axi", memory_bits).output("error", 1).output("idle", 1).list()
}

/// Ports of `bus_window` of `2^index_bits` words.
#[must_use]
pub fn window(index_bits: u32) -> Vec<Port> {
    let write = [field("index", index_bits), field("data", TREE_WORD_BITS)];
    axi_slave(Ports::new().input("locked", 1), "s_axi", TREE_WORD_BITS)
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
    map.iter().filter(setting).map(|register| field(&register.name, register.width)).collect()
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
    let ports = axil_slave(Ports::new(), "s_axil").input("finished", 1).input("occupied", 1);
    let errors = ERROR_INPUTS.iter().zip(sources).filter(|(_, sources)| *sources > 0);
    let ports = errors.fold(ports, |ports, (name, sources)| ports.input(*name, sources));
    let ports = ports.input("packet_taken", 1).input("packet_sent", 1);
    let ports = events(map).into_iter().fold(ports, |ports, name| ports.input(name, 1));
    let ports = ports.output("busy", 1).output("start", 1).output("core_reset", 1).output("irq", 1);
    let ports = ports.outputs("", &settings(map));
    match uniforms(map) {
        None => ports.list(),
        Some((address, data)) => ports.pulse_out("uniform", &[field("address", address), field("data", data)]).list(),
    }
}

/// Ports of `splat_axi`.
#[must_use]
pub fn splat(config: &splat::Config) -> Vec<Port> {
    let bus = &config.bus;
    let ports = axil_slave(Ports::new(), "s_axil").output("irq", 1);
    let ports = axis_out(axis_in(ports, "s_axis_splat", bus.stream_bits), "m_axis_fragment", bus.stream_bits);
    axi_write_master(axi_read_master(ports, "m_axi", bus.memory_bits), "m_axi", bus.memory_bits).list()
}

/// Ports of `search_axi`.
#[must_use]
pub fn search(config: &search::Config) -> Vec<Port> {
    let bus = &config.bus;
    let ports = axil_slave(Ports::new(), "s_axil").output("irq", 1);
    let ports = axis_out(axis_in(ports, "s_axis_query", bus.stream_bits), "m_axis_result", bus.stream_bits);
    let ports = axi_read_master(ports, "m_axi", bus.memory_bits);
    match config.tree_cache {
        0 => axi_slave(ports, "s_axi", TREE_WORD_BITS).list(),
        _ => axi_read_master(ports, "m_axi_tree", bus.memory_bits).list(),
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

/// An AXI4-Stream of packets into the unit.
fn axis_in(ports: Ports, prefix: &str, bits: u32) -> Ports {
    let name = |name: &str| format!("{prefix}_{name}");
    ports.input(name("tvalid"), 1).output(name("tready"), 1).input(name("tdata"), bits).input(name("tlast"), 1)
}

/// An AXI4-Stream of packets out of the unit.
fn axis_out(ports: Ports, prefix: &str, bits: u32) -> Ports {
    let name = |name: &str| format!("{prefix}_{name}");
    ports.output(name("tvalid"), 1).input(name("tready"), 1).output(name("tdata"), bits).output(name("tlast"), 1)
}

fn axil_slave(ports: Ports, prefix: &str) -> Ports {
    let name = |name: &str| format!("{prefix}_{name}");
    let ports = ports.input(name("awvalid"), 1).output(name("awready"), 1).input(name("awaddr"), REGISTER_ADDRESS_BITS);
    let ports = ports.input(name("wvalid"), 1).output(name("wready"), 1).input(name("wdata"), REGISTER_BITS);
    let ports = ports.input(name("wstrb"), REGISTER_BYTES);
    let ports = ports.output(name("bvalid"), 1).input(name("bready"), 1).output(name("bresp"), RESPONSE_BITS);
    let ports = ports.input(name("arvalid"), 1).output(name("arready"), 1).input(name("araddr"), REGISTER_ADDRESS_BITS);
    let ports = ports.output(name("rvalid"), 1).input(name("rready"), 1).output(name("rdata"), REGISTER_BITS);
    ports.output(name("rresp"), RESPONSE_BITS)
}

/// The fields of an address channel, but for its identifier.
const ADDRESS_FIELDS: [(&str, u32); 4] =
    [("addr", ADDRESS_BITS), ("len", LENGTH_BITS), ("size", SIZE_BITS), ("burst", BURST_BITS)];

fn axi_read_master(ports: Ports, prefix: &str, bits: u32) -> Ports {
    let name = |name: &str| format!("{prefix}_{name}");
    let ports = ports.output(name("arvalid"), 1).input(name("arready"), 1).output(name("arid"), ID_BITS);
    let address = |ports: Ports, (field, width): (&str, u32)| ports.output(name(&format!("ar{field}")), width);
    let ports = ADDRESS_FIELDS.into_iter().fold(ports, address);
    let ports = ports.input(name("rvalid"), 1).output(name("rready"), 1).input(name("rid"), ID_BITS);
    ports.input(name("rdata"), bits).input(name("rresp"), RESPONSE_BITS).input(name("rlast"), 1)
}

fn axi_write_master(ports: Ports, prefix: &str, bits: u32) -> Ports {
    let name = |name: &str| format!("{prefix}_{name}");
    let ports = ports.output(name("awvalid"), 1).input(name("awready"), 1).output(name("awid"), ID_BITS);
    let address = |ports: Ports, (field, width): (&str, u32)| ports.output(name(&format!("aw{field}")), width);
    let ports = ADDRESS_FIELDS.into_iter().fold(ports, address);
    let ports = ports.output(name("wvalid"), 1).input(name("wready"), 1).output(name("wdata"), bits);
    let ports = ports.output(name("wstrb"), bits / 8).output(name("wlast"), 1);
    let ports = ports.input(name("bvalid"), 1).output(name("bready"), 1).input(name("bid"), ID_BITS);
    ports.input(name("bresp"), RESPONSE_BITS)
}

fn axi_slave(ports: Ports, prefix: &str, bits: u32) -> Ports {
    let name = |name: &str| format!("{prefix}_{name}");
    let ports = ports.input(name("awvalid"), 1).output(name("awready"), 1).input(name("awid"), ID_BITS);
    let write = |ports: Ports, (field, width): (&str, u32)| ports.input(name(&format!("aw{field}")), width);
    let ports = ADDRESS_FIELDS.into_iter().fold(ports, write);
    let ports = ports.input(name("wvalid"), 1).output(name("wready"), 1).input(name("wdata"), bits);
    let ports = ports.input(name("wstrb"), bits / 8).input(name("wlast"), 1);
    let ports = ports.output(name("bvalid"), 1).input(name("bready"), 1).output(name("bid"), ID_BITS);
    let ports = ports.output(name("bresp"), RESPONSE_BITS);
    let ports = ports.input(name("arvalid"), 1).output(name("arready"), 1).input(name("arid"), ID_BITS);
    let read = |ports: Ports, (field, width): (&str, u32)| ports.input(name(&format!("ar{field}")), width);
    let ports = ADDRESS_FIELDS.into_iter().fold(ports, read);
    let ports = ports.output(name("rvalid"), 1).input(name("rready"), 1).output(name("rid"), ID_BITS);
    ports.output(name("rdata"), bits).output(name("rresp"), RESPONSE_BITS).output(name("rlast"), 1)
}
