//! The cores on AXI: units between a core's streams and the bus, and the tops. `docs/interfaces.md` states what each does.

pub mod cores;
pub mod packet_in;
pub mod packet_out;
pub mod reader;
pub mod registers;
pub mod window;
pub mod writer;

mod parts;

pub use cores::{search, splat};

use crate::compiler::Manifest;
use pointcore_contract::Field;
use pointcore_contract::bus::config;
use rtl::{Expr, Module, lit};
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

/// Names and widths of fields, as the front end takes layouts.
fn layout(fields: &[Field]) -> Vec<(&str, u32)> {
    fields.iter().map(|field| (field.name.as_str(), field.width)).collect()
}

/// Fields with their values.
fn named(fields: &[Field], values: Vec<Expr>) -> impl Iterator<Item = (&str, Expr)> {
    fields.iter().map(|field| field.name.as_str()).zip(values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiler::Options;
    use crate::units::testing::check;
    use pointcore_contract::bus::{config::WIDTHS, packets, ports, registers as spec_registers};
    use pointcore_contract::{search, splat};

    /// Few and many fields, with and without a field `end`.
    fn packets() -> Vec<Vec<Field>> {
        let small = splat::Config { continuous: 1, ..splat::Config::default() };
        let large = splat::Config { continuous: 13, cardinal: 1, ..small.clone() };
        let [query, result] = packets::query_and_result(&search::Config::default());
        let [cached_query, cached_result] =
            packets::query_and_result(&search::Config { neighbor_cache: 2, ..search::Config::default() });
        let records = [small, large].map(|config| packets::splat(&config).into_iter().map(|packet| packet.fields));
        records.into_iter().flatten().chain([query, result, cached_query, cached_result]).collect()
    }

    fn range_of(fields: &[Field], name: &'static str) -> Option<packets::FieldRange> {
        fields.iter().any(|field| field.name == name).then_some(packets::FieldRange { name, low: 1, high: 1 })
    }

    #[test]
    fn packet_units_have_the_specified_ports() {
        for fields in packets() {
            for bits in WIDTHS {
                check(&packet_in::module(&fields, bits, None), ports::packet_in(&fields, bits));
                if let Some(range) = ["k", "end"].into_iter().find_map(|name| range_of(&fields, name)) {
                    check(&packet_in::module(&fields, bits, Some(&range)), ports::packet_in(&fields, bits));
                }
                check(&packet_out::module(&fields, bits), ports::packet_out(&fields, bits));
            }
        }
    }

    #[test]
    fn memory_units_have_the_specified_ports() {
        for fields in packets() {
            for bits in WIDTHS {
                for records in [1, 3, 64] {
                    check(&reader::module(&fields, bits, records), ports::reader(&fields, bits, records));
                }
                check(&writer::module(&fields, bits), ports::writer(&fields, bits));
            }
        }
        for index_bits in [2, 8, 9, 15, 21] {
            check(&window::module(index_bits), ports::window(index_bits));
        }
    }

    #[test]
    fn registers_have_the_specified_ports() {
        let b = search::Config { tree_cache: 16, neighbor_cache: 2, ..search::Config::default() };
        let maps = [
            (spec_registers::splat(&splat::Config::default()), [0, 1, 1, 2]),
            (spec_registers::search(&search::Config::default()), [1, 2, 1, 1]),
            (spec_registers::search(&b), [0, 2, 1, 2]),
        ];
        for (map, sources) in maps {
            check(&registers::module(&map, sources), ports::registers(&map, sources));
        }
    }

    #[test]
    fn tops_have_the_specified_ports_at_every_width() {
        let options = Options::default();
        for (stream_bits, memory_bits) in [(32, 512), (64, 64), (128, 32), (256, 128), (512, 256)] {
            let bus = config::Config { stream_bits, memory_bits };
            let a = splat::Config { bus, heap_levels: 3, ..splat::Config::default() };
            let top = super::cores::splat::core(&a, &options).unwrap_or_else(|error| panic!("{error}"));
            check(&top.module, ports::splat(&a));
            let base = search::Config { bus, threads: 2, tree_depth: 3, ..search::Config::default() };
            for (tree_cache, neighbor_cache, lanes) in [(0, 0, 1), (16, 2, 8), (0, 2, 4), (16, 0, 2)] {
                let b = search::Config { tree_cache, neighbor_cache, lanes, ..base.clone() };
                let top = super::cores::search::core(&b, &options).unwrap_or_else(|error| panic!("{error}"));
                check(&top.module, ports::search(&b));
            }
        }
    }
}
