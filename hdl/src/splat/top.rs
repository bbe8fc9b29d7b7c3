//! The whole core: splats in, fragments out, reconstruction buffer behind a memory port; golden twin:
//! `pointcore_golden::splat::top`.

use super::{accumulator, normalizer, rasterizer, reorder, setup, splitter, tile_cache, transform, weighting};
use crate::compiler::{CompileError, Datapath, Manifest, Options};
use crate::units::records::stream_in;
use pointcore_contract::splat::ports::{EVENTS, UNIFORM_ADDRESS_BITS, UNIFORMS};
use pointcore_contract::splat::{Config, Port, ports, records};
use rtl::{Expr, Instance, Module, lit};
use std::collections::BTreeMap;

/// The core's module and what the compiler decided about its datapaths.
pub struct Core {
    /// The top module, `splat_top`.
    pub module: Module,
    /// By unit.
    pub manifests: BTreeMap<String, Manifest>,
}

/// The units as instances, in the order of the data's way.
struct Units {
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
) -> Result<(Units, BTreeMap<String, Manifest>), CompileError> {
    let mut manifests = BTreeMap::new();
    let mut datapath = |m: &mut Module, name: &str, datapath: Datapath| {
        manifests.insert(name.to_owned(), datapath.manifest);
        m.instance(name, datapath.module)
    };
    let units = Units {
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
    Ok((units, manifests))
}

/// The uniform registers, written by address; connects every unit's input of a register's name.
fn uniforms(m: &mut Module, config: &Config, units: &[(Instance, Vec<Port>)]) {
    let layout = [("address", UNIFORM_ADDRESS_BITS), ("data", config.geometry.width())];
    let (valid, fields) = m.pulse_in("uniform", "valid", &layout);
    let [address, data] = [fields[0], fields[1]];
    for (index, name) in UNIFORMS.iter().enumerate() {
        let readers: Vec<_> = units.iter().filter(|(_, ports)| ports.iter().any(|port| port.name == *name)).collect();
        if readers.is_empty() {
            continue;
        }
        let width = config.uniform_format(name).width();
        let register = m.reg(&format!("uniform_{name}"), width);
        let selected = address.eq(lit(UNIFORM_ADDRESS_BITS, index as u128));
        m.next_if(register, valid & selected, data.trunc(width));
        for (unit, _) in readers {
            m.connect(*unit, name, register);
        }
    }
}

/// Connects outputs of one unit to inputs of the same name of another.
fn wire(m: &mut Module, from: Instance, to: Instance, names: impl IntoIterator<Item = String>) {
    for name in names {
        let value: Expr = m.out(from, &name);
        m.connect(to, &name, value);
    }
}

/// Connects the tile cache to the slots in the accumulator.
fn slots(m: &mut Module, config: &Config, units: &Units) {
    let fields =
        |prefix: &'static str| records::pixel(config).into_iter().map(move |(name, _)| format!("{prefix}_{name}"));
    let fill = ["slot_ready", "fill_valid", "fill_slot", "fill_pixel"].map(String::from);
    let address = ["drain_enable", "drain_slot", "drain_pixel"].map(String::from);
    let control = fill.into_iter().chain(fields("fill")).chain(address);
    wire(m, units.tile_cache, units.accumulator, control);
    let status = ["retire_valid", "retire_slot", "frame_end"].map(String::from);
    wire(m, units.accumulator, units.tile_cache, status.into_iter().chain(fields("drain")));
}

/// Builds the core.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Core, CompileError> {
    let mut m = Module::new("splat_top", "Surface-splat renderer: splats in, normalized fragments out.");
    let (units, manifests) = place(&mut m, config, options)?;
    let readers = [
        (units.transform, ports::transform(config)),
        (units.setup, ports::setup(config)),
        (units.rasterizer, ports::rasterizer(config)),
    ];
    uniforms(&mut m, config, &readers);

    let splat = stream_in(&mut m, "splat", &records::splat(config));
    m.stream_into(units.transform, "in", &splat);
    let Units { transform, setup, splitter, reorder, tile_cache, rasterizer, weighting, accumulator, .. } = units;
    let chain = [transform, setup, splitter, reorder, tile_cache, rasterizer, weighting, accumulator];
    for pair in chain.windows(2) {
        m.pipe((pair[0], "out"), (pair[1], "in"));
    }
    slots(&mut m, config, &units);

    let read = m.stream_from(units.tile_cache, "read");
    m.stream_export("read", &read);
    let data = stream_in(&mut m, "data", &records::pixel(config));
    m.stream_into(units.tile_cache, "data", &data);
    let write = m.stream_from(units.tile_cache, "write");
    m.stream_export("write", &write);
    m.pipe((units.tile_cache, "pixel"), (units.normalizer, "in"));
    let fragment = m.stream_from(units.normalizer, "out");
    m.stream_export("fragment", &fragment);

    let (rasterizer_events, accumulator_events) = EVENTS.split_at(3);
    for (unit, events) in [(units.rasterizer, rasterizer_events), (units.accumulator, accumulator_events)] {
        for name in events {
            let event = m.out(unit, name);
            m.output(name, event);
        }
    }
    Ok(Core { module: m, manifests })
}
