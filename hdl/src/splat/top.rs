//! The whole core: splats in, fragments out, reconstruction buffer behind a memory port; golden twin:
//! `pointcore_golden::splat::top`.

use super::{accumulator, normalizer, rasterizer, reorder, setup, splitter, tile_cache, transform, weighting};
use crate::compiler::{CompileError, Datapath, Manifest, Options};
use crate::units::ports::{
    InputPorts, OutputPorts, PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort, held,
};
use crate::units::wires::{Bundle, Wires};
use pointcore_contract::fields;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{UNIFORM_ADDRESS_BITS, Uniforms};
use pointcore_contract::splat::units::top::PORTS;
use pointcore_contract::splat::units::{self, Events};
use rtl::{Instance, Module, lit};
use std::collections::BTreeMap;

/// The core's module and what the compiler decided about its datapaths.
pub struct Core {
    /// The top module, `splat_top`.
    pub module: Module,
    /// By unit.
    pub manifests: BTreeMap<String, Manifest>,
}

/// The units as instances, in the order of the data's way.
#[derive(Clone, Copy)]
struct Instances {
    transform: Instance,
    setup: Instance,
    splitter: Instance,
    reorder: Instance,
    tile_cache: Instance,
    rasterizer: Instance,
    weighting: Instance,
    accumulator: Instance,
    normalizer: Instance,
}

/// Places the compiled units and collects their manifests.
fn place(
    m: &mut Module,
    config: &Config,
    options: &Options,
) -> Result<(Instances, BTreeMap<String, Manifest>), CompileError> {
    let mut manifests = BTreeMap::new();
    let mut datapath = |m: &mut Module, name: &str, datapath: Datapath| {
        manifests.insert(name.to_owned(), datapath.manifest);
        m.instance(name, datapath.module)
    };
    let instances = Instances {
        transform: datapath(m, "transform", transform::datapath(config, options)?),
        setup: datapath(m, "setup", setup::datapath(config, options)?),
        splitter: m.instance("splitter", splitter::module(config)),
        reorder: m.instance("reorder", reorder::module(config)),
        tile_cache: m.instance("tile_cache", tile_cache::module(config)),
        rasterizer: datapath(m, "rasterizer", rasterizer::datapath(config, options)?),
        weighting: datapath(m, "weighting", weighting::datapath(config, options)?),
        accumulator: m.instance("accumulator", accumulator::module(config)),
        normalizer: datapath(m, "normalizer", normalizer::datapath(config, options)?),
    };
    Ok((instances, manifests))
}

/// The uniform registers, written by address.
fn uniforms(m: &mut Module, config: &Config) -> Uniforms<Wires> {
    let write = PORTS.uniform.declare(m, config);
    let registers = fields::<Uniforms>(config).into_iter().zip(0..).map(|(field, address)| {
        let selected = write.record.address.eq(lit(UNIFORM_ADDRESS_BITS, address));
        held(m, &format!("uniform_{}", field.name), write.valid & selected, write.record.data.trunc(field.width))
    });
    Uniforms::from_values(config, registers.collect::<Vec<_>>())
}

/// Connects the units to the uniforms they read.
fn constants(m: &mut Module, config: &Config, instances: &Instances, uniforms: &Uniforms<Wires>) {
    let Instances { transform, setup, rasterizer, .. } = *instances;
    units::transform::PORTS.model_view.feed(m, config, transform, uniforms.model_view);
    units::transform::PORTS.near_plane.feed_word(m, transform, uniforms.near_plane);
    units::setup::PORTS.viewport.feed(m, config, setup, uniforms.viewport);
    units::setup::PORTS.epsilon.feed(m, config, setup, uniforms.epsilon);
    if config.eye_plane.is_on() {
        units::setup::PORTS.near_plane.feed_word(m, setup, uniforms.near_plane);
    }
    if config.screen_filter.is_on() {
        units::setup::PORTS.filter_radius.feed_word(m, setup, uniforms.filter_radius);
        units::rasterizer::PORTS.filter_scale.feed_word(m, rasterizer, uniforms.filter_scale);
    }
}

/// Leads splats through the units, from one to the next.
fn chain(m: &mut Module, config: &Config, instances: &Instances) {
    let Instances { transform, setup, splitter, reorder, tile_cache, rasterizer, weighting, accumulator, .. } =
        *instances;
    let splat = PORTS.splat.declare(m, config);
    units::transform::PORTS.input.feed(m, config, transform, splat);
    let splat = units::transform::PORTS.out.of(m, config, transform);
    units::setup::PORTS.input.feed(m, config, setup, splat);
    let splat = units::setup::PORTS.out.of(m, config, setup);
    units::splitter::PORTS.input.feed(m, config, splitter, splat);
    let copy = units::splitter::PORTS.out.of(m, config, splitter);
    units::reorder::PORTS.input.feed(m, config, reorder, copy);
    let copy = units::reorder::PORTS.out.of(m, config, reorder);
    units::tile_cache::PORTS.input.feed(m, config, tile_cache, copy);
    let copy = units::tile_cache::PORTS.out.of(m, config, tile_cache);
    units::rasterizer::PORTS.input.feed(m, config, rasterizer, copy);
    let sample = units::rasterizer::PORTS.out.of(m, config, rasterizer);
    units::weighting::PORTS.input.feed(m, config, weighting, sample);
    let sample = units::weighting::PORTS.out.of(m, config, weighting);
    units::accumulator::PORTS.input.feed(m, config, accumulator, sample);
}

/// Connects the tile cache to the slots in the accumulator.
fn slots(m: &mut Module, config: &Config, instances: &Instances) {
    use units::{accumulator, tile_cache};
    let (cache, slots) = (instances.tile_cache, instances.accumulator);
    let ready = tile_cache::PORTS.slot_ready.word_of(m, cache);
    accumulator::PORTS.slot_ready.feed_word(m, slots, ready);
    let fill = tile_cache::PORTS.fill.of(m, config, cache);
    accumulator::PORTS.fill.feed(m, config, slots, fill);
    let drain = tile_cache::PORTS.drain.of(m, config, cache);
    accumulator::PORTS.drain.feed(m, config, slots, drain);
    let drained = accumulator::PORTS.drained.of(m, config, slots);
    tile_cache::PORTS.drained.feed(m, config, cache, drained);
    let retire = accumulator::PORTS.retire.of(m, config, slots);
    tile_cache::PORTS.retire.feed(m, config, cache, retire);
    let frame_end = accumulator::PORTS.frame_end.word_of(m, slots);
    tile_cache::PORTS.frame_end.feed_word(m, cache, frame_end);
}

/// Connects the tile cache to the reconstruction buffer, and leads finished pixels out as fragments.
fn pixels(m: &mut Module, config: &Config, instances: &Instances) {
    let (cache, normalizer) = (instances.tile_cache, instances.normalizer);
    let read = units::tile_cache::PORTS.read.of(m, config, cache);
    PORTS.read.export(m, config, read);
    let data = PORTS.data.declare(m, config);
    units::tile_cache::PORTS.data.feed(m, config, cache, data);
    let write = units::tile_cache::PORTS.write.of(m, config, cache);
    PORTS.write.export(m, config, write);
    let pixel = units::tile_cache::PORTS.pixel.of(m, config, cache);
    units::normalizer::PORTS.input.feed(m, config, normalizer, pixel);
    let fragment = units::normalizer::PORTS.out.of(m, config, normalizer);
    PORTS.fragment.export(m, config, fragment);
}

/// Builds the core.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Core, CompileError> {
    let mut m = Module::new("splat_top", "Surface-splat renderer: splats in, normalized fragments out.");
    let (instances, manifests) = place(&mut m, config, options)?;
    let uniforms = uniforms(&mut m, config);
    constants(&mut m, config, &instances, &uniforms);
    chain(&mut m, config, &instances);
    slots(&mut m, config, &instances);
    pixels(&mut m, config, &instances);
    let rasterizer = units::rasterizer::PORTS.events.of(&mut m, config, instances.rasterizer);
    let accumulator = units::accumulator::PORTS.events.of(&mut m, config, instances.accumulator);
    PORTS.events.drive(&mut m, config, Events { rasterizer, accumulator });
    Ok(Core { module: m, manifests })
}
