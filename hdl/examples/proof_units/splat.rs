//! The renderer's units that keep and order what must not be lost, with as few levels, tiles and slots as show every case.

use super::Proof;
use pointcore_contract::Format;
use pointcore_contract::splat::attribute::{AttributeFormat, Fraction};
use pointcore_contract::splat::config::Reordering;
use pointcore_contract::splat::{Config, Feature};
use pointcore_hdl::splat::tile_cache::Depths;
use pointcore_hdl::splat::{accumulator, heap, merge, occlusion, payloads, reorder, tile_cache};

/// An image of two by two tiles.
const EDGE: u32 = 16;

/// Copies as small as they can be: what of them is only passed on is proved of any field.
fn copies() -> Config {
    Config { width: EDGE, height: EDGE, continuous: 1, eye_plane: Feature::Off, ..Config::default() }
}

/// Heaps of so many levels, cycles an operation, and bits of arrival numbers, which wrap soon.
fn heaps() -> [Proof; 3] {
    let heap = |name, heap_levels, heap_interval, sequence_bits| {
        let config = Config { width: EDGE, height: EDGE, heap_levels, heap_interval, ..Config::default() };
        let sizes = [
            ("LEVELS", heap_levels),
            ("INTERVAL", heap_interval),
            ("TILE_BITS", config.tile_bits()),
            ("SEQUENCE_BITS", sequence_bits),
        ];
        Proof::new(name, heap::numbered(&config, sequence_bits), &sizes)
    };
    [heap("splat_heap", 2, 2, 2), heap("splat_heap_slow", 2, 4, 2), heap("splat_heap_deep", 3, 2, 3)]
}

/// A cache of two slots for four tiles, with short queues, with neighbors of all kinds, with some that never wait, and with a
/// copy that is late.
fn tile_caches() -> [Proof; 3] {
    const DEPTHS: Depths = Depths { placed: 2, asked: 2, written: 2 };
    let config = Config { splat_levels: 0, tile_slots: 2, ..copies() };
    let sizes = [("ATTRIBUTE_BITS", config.attribute.width()), ("SPLAT_BITS", config.splat_bits())];
    let cache = |name| Proof::new(name, tile_cache::sized(&config, DEPTHS), &sizes);
    [
        cache("splat_tile_cache"),
        Proof { flags: vec!["STEADY"], ..cache("splat_tile_cache_steady") },
        Proof { flags: vec!["STEADY", "LATE"], ..cache("splat_tile_cache_late") },
    ]
}

/// Payloads of one splat, in one word and in two, with neighbors of all kinds and with some that never wait, and of two splats.
fn payloads() -> [Proof; 4] {
    let payloads = |name, splat_levels, payload_beats| {
        let config = Config { splat_levels, payload_beats, tile_slots: 2, ..copies() };
        let sizes = [
            ("PLACES", config.splats_held()),
            ("SPLAT_BITS", config.splat_bits()),
            ("ATTRIBUTE_BITS", config.attribute.width()),
            // On their way out: two in a queue, one that is read, one shown, and of several words one that is complete.
            ("LEAVING", if payload_beats > 1 { 5 } else { 4 }),
            ("PATIENCE", 16 + payload_beats),
        ];
        Proof::new(name, payloads::module(&config), &sizes)
    };
    [
        payloads("splat_payloads", 0, 2),
        Proof { flags: vec!["STEADY"], ..payloads("splat_payloads_steady", 0, 2) },
        payloads("splat_payloads_word", 0, 1),
        payloads("splat_payloads_two", 1, 3),
    ]
}

/// Copies that wait by four pointers, with and without a sink that begins late.
fn reorders() -> [Proof; 3] {
    let reorder = |name, reorder, patience| {
        let config = Config { heap_levels: 2, splat_levels: 2, reorder, tile_slots: 3, ..copies() };
        let sizes = [("POINTERS", config.pointers()), ("PATIENCE", patience)];
        Proof::new(name, reorder::module(&config), &sizes)
    };
    [
        reorder("splat_reorder", Reordering::Heap, 10),
        Proof { flags: vec!["STALLED"], ..reorder("splat_reorder_stalled", Reordering::Heap, 10) },
        reorder("splat_reorder_lists", Reordering::Lists, 20),
    ]
}

/// Two slots of two pixels, behind a queue of four samples.
fn accumulator() -> Proof {
    let config = Config {
        width: EDGE,
        height: EDGE,
        tile_slots: 2,
        continuous: 1,
        attribute: AttributeFormat::Fixed(Fraction::Eight),
        accumulate_stages: 5,
        ..Config::default()
    };
    Proof::new("splat_accumulator", accumulator::sized(&config, 4, 2), &[])
}

/// Three fragments that wait, with depths of as few bits as are ordered, with neighbors of all kinds and with some that never wait.
fn merges() -> [Proof; 2] {
    const AHEAD: u32 = 3;
    let geometry = Format { exponent: 1, mantissa: 0, ..Format::F24.flushed() };
    let config = Config { geometry, merge: Feature::On, merge_ahead: AHEAD, ..copies() };
    let sizes =
        [("DEPTH_BITS", geometry.width()), ("ATTRIBUTE_BITS", config.attribute.width()), ("PATIENCE", AHEAD + 3)];
    let merge = |name| Proof::new(name, merge::module(&config), &sizes);
    [merge("splat_merge"), Proof { flags: vec!["STEADY"], ..merge("splat_merge_steady") }]
}

/// Two slots for tiles of two rows of two pixels, with neighbors of all kinds and with some that never wait.
fn occlusions() -> [Proof; 2] {
    let config = Config {
        merge: Feature::On,
        time_bins: 2,
        screen_filter: Feature::Off,
        attribute: AttributeFormat::Fixed(Fraction::Eight),
        tile_slots: 2,
        ..copies()
    };
    let occlusion = |name| Proof::new(name, occlusion::sized(&config, 2), &[]);
    [occlusion("splat_occlusion"), Proof { flags: vec!["STEADY"], ..occlusion("splat_occlusion_steady") }]
}

pub(super) fn proofs() -> impl Iterator<Item = Proof> {
    let caches = heaps().into_iter().chain(tile_caches()).chain(payloads()).chain(reorders());
    caches.chain([accumulator()]).chain(merges()).chain(occlusions())
}
