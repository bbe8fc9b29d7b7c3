//! What holds of every bus unit's ports, at every width.

use super::*;
use crate::compiler::Options;
use crate::units::testing::check;
use pointcore_contract::bus::{config::WIDTHS, packets, ports, registers as spec_registers};
use pointcore_contract::splat::Field;
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
    fields.iter().any(|(field, _)| field == name).then_some(packets::FieldRange { name, low: 1, high: 1 })
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
        let top = super::splat::core(&a, &options).unwrap_or_else(|error| panic!("{error}"));
        check(&top.module, ports::splat(&a));
        let base = search::Config { bus, threads: 2, tree_depth: 3, ..search::Config::default() };
        for (tree_cache, neighbor_cache, lanes) in [(0, 0, 1), (16, 2, 8), (0, 2, 4), (16, 0, 2)] {
            let b = search::Config { tree_cache, neighbor_cache, lanes, ..base.clone() };
            let top = super::search::core(&b, &options).unwrap_or_else(|error| panic!("{error}"));
            check(&top.module, ports::search(&b));
        }
    }
}
