//! The whole core: splats in, fragments out, reconstruction buffer behind a memory port; golden twin:
//! `pointcore_golden::splat::top`.

mod lanes;

use super::arbiter::Client;
use super::{merge, motion_setup, normalizer, setup, splitter, transform};
use crate::compiler::{CompileError, Datapath, Manifest, Options};
use crate::units::ports::{InputPorts, OutputPorts, PulseInPorts, StreamInPorts, StreamOutPorts, WordPort, held, pipe};
use crate::units::wires::{Bundle, Wires};
use lanes::{Lanes, Port, sum};
use pointcore_contract::fields;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{UNIFORM_ADDRESS_BITS, Uniforms};
use pointcore_contract::splat::units::top::PORTS;
use pointcore_contract::splat::units::{self, lane};
use rtl::{Expr, Instance, Module, cat, lit};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The core's module and what the compiler decided about its datapaths.
pub struct Core {
    /// The top module, `splat_top`.
    pub module: Module,
    /// By unit.
    pub manifests: BTreeMap<String, Manifest>,
}

/// The units as instances, in the order of the data's way.
struct Instances {
    transform: Instance,
    setup: Instance,
    splitter: Instance,
    lanes: Lanes,
    /// One for each port to memory.
    normalizers: Vec<Instance>,
    /// What tests their fragments, likewise, if anything does.
    merges: Vec<Instance>,
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
    let set_up = if config.has_motion() { motion_setup::datapath } else { setup::datapath };
    let instances = Instances {
        transform: datapath(m, "transform", transform::datapath(config, options)?),
        setup: datapath(m, "setup", set_up(config, options)?),
        splitter: m.instance("splitter", splitter::module(config)),
        lanes: Lanes::place(m, config, options)?,
        normalizers: normalizers(m, config, normalizer::datapath(config, options)?, &mut manifests),
        merges: merges(m, config),
    };
    manifests.extend(instances.lanes.manifests.clone());
    Ok((instances, manifests))
}

/// A normalizer for each port to memory, the first without a number.
fn normalizers(
    m: &mut Module,
    config: &Config,
    datapath: Datapath,
    manifests: &mut BTreeMap<String, Manifest>,
) -> Vec<Instance> {
    const NAME: &str = "normalizer";
    manifests.insert(NAME.to_owned(), datapath.manifest);
    let module = Rc::new(datapath.module);
    (0..config.memory_ports as usize).map(|port| m.instance(&numbered(NAME, port), module.clone())).collect()
}

/// What tests fragments against depths in memory, one for each port to memory.
fn merges(m: &mut Module, config: &Config) -> Vec<Instance> {
    let module = config.tests_fragments().then(|| Rc::new(merge::module(config)));
    let place = |(port, module): (usize, Rc<Module>)| m.instance(&numbered("merge", port), module);
    module.into_iter().cycle().take(config.memory_ports as usize).enumerate().map(place).collect()
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
    let Instances { transform, setup, ref lanes, .. } = *instances;
    units::transform::PORTS.model_view.feed(m, config, transform, uniforms.model_view);
    units::transform::PORTS.near_plane.feed_word(m, transform, uniforms.near_plane);
    if config.has_motion() {
        constants_of_motion(m, config, instances, uniforms);
        return;
    }
    units::setup::PORTS.viewport.feed(m, config, setup, uniforms.viewport);
    units::setup::PORTS.epsilon.feed(m, config, setup, uniforms.epsilon);
    if config.eye_plane.is_on() {
        units::setup::PORTS.near_plane.feed_word(m, setup, uniforms.near_plane);
    }
    if config.screen_filter.is_on() {
        units::setup::PORTS.filter_radius.feed_word(m, setup, uniforms.filter_radius);
        lanes.filter_scale(m, uniforms.filter_scale);
    }
}

/// Connects those that know of motion, where splats may move.
fn constants_of_motion(m: &mut Module, config: &Config, instances: &Instances, uniforms: &Uniforms<Wires>) {
    let Instances { setup, ref lanes, ref normalizers, .. } = *instances;
    units::motion_setup::PORTS.viewport.feed(m, config, setup, uniforms.viewport);
    units::motion_setup::PORTS.epsilon.feed(m, config, setup, uniforms.epsilon);
    units::motion_setup::PORTS.near_plane.feed_word(m, setup, uniforms.near_plane);
    for &normalizer in normalizers {
        units::normalizer::PORTS.shutter.feed(m, config, normalizer, uniforms.shutter);
    }
    lanes.depth_a(m, uniforms.viewport.depth_a);
}

/// Leads splats through the units, from one to the next.
fn chain(m: &mut Module, config: &Config, instances: &Instances) {
    let Instances { transform, setup, splitter, ref lanes, .. } = *instances;
    let splat = PORTS.splat.declare(m, config);
    units::transform::PORTS.input.feed(m, config, transform, splat);
    let (input, output) = if config.has_motion() {
        (units::motion_setup::PORTS.input, units::motion_setup::PORTS.out)
    } else {
        (units::setup::PORTS.input, units::setup::PORTS.out)
    };
    pipe(m, config, (transform, units::transform::PORTS.out), (setup, input));
    let set_up = output.of(m, config, setup);
    PORTS.frame_set_up.event(m, set_up.transfer() & set_up.record.end);
    units::splitter::PORTS.input.feed(m, config, splitter, set_up);
    pipe(m, config, (splitter, units::splitter::PORTS.out), (lanes.root, lane::PORTS.input));
}

/// Connects the lanes to the reconstruction buffer, and leads finished pixels out as fragments; ports come in the contract's order.
fn pixels(m: &mut Module, config: &Config, instances: &Instances) {
    let lanes = &instances.lanes;
    let clients = || lanes.ports.iter().map(|port| port.memory);
    for (port, Client { instance, read, .. }) in PORTS.read.iter().zip(clients()) {
        let read = read.of(m, config, instance);
        port.export(m, config, read);
    }
    for (port, Client { instance, data, .. }) in PORTS.data.iter().zip(clients()) {
        let pixels = port.declare(m, config);
        data.feed(m, config, instance, pixels);
    }
    for (port, Client { instance, write, .. }) in PORTS.write.iter().zip(clients()) {
        let write = write.of(m, config, instance);
        port.export(m, config, write);
    }
    let (mut ends, mut fragments) = (vec![], vec![]);
    for (&Port { pixel: (source, pixel), .. }, &normalizer) in lanes.ports.iter().zip(&instances.normalizers) {
        let pixel = pixel.of(m, config, source);
        ends.push(pixel.transfer() & pixel.record.end);
        units::normalizer::PORTS.input.feed(m, config, normalizer, pixel);
        fragments.push((normalizer, units::normalizer::PORTS.out));
    }
    if config.tests_fragments() {
        for (fragment, &merge) in fragments.iter_mut().zip(&instances.merges) {
            pipe(m, config, *fragment, (merge, units::merge::PORTS.input));
            *fragment = (merge, units::merge::PORTS.out);
        }
    }
    for (port, (source, out)) in PORTS.fragment.iter().zip(fragments) {
        let fragment = out.of(m, config, source);
        port.export(m, config, fragment);
    }
    if config.rasterizers > 1 {
        frame_sent(m, lanes, &ends);
    }
}

/// Connects the lanes to the memory of payloads, each by a port of its own.
fn payloads(m: &mut Module, config: &Config, lanes: &Lanes) {
    let lanes = || lanes.each().take(config.payload_ports() as usize);
    for (port, lane) in PORTS.payload_read.iter().zip(lanes()) {
        let read = lane::PORTS.payload_read.of(m, config, lane);
        port.export(m, config, read);
    }
    for (port, lane) in PORTS.payload_data.iter().zip(lanes()) {
        let data = port.declare(m, config);
        lane::PORTS.payload_data.feed(m, config, lane, data);
    }
    for (port, lane) in PORTS.payload_write.iter().zip(lanes()) {
        let write = lane::PORTS.payload_write.of(m, config, lane);
        port.export(m, config, write);
    }
}

/// Connects what tests fragments to depths in memory; returns how many fragments something hid in the last cycle.
fn depths(m: &mut Module, config: &Config, merges: &[Instance]) -> Expr {
    use units::merge::PORTS as TESTS;
    for (port, &merge) in PORTS.depth_read.iter().zip(merges) {
        let read = TESTS.depth_read.of(m, config, merge);
        port.export(m, config, read);
    }
    for (port, &merge) in PORTS.depth_data.iter().zip(merges) {
        let data = port.declare(m, config);
        TESTS.depth_data.feed(m, config, merge, data);
    }
    for (port, &merge) in PORTS.depth_write.iter().zip(merges) {
        let write = TESTS.depth_write.of(m, config, merge);
        port.export(m, config, write);
    }
    let hidden: Vec<_> = merges.iter().map(|&merge| TESTS.hidden.word_of(m, merge)).collect();
    sum(config.merge_count_bits(), hidden.into_iter())
}

/// Connects the lanes to depths in memory, each by a port of its own.
fn depths_of_samples(m: &mut Module, config: &Config, lanes: &Lanes) {
    for (port, lane) in PORTS.depth_read.iter().zip(lanes.each()) {
        let read = lane::PORTS.depth_read.of(m, config, lane);
        port.export(m, config, read);
    }
    for (port, lane) in PORTS.depth_data.iter().zip(lanes.each()) {
        let data = port.declare(m, config);
        lane::PORTS.depth_data.feed(m, config, lane, data);
    }
}

/// Tells the lanes once the end of a frame has left all ports, of which each says so in one cycle.
fn frame_sent(m: &mut Module, lanes: &Lanes, ends: &[Expr]) {
    let frame_leaves = if let [only] = ends {
        *only
    } else {
        let have_ended: Vec<_> = (0..ends.len()).map(|port| m.reg_reset(&numbered("has_ended", port), 1, 0)).collect();
        let ended: Vec<_> = have_ended.iter().zip(ends).map(|(&has_ended, &ends)| has_ended | ends).collect();
        let all = m.wire("frame_leaves", cat(ended.iter().copied()).all());
        have_ended.into_iter().zip(ended).for_each(|(has_ended, ended)| m.next(has_ended, ended & !all));
        all
    };
    let sent = m.reg_reset("frame_sent", 1, 0);
    m.next(sent, frame_leaves);
    lanes.frame_sent(m, sent.expr());
}

/// The name of a port's part: the first has no number.
fn numbered(name: &str, port: usize) -> String {
    if port == 0 { name.to_owned() } else { format!("{name}_{port}") }
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
    pixels(&mut m, config, &instances);
    payloads(&mut m, config, &instances.lanes);
    let mut events = instances.lanes.events(&mut m, config);
    if config.tests_fragments() {
        events.hidden = depths(&mut m, config, &instances.merges);
    } else if config.tests_samples() {
        depths_of_samples(&mut m, config, &instances.lanes);
    }
    PORTS.events.drive(&mut m, config, events);
    Ok(Core { module: m, manifests })
}
