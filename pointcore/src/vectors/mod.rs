//! What a driver sends to a core over the bus, and what must come back (`docs/interfaces.md`): register writes, packets and memory
//! images of a frame or a search, with the golden model's answer. For bringing up a board, and for tests of the tops that speak AXI.

mod search;
mod splat;

pub use search::search;
pub use splat::frame;

use crate::generated::GenerateError;
use pointcore_contract::Field;
use pointcore_contract::bus::config::BORDER_BYTES;
use pointcore_contract::bus::{Config, Layout, Register};
use pointcore_tb::lockstep::LockstepError;
use serde::Serialize;

/// Vectors that cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum VectorsError {
    /// A place in memory where nothing can begin.
    #[error("the memory's base is {0:#x}: expected a multiple of {BORDER_BYTES:#x} that fits 32 bits")]
    Base(u64),
    /// A frame of several surfaces.
    #[error(
        "{0} surfaces, of which each has a start of its own on the bus, and vectors are of one: leave out `splatting.surfaces`"
    )]
    Surfaces(usize),
    /// More memory than addresses.
    #[error("{name} of {bytes} bytes from {base:#x} on goes beyond the 32 bits of an address: choose a lower base")]
    Space {
        /// What does not fit.
        name: &'static str,
        /// Its size.
        bytes: u64,
        /// Where it would begin.
        base: u64,
    },
    /// Queries whose numbers repeat.
    #[error("{queries} queries, but `index_bits` = {bits} number only {limit}: ask for fewer or raise it")]
    Numbers {
        /// Queries asked.
        queries: usize,
        /// The configuration's `index_bits`.
        bits: u32,
        /// Queries that have numbers of their own.
        limit: u64,
    },
    /// A fault of the generator.
    #[error("the hardware could not be generated: {0}")]
    Generate(#[from] GenerateError),
    /// The golden model does not come to its end.
    #[error(transparent)]
    Frame(#[from] LockstepError),
    /// Tree, queries, or the golden model's search.
    #[error(transparent)]
    Search(#[from] crate::search::SearchError),
}

/// A value to be written into a register before the run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RegisterWrite {
    /// The register.
    pub name: String,
    /// Its byte address.
    pub address: u32,
    /// What to write.
    pub value: u32,
}

/// Where a field lies in a packet: in the low `bits` of so many bytes, lowest first.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct FieldPlace {
    /// The field.
    pub name: String,
    /// First byte.
    pub byte: u32,
    /// Number of bytes.
    pub bytes: u32,
    /// Bits that count.
    pub bits: u32,
}

/// Packets of one kind, one after the other.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Packets {
    /// What they are.
    pub name: &'static str,
    /// The file that holds them.
    pub file: String,
    /// Bytes of a packet.
    pub packet_bytes: u32,
    /// Number of packets.
    pub packets: usize,
    /// Their fields.
    pub fields: Vec<FieldPlace>,
    /// The file's contents.
    #[serde(skip)]
    pub contents: Vec<u8>,
}

/// A part of the memory around the core.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Region {
    /// What it holds.
    pub name: &'static str,
    /// The port by which the core reads it, or the host writes it.
    pub port: &'static str,
    /// Its first address on that port.
    pub base: u32,
    /// Its size.
    pub bytes: u64,
    /// Bytes from one record to the next.
    pub stride: u32,
    /// The file that holds its contents, where they matter.
    pub file: Option<String>,
    /// The file's contents.
    #[serde(skip)]
    pub contents: Option<Vec<u8>>,
}

/// A run: what to write, what to send, what comes back.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Vectors {
    /// The module that the vectors are for.
    pub top: &'static str,
    /// Bits of a beat of the streams.
    pub stream_bits: u32,
    /// Bits of a beat of the memory ports.
    pub memory_bits: u32,
    /// Registers to write before the run.
    pub registers: Vec<RegisterWrite>,
    /// Packets to send.
    pub send: Packets,
    /// Packets that must come.
    pub receive: Packets,
    /// Memory that the run needs.
    pub memory: Vec<Region>,
}

impl Vectors {
    /// Names and contents of the files that belong to the vectors.
    pub fn files(&self) -> impl Iterator<Item = (&str, &[u8])> {
        let packets = [&self.send, &self.receive].map(|packets| (packets.file.as_str(), packets.contents.as_slice()));
        let regions =
            self.memory.iter().filter_map(|region| Some((region.file.as_deref()?, region.contents.as_deref()?)));
        packets.into_iter().chain(regions)
    }
}

impl Packets {
    /// Packets of these records, a value a field.
    fn new<'a>(
        name: &'static str,
        fields: &[Field],
        bus: &Config,
        records: impl Iterator<Item = Vec<u64>> + 'a,
    ) -> Self {
        let layout = Layout::of(fields);
        let packet_bytes = layout.packet_bytes(bus.stream_bits);
        let contents: Vec<u8> = records.flat_map(|record| layout.encode(&record, packet_bytes)).collect();
        let place = |place: &pointcore_contract::bus::Place| FieldPlace {
            name: place.name.clone(),
            byte: place.byte,
            bytes: place.bytes,
            bits: place.width,
        };
        Self {
            name,
            file: format!("{name}.bin"),
            packet_bytes,
            packets: contents.len() / packet_bytes as usize,
            fields: layout.places.iter().map(place).collect(),
            contents,
        }
    }
}

/// Hands out memory, every region from a multiple of the border on.
struct AddressSpace {
    next: u64,
}

impl AddressSpace {
    fn new(base: u64) -> Result<Self, VectorsError> {
        let fits = base.is_multiple_of(BORDER_BYTES.into()) && u32::try_from(base).is_ok();
        if fits { Ok(Self { next: base }) } else { Err(VectorsError::Base(base)) }
    }

    fn take(&mut self, name: &'static str, bytes: u64) -> Result<u32, VectorsError> {
        let base = self.next;
        self.next = (base + bytes).next_multiple_of(BORDER_BYTES.into());
        if base + bytes > 1 << u32::BITS {
            return Err(VectorsError::Space { name, bytes, base });
        }
        Ok(base as u32)
    }
}

/// The writes that give registers of a map these values.
fn writes<'a>(map: &[Register], values: impl IntoIterator<Item = (&'a str, u32)>) -> Vec<RegisterWrite> {
    let write = |(name, value)| {
        let register = map.iter().find(|register| register.name == name).expect("the map has the core's settings");
        RegisterWrite { name: register.name.clone(), address: register.address, value }
    };
    values.into_iter().map(write).collect()
}
