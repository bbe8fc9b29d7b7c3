//! The cores on AXI: units between a core's streams and the bus, and the tops. `docs/interfaces.md` states what each does.

pub mod abort;
pub mod cores;
pub mod frames;
pub mod packet_in;
pub mod packet_out;
pub mod reader;
pub mod registers;
pub mod window;
pub mod writer;

mod parts;

pub use cores::{points, search, splat};

use crate::compiler::Manifest;
use pointcore_contract::bus::config;
use rtl::{Expr, Module, lit};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A core with its bus.
pub struct Top {
    /// The module `splat_axi`, `search_axi` or `points_axi`.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiler::Options;
    use crate::units::testing::check;
    use pointcore_contract::Record;
    use pointcore_contract::bus::config::WIDTHS;
    use pointcore_contract::bus::packets::Packet;
    use pointcore_contract::bus::registers::{ErrorSources, RegisterMap, SearchRegisters, SplatRegisters};
    use pointcore_contract::bus::units::{self, Packets, Reads, Registered, Writes};
    use pointcore_contract::search::records::{CachedQuery, CachedResult};
    use pointcore_contract::splat::records::{Fragment, Pixel, Splat};
    use pointcore_contract::{points, process, search, splat};

    fn splats() -> [splat::Config; 2] {
        let small = splat::Config { continuous: 1, ..splat::Config::default() };
        let large = splat::Config { continuous: 13, cardinal: 1, ..small.clone() };
        [small, large]
    }

    fn searches() -> [search::Config; 2] {
        [0, 2].map(|neighbor_cache| search::Config { neighbor_cache, ..search::Config::default() })
    }

    fn check_packets<R: Packet>(config: &R::Config) {
        for stream_bits in WIDTHS {
            let unit = Packets::<R> { record: config, stream_bits };
            check(&packet_in::module::<R>(config, stream_bits), units::packet_in::interface(&unit).ports());
            check(&packet_out::module::<R>(config, stream_bits), units::packet_out::interface(&unit).ports());
        }
    }

    fn check_memory<R: Record>(config: &R::Config) {
        for memory_bits in WIDTHS {
            for records_max in [1, 3, 64] {
                let unit = Reads::<R> { record: config, memory_bits, records_max };
                let module = reader::module::<R>(config, memory_bits, records_max);
                check(&module, units::reader::interface(&unit).ports());
            }
            let unit = Writes::<R> { record: config, memory_bits };
            check(&writer::module::<R>(config, memory_bits), units::writer::interface(&unit).ports());
        }
    }

    #[test]
    fn packet_units_have_the_specified_ports() {
        for config in splats() {
            check_packets::<Splat>(&config);
            check_packets::<Fragment>(&config);
        }
        for config in searches() {
            check_packets::<CachedQuery>(&config);
            check_packets::<CachedResult>(&config);
        }
    }

    #[test]
    fn memory_units_have_the_specified_ports() {
        splats().iter().for_each(check_memory::<Pixel>);
        splats().iter().for_each(check_memory::<Splat>);
        searches().iter().for_each(check_memory::<CachedQuery>);
        for index_bits in [2, 8, 9, 15, 21] {
            check(&window::module(index_bits), units::window::interface(&index_bits).ports());
        }
    }

    fn check_registers<M: RegisterMap>(config: &M::Config, [busy, burst, packet, memory]: [u32; 4]) {
        let sources = ErrorSources { busy, burst, packet, memory };
        let unit = Registered::<M> { config, sources };
        check(&registers::module::<M>(config, sources), units::registers::interface(&unit).ports());
    }

    #[test]
    fn the_abort_has_the_specified_ports() {
        check(&abort::module(), units::abort::interface(&()).ports());
    }

    #[test]
    fn frames_have_the_specified_ports() {
        for config in splats() {
            check(&frames::module(&config), units::frames::interface(&config).ports());
        }
    }

    #[test]
    fn registers_have_the_specified_ports() {
        let b = search::Config { tree_cache: 16, neighbor_cache: 2, ..search::Config::default() };
        check_registers::<SplatRegisters>(&splat::Config::default(), [0, 1, 1, 2]);
        check_registers::<SearchRegisters>(&search::Config::default(), [1, 2, 1, 1]);
        check_registers::<SearchRegisters>(&b, [0, 2, 1, 2]);
    }

    #[test]
    fn tops_have_the_specified_ports_at_every_width() {
        let options = Options::default();
        for (stream_bits, memory_bits) in [(32, 512), (64, 64), (128, 32), (256, 128), (512, 256)] {
            let bus = config::Config { stream_bits, memory_bits };
            let a = splat::Config { bus, heap_levels: 3, ..splat::Config::default() };
            let top = super::cores::splat::core(&a, &options).unwrap_or_else(|error| panic!("{error}"));
            check(&top.module, units::splat_axi::interface(&a).ports());
            let base = search::Config { bus, threads: 2, tree_depth: 3, ..search::Config::default() };
            for (tree_cache, neighbor_cache, lanes) in [(0, 0, 1), (16, 2, 8), (0, 2, 4), (16, 0, 2)] {
                let b = search::Config { tree_cache, neighbor_cache, lanes, ..base.clone() };
                let top = super::cores::search::core(&b, &options).unwrap_or_else(|error| panic!("{error}"));
                check(&top.module, units::search_axi::interface(&b).ports());
                let process = process::Config { index_bits: b.index_bits, ..points::Config::default().process };
                let c = points::Config { search: b, process };
                let top = super::cores::points::core(&c, &options).unwrap_or_else(|error| panic!("{error}"));
                check(&top.module, units::points_axi::interface(&c).ports());
            }
        }
    }
}
