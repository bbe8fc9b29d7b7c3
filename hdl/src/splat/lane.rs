//! A rasterizer and all that it has to itself, from copies to finished pixels (thesis 5.5.3); golden twin:
//! `pointcore_golden::splat::lane`.

use super::{accumulator, occlusion, payloads, prefetch, rasterizer, reorder, tile_cache, weighting};
use crate::compiler::{CompileError, Datapath, Manifest, Options};
use crate::units::ports::{
    InputPorts, OutputPorts, Pulse, PulseInPorts, StreamInPorts, StreamOutPorts, WordPort, pipe, pulse,
};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{ArrivedCopy, TileCopy};
use pointcore_contract::splat::units::lane::PORTS;
use pointcore_contract::splat::units::{self, LaneEvents};
use rtl::{Expr, Instance, Module};
use std::collections::BTreeMap;

/// A lane and what the compiler decided about its datapaths, by unit.
pub struct Lane {
    /// The module, `splat_lane`.
    pub module: Module,
    /// By unit.
    pub manifests: BTreeMap<String, Manifest>,
}

/// Connects the tile cache to the slots in the accumulator.
fn slots(m: &mut Module, config: &Config, [cache, slots]: [Instance; 2]) {
    use units::{accumulator, tile_cache};
    let ready = tile_cache::PORTS.slot_ready.word_of(m, cache);
    accumulator::PORTS.slot_ready.feed_word(m, slots, ready);
    pulse(m, config, (cache, tile_cache::PORTS.change), (slots, accumulator::PORTS.change));
    let masks = accumulator::PORTS.masks.of(m, config, slots);
    tile_cache::PORTS.masks.feed(m, config, cache, masks);
    pulse(m, config, (cache, tile_cache::PORTS.fill), (slots, accumulator::PORTS.fill));
    let writes = accumulator::PORTS.sample_writes.word_of(m, slots);
    tile_cache::PORTS.sample_writes.feed_word(m, cache, writes);
    pulse(m, config, (cache, tile_cache::PORTS.drain), (slots, accumulator::PORTS.drain));
    let reads = accumulator::PORTS.sample_reads.word_of(m, slots);
    tile_cache::PORTS.sample_reads.feed_word(m, cache, reads);
    pulse(m, config, (slots, accumulator::PORTS.drained), (cache, tile_cache::PORTS.drained));
    pulse(m, config, (slots, accumulator::PORTS.retire), (cache, tile_cache::PORTS.retire));
}

/// Leads copies to where they are put in order, unless too many frames are under way, and tells the tile cache of them.
fn order(m: &mut Module, config: &Config, payloads: Instance, reorder: Instance, cache: Instance) {
    use units::tile_cache;
    let copy = units::payloads::PORTS.copy.of(m, config, payloads);
    let full = tile_cache::PORTS.full.word_of(m, cache);
    let valid = m.wire("copy_comes", copy.valid & !full);
    let ready = units::reorder::PORTS.input.offer(m, config, reorder, valid, copy.record);
    m.drive(copy.ready, ready & !full);
    let TileCopy { end, tile, splat, .. } = copy.record;
    let arrives = Pulse { valid: valid & ready, record: ArrivedCopy { end, tile, splat } };
    tile_cache::PORTS.arrives.feed(m, config, cache, arrives);
}

/// Connects the payloads to their memory, and asks for them as copies come in order; returns what these pass.
fn payloads_in_memory(m: &mut Module, config: &Config, payloads: Instance, reorder: Instance) -> Instance {
    use units::payloads as splats;
    let prefetch = m.instance("prefetch", prefetch::module(config));
    pipe(m, config, (reorder, units::reorder::PORTS.out), (prefetch, units::prefetch::PORTS.input));
    let read = units::prefetch::PORTS.read.of(m, config, prefetch);
    PORTS.payload_read.export(m, config, read);
    let data = PORTS.payload_data.declare(m, config);
    splats::PORTS.data.feed(m, config, payloads, data);
    let write = splats::PORTS.write.of(m, config, payloads);
    PORTS.payload_write.export(m, config, write);
    let left = splats::PORTS.read.word_of(m, payloads);
    units::prefetch::PORTS.left.feed_word(m, prefetch, left);
    prefetch
}

/// Has samples tested against depths in memory; returns what these pass.
fn occlusion(m: &mut Module, config: &Config, rasterizer: Instance, cache: Instance) -> Instance {
    use units::occlusion as tests;
    let occlusion = m.instance("occlusion", occlusion::module(config));
    pipe(m, config, (rasterizer, units::rasterizer::PORTS.out), (occlusion, tests::PORTS.input));
    pulse(m, config, (cache, units::tile_cache::PORTS.placed), (occlusion, tests::PORTS.placed));
    let read = tests::PORTS.depth_read.of(m, config, occlusion);
    PORTS.depth_read.export(m, config, read);
    let data = PORTS.depth_data.declare(m, config);
    tests::PORTS.depth_data.feed(m, config, occlusion, data);
    occlusion
}

/// Builds a lane.
///
/// # Errors
/// What the compiler rejects.
pub fn lane(config: &Config, options: &Options) -> Result<Lane, CompileError> {
    let mut m = Module::new("splat_lane", "A rasterizer with the lists, slots and sums of its share of the tiles.");
    let mut manifests = BTreeMap::new();
    let mut datapath = |m: &mut Module, name: &str, datapath: Datapath| {
        manifests.insert(name.to_owned(), datapath.manifest);
        m.instance(name, datapath.module)
    };
    let payloads = m.instance("payloads", payloads::module(config));
    let reorder = m.instance("reorder", reorder::module(config));
    let cache = m.instance("tile_cache", tile_cache::module(config));
    let rasterizer = datapath(&mut m, "rasterizer", rasterizer::datapath(config, options)?);
    let weighting = datapath(&mut m, "weighting", weighting::datapath(config, options)?);
    let accumulator = m.instance("accumulator", accumulator::module(config));

    use units::{accumulator as sums, payloads as splats, rasterizer as samples, tile_cache as tiles};
    let copy = PORTS.input.declare(&mut m, config);
    splats::PORTS.input.feed(&mut m, config, payloads, copy);
    order(&mut m, config, payloads, reorder, cache);
    let ordered = if config.has_payloads_in_memory() {
        (payloads_in_memory(&mut m, config, payloads, reorder), units::prefetch::PORTS.out)
    } else {
        (reorder, units::reorder::PORTS.out)
    };
    pipe(&mut m, config, ordered, (cache, tiles::PORTS.input));
    pipe(&mut m, config, (cache, tiles::PORTS.out), (payloads, splats::PORTS.placed));
    pipe(&mut m, config, (payloads, splats::PORTS.out), (rasterizer, samples::PORTS.input));
    let occlusion = config.tests_samples().then(|| occlusion(&mut m, config, rasterizer, cache));
    let seen = occlusion.map_or((rasterizer, samples::PORTS.out), |tests| (tests, units::occlusion::PORTS.out));
    pipe(&mut m, config, seen, (weighting, units::weighting::PORTS.input));
    pipe(&mut m, config, (weighting, units::weighting::PORTS.out), (accumulator, sums::PORTS.input));
    slots(&mut m, config, [cache, accumulator]);

    let read = tiles::PORTS.read.of(&mut m, config, cache);
    PORTS.read.export(&mut m, config, read);
    let data = PORTS.data.declare(&mut m, config);
    tiles::PORTS.data.feed(&mut m, config, cache, data);
    let write = tiles::PORTS.write.of(&mut m, config, cache);
    PORTS.write.export(&mut m, config, write);
    let pixel = tiles::PORTS.pixel.of(&mut m, config, cache);
    PORTS.pixel.export(&mut m, config, pixel);
    if config.rasterizers > 1 {
        let number = PORTS.number.declare_word(&mut m, config.rasterizer_bits());
        tiles::PORTS.number.feed_word(&mut m, cache, number);
        let sent = PORTS.frame_sent.declare_word(&mut m, 1);
        tiles::PORTS.frame_sent.feed_word(&mut m, cache, sent);
    }
    if config.screen_filter.is_on() {
        let scale = PORTS.filter_scale.declare_word(&mut m, config.filter_scale_format().width());
        samples::PORTS.filter_scale.feed_word(&mut m, rasterizer, scale);
    }
    if config.has_motion() {
        let depth_a = PORTS.depth_a.declare_word(&mut m, config.geometry.width());
        samples::PORTS.depth_a.feed_word(&mut m, rasterizer, depth_a);
    }
    let rasterizer = samples::PORTS.events.of(&mut m, config, rasterizer);
    let accumulator = sums::PORTS.events.of(&mut m, config, accumulator);
    let hidden = occlusion.map_or_else(Expr::default, |tests| units::occlusion::PORTS.hidden.word_of(&mut m, tests));
    PORTS.events.drive(&mut m, config, LaneEvents { rasterizer, accumulator, hidden });
    Ok(Lane { module: m, manifests })
}
