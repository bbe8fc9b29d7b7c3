//! A self-checking test of a core on AXI: a bench with models of buses plays a script, and compares every answer with what the
//! contract and the golden model say.

mod bench;
mod control;
mod operations;
mod points_script;
mod registers;
mod script;
mod search_script;
mod splat_script;

use crate::search::SearchError;
use crate::splat::SplatCore;
use bench::{Bench, BenchMemory, Buffer, Placed, RecordMemory};
use pointcore_contract::bus::Layout;
use pointcore_contract::bus::units::splat_axi::Ports;
use pointcore_contract::process::queries::Outcome;
use pointcore_contract::search::records::CachedResult;
use pointcore_contract::splat::config::{MERGED_DEPTH_BITS, TILE_PIXELS};
use pointcore_contract::splat::records::{Fragment, PayloadWord, Pixel, payload_bytes};
use pointcore_contract::{Record, fields, points, search, splat};
use pointcore_tb::lockstep::LockstepError;
use rtl::Design;

/// A test's text, and what it reads.
pub struct AxiTest {
    /// SystemVerilog.
    pub text: String,
    /// The script.
    pub vectors: String,
}

/// The bit of a fragment's first word that closes a frame: its first field.
const END_MASK: u32 = 1;

/// The bits of a packet that name what it answers: of each field those that a function of its name leaves.
fn name_mask<R: Record>(config: &R::Config, stream_bits: u32, named: fn(&str) -> u64) -> Vec<u8> {
    let layout = Layout::record::<R>(config);
    layout.mask(layout.packet_bytes(stream_bits), named)
}

/// All of a query's number.
fn number(field: &str) -> u64 {
    if field == "number" { u64::MAX } else { 0 }
}

/// The test of the search core.
///
/// # Errors
/// The golden model is stuck.
pub fn of_search(top: &Design, config: &search::Config) -> Result<AxiTest, SearchError> {
    let script = search_script::script(config)?.finish();
    let bench = Bench {
        top,
        bus: config.bus,
        script: &script,
        name_mask: name_mask::<CachedResult>(config, config.bus.stream_bits, number),
        end_mask: 0,
        events: fields::<search::units::Events>(config),
        memories: if config.tree_cache > 0 {
            vec![BenchMemory::POINTS, BenchMemory::TREE]
        } else {
            vec![BenchMemory::POINTS]
        },
        has_window: config.tree_cache == 0,
        buffer: None,
        records: vec![],
    };
    Ok(AxiTest { text: bench.text(), vectors: script.text })
}

/// The test of the point processor.
///
/// # Errors
/// The golden model is stuck.
pub fn of_points(top: &Design, config: &points::Config) -> Result<AxiTest, SearchError> {
    let script = points_script::script(config)?.finish();
    let has_tree = config.search.tree_cache > 0;
    let bench = Bench {
        top,
        bus: config.search.bus,
        script: &script,
        name_mask: name_mask::<Outcome>(&config.process, config.search.bus.stream_bits, number),
        end_mask: 0,
        events: fields::<points::units::Events>(config),
        memories: [BenchMemory::POINTS, BenchMemory::LINES]
            .into_iter()
            .chain(has_tree.then_some(BenchMemory::TREE))
            .collect(),
        has_window: !has_tree,
        buffer: None,
        records: vec![],
    };
    Ok(AxiTest { text: bench.text(), vectors: script.text })
}

/// The test of the renderer.
///
/// # Errors
/// A frame does not come to its end.
pub fn of_splat(top: &Design, core: &SplatCore, config: &splat::Config) -> Result<AxiTest, LockstepError> {
    let script = splat_script::script(config, core)?.finish();
    let stride = Layout::record::<Pixel>(config).stride(config.bus.memory_bits);
    let bench = Bench {
        top,
        bus: config.bus,
        script: &script,
        name_mask: name_mask::<Fragment>(config, config.bus.stream_bits, splat_script::tile),
        end_mask: END_MASK,
        events: fields::<splat::units::Events>(config),
        memories: vec![],
        has_window: false,
        buffer: Some(Buffer {
            tiles: config.buffer_tiles() as u32,
            pixel_beats: stride / (config.bus.memory_bits / 8),
            pixel: fields::<Pixel>(config),
            ports: (0..config.memory_ports as usize).map(pixel_ports).collect(),
        }),
        records: [payloads(config), depths(config)].into_iter().flatten().collect(),
    };
    Ok(AxiTest { text: bench.text(), vectors: script.text })
}

/// By which the core asks for pixels, takes them and writes them.
const fn pixel_ports(port: usize) -> [&'static str; 3] {
    let ports = splat::units::top::PORTS;
    [ports.read[port].name, ports.data[port].name, ports.write[port].name]
}

/// The memory of payloads, if there is one.
fn payloads(config: &splat::Config) -> Option<RecordMemory> {
    let beat_bits = config.bus.memory_bits;
    let stride = Layout::record::<PayloadWord>(config).stride(beat_bits);
    let ports = Ports::ALL.payload_reads.iter().take(config.payload_ports() as usize);
    config.has_payloads_in_memory().then(|| RecordMemory {
        kind: "payload",
        ports: ports.map(|port| port.address.bus).collect(),
        is_apart: true,
        is_written: true,
        records: payload_bytes(config, beat_bits) / stride,
        record_beats: stride / (beat_bits / 8),
        beat_bits,
        placed: Placed::Nothing,
        operation: script::PLACE_PAYLOADS,
    })
}

/// The memory of depths, if there is one.
fn depths(config: &splat::Config) -> Option<RecordMemory> {
    let ports = Ports::ALL.depth_reads.iter().take(config.merge_ports() as usize);
    config.merge.is_on().then(|| RecordMemory {
        kind: "depth",
        ports: ports.map(|port| port.address.bus).collect(),
        is_apart: false,
        is_written: config.tests_fragments(),
        records: TILE_PIXELS << config.image_tile_bits(),
        record_beats: 1,
        beat_bits: MERGED_DEPTH_BITS,
        placed: Placed::Depths,
        operation: script::PLACE_DEPTHS,
    })
}
