//! The bus units pass through every tool.

use pointcore_hdl::bus::{packet_in, packet_out, reader, window, writer};
use pointcore_hdl::rtl::{Module, elaborate};
use pointcore_spec::bus::packets;
use pointcore_spec::core_a::{self, Field};
use pointcore_spec::core_b;

use crate::tools::lint;

fn accepts(module: &Module) {
    lint(&elaborate(module).unwrap_or_else(|error| panic!("{error}")));
}

/// The packets of both cores, of few fields and of many.
fn packet_fields() -> Vec<Vec<Field>> {
    let full = core_a::Config { continuous: 13, cardinal: 1, ..core_a::Config::default() };
    let [query, result] = packets::query_and_result(&core_b::Config::default());
    let core_a = packets::core_a(&full).into_iter().take(2).map(|packet| packet.fields);
    core_a.chain([query, result]).collect()
}

#[test]
fn tools_accept_the_packet_units() {
    for fields in packet_fields() {
        let query_range = packets::query_range(&core_b::Config::default());
        let has_k = fields.iter().any(|(name, _)| name == query_range.name);
        let range = has_k.then_some(&query_range);
        for bits in [32, 64, 512] {
            accepts(&packet_in::module(&fields, bits, range));
            accepts(&packet_out::module(&fields, bits));
        }
    }
}

#[test]
fn tools_accept_the_memory_units() {
    let pixel = packets::core_a(&core_a::Config::default()).remove(2).fields;
    let points = packets::points(&core_b::Config { lanes: 8, ..core_b::Config::default() });
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
