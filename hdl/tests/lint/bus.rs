//! The bus units pass through every tool.

use pointcore_contract::bus::{Config, packets, registers as maps};
use pointcore_contract::{Field, search, splat};
use pointcore_hdl::bus::{packet_in, packet_out, reader, registers, search as top_b, splat as top_a, window, writer};
use pointcore_hdl::compiler::Options;
use rtl::{Module, elaborate, elaborate_beside};

use std::collections::HashSet;

use crate::lint::{lint, lint_text};

fn accepts(module: &Module) {
    lint(&elaborate(module).unwrap_or_else(|error| panic!("{error}")));
}

/// The packets of both cores, of few fields and of many.
fn packet_fields() -> Vec<Vec<Field>> {
    let full = splat::Config { continuous: 13, cardinal: 1, ..splat::Config::default() };
    let [query, result] = packets::query_and_result(&search::Config::default());
    let splat = packets::splat(&full).into_iter().take(2).map(|packet| packet.fields);
    splat.chain([query, result]).collect()
}

#[test]
fn tools_accept_the_packet_units() {
    for fields in packet_fields() {
        let query_range = packets::query_range(&search::Config::default());
        let has_k = fields.iter().any(|field| field.name == query_range.name);
        let range = has_k.then_some(&query_range);
        for bits in [32, 64, 512] {
            accepts(&packet_in::module(&fields, bits, range));
            accepts(&packet_out::module(&fields, bits));
        }
    }
}

#[test]
fn tools_accept_the_memory_units() {
    let pixel = packets::splat(&splat::Config::default()).remove(2).fields;
    let points = packets::points(&search::Config { lanes: 8, ..search::Config::default() });
    for bits in [32, 64, 512] {
        for (fields, records) in [(&pixel, 64), (&points, 3), (&pixel, 1)] {
            accepts(&reader::module(fields, bits, records));
            accepts(&writer::module(fields, bits));
        }
    }
    for index_bits in [2, 15] {
        accepts(&window::module(index_bits));
    }
}

#[test]
fn tools_accept_the_registers() {
    let external = search::Config { tree_cache: 16, neighbor_cache: 2, ..search::Config::default() };
    accepts(&registers::module(&maps::splat(&splat::Config::default()), [0, 1, 1, 2]));
    accepts(&registers::module(&maps::search(&search::Config::default()), [1, 2, 1, 1]));
    accepts(&registers::module(&maps::search(&external), [0, 2, 1, 2]));
}

/// The file of the top beside that of its core: no module is in both, none is missing, and the core's is as it is alone.
#[test]
fn a_top_lies_beside_its_core() {
    let config = splat::Config { heap_levels: 3, ..splat::Config::default() };
    let top = top_a::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
    let core = elaborate(&top.core).unwrap_or_else(|error| panic!("{error}"));
    let bus = elaborate_beside(&top.module, &top.core).unwrap_or_else(|error| panic!("{error}"));
    let modules = |text: &str| -> HashSet<String> {
        let lines = text.lines().filter_map(|line| line.strip_prefix("module "));
        lines.map(|line| line.trim_end_matches([' ', '(', '#']).to_owned()).collect()
    };
    let [in_core, in_bus] = [&core, &bus].map(|design| modules(design.verilog()));
    assert!(in_core.is_disjoint(&in_bus), "{in_core:?} {in_bus:?}");
    let modules = bus.modules().iter().map(|module| &module.name);
    let all: HashSet<String> = modules.chain(bus.memory_modules()).cloned().collect();
    assert_eq!(all, in_core.union(&in_bus).cloned().collect());
    assert!(in_core.contains("splat_top") && in_bus.contains("splat_axi"));
    lint_text("splat_axi", &format!("{}{}", bus.verilog(), core.verilog()), &[]);
}

#[test]
fn tools_accept_splat_on_axi() {
    for (stream_bits, memory_bits, continuous, cardinal) in [(32, 512, 1, 0), (64, 64, 13, 1), (512, 32, 6, 0)] {
        let bus = Config { stream_bits, memory_bits };
        let config = splat::Config {
            bus,
            continuous,
            cardinal,
            heap_levels: 3,
            width: 64,
            height: 64,
            ..splat::Config::default()
        };
        let top = top_a::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        accepts(&top.module);
    }
}

#[test]
fn tools_accept_search_on_axi() {
    let base = search::Config {
        index_bits: 10,
        tree_depth: 4,
        bucket: 8,
        neighbors: 4,
        threads: 2,
        ..search::Config::default()
    };
    for (stream_bits, memory_bits, lanes, tree_cache, neighbor_cache) in
        [(32, 512, 1, 0, 0), (64, 64, 2, 16, 0), (512, 32, 4, 0, 2), (64, 128, 8, 16, 3)]
    {
        let bus = Config { stream_bits, memory_bits };
        let config = search::Config { bus, lanes, tree_cache, neighbor_cache, ..base.clone() };
        let top = top_b::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        accepts(&top.module);
    }
}
