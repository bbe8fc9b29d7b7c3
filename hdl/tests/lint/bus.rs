//! The bus units pass through every tool.

use pointcore_contract::bus::Config;
use pointcore_contract::bus::packets::Packet;
use pointcore_contract::bus::registers::{ErrorSources, SearchRegisters, SplatRegisters};
use pointcore_contract::search::records::{CachedQuery, CachedResult, Points};
use pointcore_contract::splat::records::{Fragment, Pixel, Splat};
use pointcore_contract::{Record, search, splat};
use pointcore_hdl::bus::{packet_in, packet_out, reader, registers, search as top_b, splat as top_a, window, writer};
use pointcore_hdl::compiler::Options;
use rtl::{Module, elaborate, elaborate_beside};

use std::collections::HashSet;

use crate::lint::{lint, lint_text};

fn accepts(module: &Module) {
    lint(&elaborate(module).unwrap_or_else(|error| panic!("{error}")));
}

fn accepts_packets<R: Packet>(config: &R::Config) {
    for bits in [32, 64, 512] {
        accepts(&packet_in::module::<R>(config, bits));
        accepts(&packet_out::module::<R>(config, bits));
    }
}

#[test]
fn tools_accept_the_packet_units() {
    let full = splat::Config { continuous: 13, cardinal: 1, ..splat::Config::default() };
    accepts_packets::<Splat>(&full);
    accepts_packets::<Fragment>(&full);
    accepts_packets::<CachedQuery>(&search::Config::default());
    accepts_packets::<CachedResult>(&search::Config::default());
}

fn accepts_memory<R: Record>(config: &R::Config, records_max: u32) {
    for bits in [32, 64, 512] {
        accepts(&reader::module::<R>(config, bits, records_max));
        accepts(&writer::module::<R>(config, bits));
    }
}

#[test]
fn tools_accept_the_memory_units() {
    accepts_memory::<Pixel>(&splat::Config::default(), 64);
    accepts_memory::<Points>(&search::Config { lanes: 8, ..search::Config::default() }, 3);
    accepts_memory::<Pixel>(&splat::Config::default(), 1);
    for index_bits in [2, 15] {
        accepts(&window::module(index_bits));
    }
}

#[test]
fn tools_accept_the_registers() {
    let sources = |busy, burst, memory| ErrorSources { busy, burst, packet: 1, memory };
    let external = search::Config { tree_cache: 16, neighbor_cache: 2, ..search::Config::default() };
    accepts(&registers::module::<SplatRegisters>(&splat::Config::default(), sources(0, 1, 2)));
    accepts(&registers::module::<SearchRegisters>(&search::Config::default(), sources(1, 2, 1)));
    accepts(&registers::module::<SearchRegisters>(&external, sources(0, 2, 2)));
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
