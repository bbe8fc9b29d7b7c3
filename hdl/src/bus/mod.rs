//! The cores on AXI: units between a core's streams and the bus, and the tops. `docs/interfaces.md` states what each does.

pub mod buffer;
pub mod packet_in;
pub mod packet_out;
pub mod reader;
pub mod registers;
pub mod search;
pub mod splat;
pub mod window;
pub mod writer;

mod beats;
mod counters;
mod spread;
mod wiring;

use crate::compiler::Manifest;
use crate::units::records::Record;
use pointcore_contract::bus::config;
use rtl::{Expr, Module, Wire, lit};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A core with its bus.
pub struct Top {
    /// The module `splat_axi` or `search_axi`.
    pub module: Module,
    /// The core inside it.
    pub core: Rc<Module>,
    /// What the compiler decided about the core's datapaths, by unit.
    pub manifests: BTreeMap<String, Manifest>,
}

/// Bits of a byte address in memory.
const ADDRESS_BITS: u32 = config::ADDRESS_BITS;
/// Bits of a burst's length, which is one less than its beats.
const LENGTH_BITS: u32 = config::BURST_BEATS_MAX.ilog2();
/// Bits of a response.
const RESPONSE_BITS: u32 = 2;
/// Bits of a register.
const REGISTER_BITS: u32 = config::REGISTER_BITS;
/// Bytes of a register.
const REGISTER_BYTES: u32 = REGISTER_BITS / 8;
/// `burst` of one whose addresses go up.
const INCREMENTING: Code = Code(1);
/// `resp` where all is well.
const OKAY: Code = Code(0);
/// `resp` of what the unit refuses.
const SLAVE_ERROR: Code = Code(2);

/// A code of two bits.
struct Code(u128);

impl Code {
    fn expr(&self) -> Expr {
        lit(2, self.0)
    }
}

/// `size` of beats of so many bytes.
fn size_of(beat_bytes: u32) -> Expr {
    lit(3, beat_bytes.ilog2().into())
}

/// Declares the ports of a stream that shows a record, and drives `taken` with its `ready`.
fn stream_out(m: &mut Module, name: &str, valid: impl Into<Expr>, record: &Record, taken: Wire) {
    m.output(&format!("{name}_valid"), valid);
    let ready = m.input(&format!("{name}_ready"), 1);
    record.output(m, &format!("{name}_"));
    m.drive(taken, ready);
}

#[cfg(test)]
mod tests;
