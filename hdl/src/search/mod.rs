//! The search core: nearest neighbors in a kd-tree. `docs/search.md` and its pages state what every unit does in every cycle;
//! each file names the thesis section it implements.

pub mod leaf;
pub mod neighbor_cache;
pub mod point_cache;
pub mod queue;
pub mod recursion;
pub mod sieve;
pub mod stack;
pub mod threads;
pub mod top;
pub mod traversal;
pub mod tree_cache;

pub(crate) mod parts;

use pointcore_contract::Unit;
use pointcore_contract::search::{Config, units};

use crate::compiler::{CompileError, Options};
use rtl::Module;

/// A unit and its hardware, with the compiler's default options.
pub type Described = (&'static Unit<Config>, fn(&Config) -> Result<Module, CompileError>);

/// Every unit of the search core, the core itself last.
pub const UNITS: [Described; 11] = [
    (&units::threads::UNIT, |config| Ok(threads::module(config))),
    (&units::traversal::UNIT, |config| Ok(traversal::datapath(config, &Options::default())?.module)),
    (&units::stack::UNIT, |config| Ok(stack::module(config))),
    (&units::recursion::UNIT, |config| Ok(recursion::module(config))),
    (&units::leaf::UNIT, |config| Ok(leaf::datapath(config, &Options::default())?.module)),
    (&units::sieve::UNIT, |config| Ok(sieve::module(config))),
    (&units::queue::UNIT, |config| Ok(queue::module(config))),
    (&units::point_cache::UNIT, |config| Ok(point_cache::module(config))),
    (&units::tree_cache::UNIT, |config| Ok(tree_cache::module(config))),
    (&units::neighbor_cache::UNIT, |config| Ok(neighbor_cache::unit(config, &Options::default())?.module)),
    (&units::top::UNIT, |config| Ok(top::core(config, &Options::default())?.module)),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::testing::{check, check_in_order};
    use pointcore_contract::Format;

    fn configs() -> [Config; 8] {
        let small =
            Config { threads: 1, neighbors: 1, tree_depth: 1, leaves_in_flight: 1, bucket: 1, ..Config::default() };
        let wide = Config { threads: 3, lanes: 4, index_bits: 4, geometry: Format::F24.flushed(), ..Config::default() };
        let bare = Config { point_cache: 0, ..small.clone() };
        let external = Config { tree_cache: 16, point_cache: 2, neighbor_cache: 3, ..wide.clone() };
        let single = Config { neighbor_cache: 1, ..small.clone() };
        let coherent = Config { neighbor_cache: 8, ..Config::default() };
        // More lines than records, more slots than leaves.
        let roomy = Config { tree_cache: 64, point_cache: 256, ..small.clone() };
        let no_points = Config { point_cache: 0, tree_cache: 4096, ..Config::default() };
        [Config::default(), no_points, wide, bare, external, roomy, single, coherent]
    }

    #[test]
    fn every_unit_is_listed() {
        assert!(UNITS.iter().map(|(unit, _)| unit.module).eq(units::UNITS.iter().map(|unit| unit.module)));
    }

    #[test]
    fn units_have_the_specified_ports() {
        for config in configs() {
            for (unit, describe) in UNITS.iter().filter(|(unit, _)| (unit.is_present)(&config)) {
                let module = describe(&config).unwrap_or_else(|error| panic!("{}: {error}", unit.module));
                assert_eq!(module.unit(), unit.module);
                check(&module, unit.ports(&config));
            }
        }
    }

    #[test]
    fn the_core_has_the_specified_ports_in_order() {
        for config in configs() {
            let core = top::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
            check_in_order(&core.module, &units::top::UNIT.ports(&config));
        }
    }
}
