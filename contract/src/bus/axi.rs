//! The AMBA buses at the ports of units and tops.

use super::config::{ADDRESS_BITS, BURST_BEATS_MAX, ID_BITS, REGISTER_ADDRESS_BITS, REGISTER_BITS};
use super::list::Ports;
use crate::Port;
use crate::splat::config::index_bits;

const LENGTH_BITS: u32 = index_bits(BURST_BEATS_MAX);
const SIZE_BITS: u32 = 3;
const BURST_BITS: u32 = 2;
const RESPONSE_BITS: u32 = 2;
const REGISTER_BYTES: u32 = REGISTER_BITS / 8;

/// One side of a bus, with the bits of a beat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bus {
    /// AXI4-Lite to the registers.
    Registers,
    /// An AXI4-Stream of packets into the unit.
    StreamIn(u32),
    /// An AXI4-Stream of packets out of the unit.
    StreamOut(u32),
    /// AXI4, reading.
    ReadMaster(u32),
    /// AXI4, writing.
    WriteMaster(u32),
    /// AXI4, written and read by others.
    Slave(u32),
}

impl Bus {
    /// The ports in order, called `<prefix>_…`.
    #[must_use]
    pub fn ports(self, prefix: &str) -> Vec<Port> {
        let ports = Ports::default();
        match self {
            Self::Registers => lite_slave(ports, prefix),
            Self::StreamIn(bits) => stream_in(ports, prefix, bits),
            Self::StreamOut(bits) => stream_out(ports, prefix, bits),
            Self::ReadMaster(bits) => read_master(ports, prefix, bits),
            Self::WriteMaster(bits) => write_master(ports, prefix, bits),
            Self::Slave(bits) => slave(ports, prefix, bits),
        }
        .list()
    }
}

fn stream_in(ports: Ports, prefix: &str, bits: u32) -> Ports {
    let name = |name: &str| format!("{prefix}_{name}");
    ports.input(name("tvalid"), 1).output(name("tready"), 1).input(name("tdata"), bits).input(name("tlast"), 1)
}

fn stream_out(ports: Ports, prefix: &str, bits: u32) -> Ports {
    let name = |name: &str| format!("{prefix}_{name}");
    ports.output(name("tvalid"), 1).input(name("tready"), 1).output(name("tdata"), bits).output(name("tlast"), 1)
}

fn lite_slave(ports: Ports, prefix: &str) -> Ports {
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

fn read_master(ports: Ports, prefix: &str, bits: u32) -> Ports {
    let name = |name: &str| format!("{prefix}_{name}");
    let ports = ports.output(name("arvalid"), 1).input(name("arready"), 1).output(name("arid"), ID_BITS);
    let address = |ports: Ports, (field, width): (&str, u32)| ports.output(name(&format!("ar{field}")), width);
    let ports = ADDRESS_FIELDS.into_iter().fold(ports, address);
    let ports = ports.input(name("rvalid"), 1).output(name("rready"), 1).input(name("rid"), ID_BITS);
    ports.input(name("rdata"), bits).input(name("rresp"), RESPONSE_BITS).input(name("rlast"), 1)
}

fn write_master(ports: Ports, prefix: &str, bits: u32) -> Ports {
    let name = |name: &str| format!("{prefix}_{name}");
    let ports = ports.output(name("awvalid"), 1).input(name("awready"), 1).output(name("awid"), ID_BITS);
    let address = |ports: Ports, (field, width): (&str, u32)| ports.output(name(&format!("aw{field}")), width);
    let ports = ADDRESS_FIELDS.into_iter().fold(ports, address);
    let ports = ports.output(name("wvalid"), 1).input(name("wready"), 1).output(name("wdata"), bits);
    let ports = ports.output(name("wstrb"), bits / 8).output(name("wlast"), 1);
    let ports = ports.input(name("bvalid"), 1).output(name("bready"), 1).input(name("bid"), ID_BITS);
    ports.input(name("bresp"), RESPONSE_BITS)
}

fn slave(ports: Ports, prefix: &str, bits: u32) -> Ports {
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
