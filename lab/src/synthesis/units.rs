//! What can be synthesized by name: every operator, and the cores, all their units and those of their bus at the configurations `ecp5`, `knn` and `points`.

use pointcore::configuration::{Configuration, ecp5, knn, points};
use pointcore::generated::GenerateError;
use pointcore::package::place_and_route::Crowding;
use pointcore_contract::{
    Fixed, Format, Signedness, Unit, process as process_spec, search as search_spec, splat as splat_spec,
};
use pointcore_hdl::compiler::CompileError;
use pointcore_hdl::float::{self, Operator};
use pointcore_hdl::{process, search, splat};
use rtl::Module;
use std::rc::Rc;

/// The fixed-point format of the conversions: pixels with subpixel positions.
const FIXED: Fixed = Fixed { width: 24, fraction: 8, signed: Signedness::Signed };
/// Lines of the caches that `knn` leaves out.
const TREE_CACHE: u32 = 4096;
const NEIGHBOR_CACHE: u32 = 8;
/// Levels, cycles of an operation, and image of the heaps that stand beside the core's own, by name.
///
/// Arrival numbers have a bit more than there are levels, so that the heap can be full; the tile index has the rest of the 16 bits
/// of a key as others measure it. The bit for the sweep comes on top.
const HEAPS: [(&str, u32, u32, [u32; 2]); 4] = [
    ("heap1023", 10, 2, [64, 32]),
    ("heap1023_4_cycles", 10, 4, [64, 32]),
    ("heap4095", 12, 2, [32, 16]),
    ("heap4095_4_cycles", 12, 4, [32, 16]),
];

type Build = Box<dyn Fn() -> Result<Rc<Module>, GenerateError> + Send + Sync>;

/// Whether something is a part of a core or the whole of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// A part.
    Unit,
    /// The whole.
    Core(Crowding),
}

/// Something to synthesize.
pub struct MeasuredUnit {
    /// What it is called on the command line and in tables.
    pub name: String,
    /// How much of a core it is.
    pub scope: Scope,
    build: Build,
}

impl MeasuredUnit {
    /// Describes the hardware.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn module(&self) -> Result<Rc<Module>, GenerateError> {
        (self.build)()
    }

    fn new<M: Into<Rc<Module>>>(
        name: impl Into<String>,
        build: impl Fn() -> Result<M, CompileError> + Send + Sync + 'static,
    ) -> Self {
        Self { name: name.into(), scope: Scope::Unit, build: Box::new(move || Ok(build()?.into())) }
    }

    /// The whole core of a configuration.
    #[must_use]
    pub fn core(name: impl Into<String>, configuration: Configuration) -> Self {
        let scope = Scope::Core(Crowding::of(&configuration));
        Self { name: name.into(), scope, build: Box::new(move || configuration.module()) }
    }
}

/// A name that stands for several units, and these.
pub type Group = (&'static str, fn() -> Vec<MeasuredUnit>);

/// The groups a name may stand for.
pub const GROUPS: &[Group] = &[
    ("operators", operators),
    ("splat_units", splat_units),
    ("search_units", search_units),
    ("process_units", process_units),
    ("bus_units", bus_units),
    ("heaps", heaps),
    ("cores", cores),
];

/// The operators that the cores rest on.
const STANDARD_OPERATORS: [&str; 13] = [
    "f32_add",
    "f32_ftz_mul",
    "f32_mul",
    "f24_mul",
    "f24_ftz_mul",
    "f32_fma",
    "f32_ftz_fma",
    "f32_div",
    "f32_recip_newton",
    "f32_recip",
    "f32_sqrt",
    "f32_rsqrt_newton",
    "f32_rsqrt",
];

/// What is measured where nothing is named: the operators that the cores rest on, every unit of the cores, heaps, whole cores.
#[must_use]
pub fn standard() -> Vec<MeasuredUnit> {
    let mut operators = operators();
    operators.retain(|unit| STANDARD_OPERATORS.contains(&unit.name.as_str()));
    operators.sort_by_key(|unit| STANDARD_OPERATORS.iter().position(|name| *name == unit.name));
    operators
        .into_iter()
        .chain(splat_units())
        .chain(search_units())
        .chain(process_units())
        .chain(bus_units())
        .chain(heaps())
        .chain(cores())
        .collect()
}

/// Every unit known by name.
#[must_use]
pub fn all() -> Vec<MeasuredUnit> {
    GROUPS.iter().flat_map(|(_, units)| units()).collect()
}

/// The names that stand for units, for a message.
#[must_use]
pub fn known() -> String {
    let formats = formats().map(name).collect::<Vec<_>>().join(", ");
    let operators = OPERATORS.map(|(name, ..)| name).join(", ");
    let others = splat_units()
        .into_iter()
        .chain(search_units())
        .chain(process_units())
        .chain(bus_units())
        .chain(heaps())
        .chain(cores());
    let others = others.map(|unit| unit.name).collect::<Vec<_>>().join(", ");
    let groups = GROUPS.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
    format!(
        "FORMAT_OPERATOR, where FORMAT is {formats} and OPERATOR is {operators}; {others}; one of the groups {groups}; \
         or a configuration file NAME.toml"
    )
}

/// All formats with and without subnormals.
fn formats() -> impl Iterator<Item = Format> {
    Format::NAMED.into_iter().flat_map(|(_, format)| [format, format.flushed()])
}

/// A format's name as part of a unit's.
fn name(format: Format) -> String {
    format.to_string().replace('-', "_")
}

type OperatorKind = (&'static str, fn(Format) -> u32, fn(Format, u32) -> Operator);

/// The operators on numbers of one format.
const OPERATORS: [OperatorKind; 14] = [
    ("add", float::add::stages, float::add::module),
    ("mul", float::mul::stages, float::mul::module),
    ("fma", float::fma::stages, float::fma::module),
    ("div", float::div::stages, float::div::module),
    ("recip", float::div::stages, float::div::recip),
    ("recip_newton", float::recip_newton::stages, float::recip_newton::module),
    ("sqrt", float::sqrt::stages, float::sqrt::module),
    ("rsqrt", float::rsqrt::stages, float::rsqrt::module),
    ("rsqrt_newton", float::rsqrt_newton::stages, float::rsqrt_newton::module),
    ("min", float::minmax::stages, float::minmax::min),
    ("lt", float::compare::stages, float::compare::lt),
    ("eq", float::compare::stages, float::compare::eq),
    ("to_fixed", |f| float::to_fixed::stages(f, FIXED), |f, stages| float::to_fixed::module(f, FIXED, stages)),
    ("from_fixed", |f| float::from_fixed::stages(f, FIXED), |f, stages| float::from_fixed::module(f, FIXED, stages)),
];

/// Every operator of every format with its default number of pipeline stages, e.g. `f32_ftz_mul`.
fn operators() -> Vec<MeasuredUnit> {
    let unit = |format: Format, (operator, stages, module): OperatorKind| {
        MeasuredUnit::new(format!("{}_{operator}", name(format)), move || Ok(module(format, stages(format)).module))
    };
    formats().flat_map(|format| OPERATORS.map(|kind| unit(format, kind))).collect()
}

/// Every unit of the renderer, at `ecp5`, but for those of which there is nothing but other units; those between lanes, and those of splats that move, too.
fn splat_units() -> Vec<MeasuredUnit> {
    use splat_spec::config::PayloadStore;
    use splat_spec::units::{lane, top};
    let is_measured = |unit: &Unit<splat_spec::Config>| ![lane::UNIT.module, top::UNIT.module].contains(&unit.module);
    let units = splat::UNITS.into_iter().filter(|(unit, _)| is_measured(unit));
    let measured = units.map(|(unit, describe)| {
        MeasuredUnit::new(unit.module, move || {
            let with = |change: fn(&mut splat_spec::Config)| {
                let mut config = ecp5();
                change(&mut config);
                config
            };
            let several = with(|config| config.rasterizers = 2);
            let ports = with(|config| (config.rasterizers, config.memory_ports) = (2, 2));
            let in_memory = with(|config| config.payload = PayloadStore::Memory);
            let merging = with(|config| config.merge = splat_spec::Feature::On);
            let moving = with(|config| {
                (config.time_bins, config.kernel_index_bits, config.screen_filter) = (4, 10, splat_spec::Feature::Off)
            });
            let hiding = splat_spec::Config { merge: splat_spec::Feature::On, ..moving.clone() };
            let configurations = [ecp5(), several, ports, in_memory, merging, moving, hiding];
            let described = configurations.into_iter().find(|config| (unit.is_present)(config));
            describe(&described.expect("one of them has it"))
        })
    });
    measured.collect()
}

/// Every unit of the search core, at `knn`; the two caches that it leaves out, too.
fn search_units() -> Vec<MeasuredUnit> {
    let of_core = |unit: &Unit<search_spec::Config>| unit.module != search_spec::units::top::UNIT.module;
    let units = search::UNITS.into_iter().filter(|(unit, _)| of_core(unit));
    let measured = units.map(|(unit, describe)| {
        MeasuredUnit::new(unit.module, move || {
            let caches = search_spec::Config { tree_cache: TREE_CACHE, neighbor_cache: NEIGHBOR_CACHE, ..knn() };
            describe(&if (unit.is_present)(&knn()) { knn() } else { caches })
        })
    });
    measured.collect()
}

/// Every unit of the process core, at `points`, and the whole of it.
fn process_units() -> Vec<MeasuredUnit> {
    // Those of which there is nothing but other units.
    let is_measured = |unit: &Unit<process_spec::Config>| unit.module != process_spec::stages::threads::UNIT.module;
    let units = process::UNITS.into_iter().filter(|(unit, _)| is_measured(unit));
    units.map(|(unit, describe)| MeasuredUnit::new(unit.module, move || describe(&points().process))).collect()
}

/// Every unit between a core and AXI, the packets and points of the search core, the pixels of the renderer.
fn bus_units() -> Vec<MeasuredUnit> {
    use pointcore_contract::bus::registers::SearchRegisters;
    use pointcore_contract::bus::units::{beats_max, window_index_bits};
    use pointcore_hdl::bus::{packet_in, packet_out, reader, registers, search, window, writer};
    use search_spec::records::{CachedQuery, CachedResult, Points};
    use splat_spec::records::Pixel;
    type Config = search_spec::Config;
    let unit = |name: &str, module: fn(&Config) -> Module| {
        MeasuredUnit::new(format!("bus_{name}"), move || Ok(module(&knn())))
    };
    vec![
        unit("packet_in", |config| packet_in::module::<CachedQuery>(config, config.bus.stream_bits)),
        unit("packet_out", |config| packet_out::module::<CachedResult>(config, config.bus.stream_bits)),
        unit("reader", |config| reader::module::<Points>(config, config.bus.memory_bits, beats_max(config))),
        unit("writer", |config| writer::module::<Pixel>(&ecp5(), config.bus.memory_bits)),
        unit("window", |config| window::module(window_index_bits(config))),
        unit("registers", |config| registers::module::<SearchRegisters>(config, search::error_sources(config))),
    ]
}

/// The cores as a whole.
fn cores() -> Vec<MeasuredUnit> {
    vec![
        MeasuredUnit::core("splat", Configuration::Splat(ecp5())),
        MeasuredUnit::core("search", Configuration::Search(knn())),
        MeasuredUnit::core("points", Configuration::Points(points())),
    ]
}

/// Heaps of the sizes that others report.
fn heaps() -> Vec<MeasuredUnit> {
    let unit = |(name, heap_levels, heap_interval, [width, height]): (_, u32, _, [u32; 2])| {
        let config = splat_spec::Config { heap_levels, heap_interval, width, height, ..Default::default() };
        MeasuredUnit::new(name, move || Ok(splat::heap::numbered(&config, heap_levels + 1)))
    };
    HEAPS.map(unit).into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn every_unit_is_in_the_configuration_that_it_is_measured_in() {
        for unit in [splat_units(), search_units(), process_units(), bus_units()].into_iter().flatten() {
            let module = unit.module().unwrap_or_else(|error| panic!("{}: {error}", unit.name));
            assert!(unit.name.starts_with("bus_") || module.unit() == unit.name, "{}: {}", unit.name, module.unit());
        }
    }

    #[test]
    fn heaps_have_keys_of_16_bits() {
        for (name, heap_levels, _, [width, height]) in HEAPS {
            let config = splat_spec::Config { width, height, ..Default::default() };
            assert_eq!(config.tile_bits() + heap_levels + 1, 16, "{name}");
        }
    }

    #[test]
    fn names_are_unique_and_the_standard_ones_known() {
        let names: Vec<_> = all().into_iter().map(|unit| unit.name).collect();
        let distinct: HashSet<_> =
            names.iter().cloned().chain(GROUPS.iter().map(|(name, _)| (*name).to_owned())).collect();
        assert_eq!(distinct.len(), names.len() + GROUPS.len());
        let standard = standard();
        assert!(STANDARD_OPERATORS.iter().all(|name| standard.iter().any(|unit| unit.name == *name)));
        assert!(standard.iter().all(|unit| distinct.contains(&unit.name)));
    }
}
