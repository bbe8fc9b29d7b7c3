//! The renderer of surface splats. `docs/splat.md` and its pages state what every unit does in every cycle; each file names the
//! thesis section it implements.

pub mod accumulator;
pub mod arbiter;
pub mod collector;
pub mod depth_test;
pub mod distributor;
pub mod fragment_collector;
pub mod heap;
pub mod lane;
pub mod lists;
pub mod merge;
pub mod motion_evaluation;
pub mod motion_setup;
pub mod normalizer;
pub mod occlusion;
pub mod payloads;
pub mod prefetch;
pub mod rasterizer;
pub mod reorder;
pub mod setup;
pub mod splitter;
pub mod tile_cache;
pub mod top;
pub mod transform;
pub mod weighting;

pub(crate) mod parts;

use crate::compiler::{CompileError, Options};
use pointcore_contract::Unit;
use pointcore_contract::splat::{Config, units};
use rtl::Module;

/// Describes a unit's hardware in a configuration.
pub type Describe = fn(&Config) -> Result<Module, CompileError>;

/// Every unit of the renderer and its hardware, the core itself last. Those of motion stand beside it.
pub const UNITS: [(&Unit<Config>, Describe); 24] = [
    (&units::transform::UNIT, |config| Ok(transform::datapath(config, &Options::default())?.module)),
    (&units::setup::UNIT, |config| Ok(setup::datapath(config, &Options::default())?.module)),
    (&units::splitter::UNIT, |config| Ok(splitter::module(config))),
    (&units::distributor::UNIT, |config| Ok(distributor::module(config, 0))),
    (&units::payloads::UNIT, |config| Ok(payloads::module(config))),
    (&units::heap::UNIT, |config| Ok(heap::module(config))),
    (&units::lists::UNIT, |config| Ok(lists::module(config))),
    (&units::reorder::UNIT, |config| Ok(reorder::module(config))),
    (&units::prefetch::UNIT, |config| Ok(prefetch::module(config))),
    (&units::tile_cache::UNIT, |config| Ok(tile_cache::module(config))),
    (&units::rasterizer::UNIT, |config| Ok(rasterizer::datapath(config, &Options::default())?.module)),
    (&units::occlusion::UNIT, |config| Ok(occlusion::module(config))),
    (&units::weighting::UNIT, |config| Ok(weighting::datapath(config, &Options::default())?.module)),
    (&units::depth_test::UNIT, |config| Ok(depth_test::module(config))),
    (&units::accumulator::UNIT, |config| Ok(accumulator::module(config))),
    (&units::lane::UNIT, |config| Ok(lane::lane(config, &Options::default())?.module)),
    (&units::arbiter::UNIT, |config| Ok(arbiter::module(config))),
    (&units::collector::UNIT, |config| Ok(collector::module(config))),
    (&units::normalizer::UNIT, |config| Ok(normalizer::datapath(config, &Options::default())?.module)),
    (&units::merge::UNIT, |config| Ok(merge::module(config))),
    (&units::fragment_collector::UNIT, |config| Ok(fragment_collector::module(config))),
    (&units::motion_setup::UNIT, |config| Ok(motion_setup::datapath(config, &Options::default())?.module)),
    (&units::motion_evaluation::UNIT, |config| Ok(motion_evaluation::datapath(config, &Options::default())?.module)),
    (&units::top::UNIT, |config| Ok(top::core(config, &Options::default())?.module)),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::testing::{check, check_in_order};
    use pointcore_contract::splat::{AttributeFormat, Coefficient, Division, Feature, Fraction, RasterFormat};
    use pointcore_contract::{Format, FragmentDepth};

    fn described(describe: Describe, config: &Config) -> Module {
        describe(config).unwrap_or_else(|error| panic!("{error}"))
    }

    #[test]
    fn every_unit_of_the_contract_is_described_under_its_name() {
        let specified = units::UNITS.map(|unit| unit.module);
        assert_eq!(UNITS.map(|(unit, _)| unit.module), specified);
        let name = |(unit, describe): (&Unit<Config>, Describe)| {
            let config = if unit.module.contains("motion") { moving() } else { Config::default() };
            described(describe, &config).unit().to_owned()
        };
        assert_eq!(UNITS.map(name), specified);
    }

    fn moving() -> Config {
        Config { time_bins: 4, screen_filter: Feature::Off, ..Config::default() }
    }

    #[test]
    fn units_have_the_specified_ports() {
        let small = Config {
            heap_levels: 2,
            tile_slots: 5,
            cardinal: 2,
            width: 8,
            culling: Feature::Off,
            screen_filter: Feature::Off,
            eye_plane: Feature::Off,
            ..Config::default()
        };
        let fixed = Config { attribute: AttributeFormat::Fixed(Fraction::Twelve), ..small.clone() };
        let coarse = Config {
            geometry: Format::F24,
            rasterizer: Some(Format::BF16.flushed().into()),
            division: Division::Newton,
            kernel_fraction_bits: 0,
            depth: FragmentDepth::Plane,
            ..Config::default()
        };
        let integers = Config { rasterizer: Some(RasterFormat::Fixed(Coefficient::Sixteen)), ..Config::default() };
        let one_bin = Config { time_bins: 1, cardinal: 1, ..moving() };
        for config in [Config::default(), small, fixed, coarse, integers, moving(), one_bin] {
            let left_out = if config.has_motion() { ["splat_setup", "splat_merge"] } else { ["splat_motion_"; 2] };
            let is_there = |unit: &Unit<Config>| !left_out.iter().any(|name| unit.module.starts_with(name));
            for (unit, describe) in UNITS.into_iter().filter(|(unit, _)| is_there(unit)) {
                check(&described(describe, &config), unit.ports(&config));
            }
        }
    }

    #[test]
    fn the_core_has_the_specified_ports_in_order() {
        let config = Config { cardinal: 1, ..Config::default() };
        let several = Config { rasterizers: 4, memory_ports: 2, ..Config::default() };
        let (core, describe) = UNITS[UNITS.len() - 1];
        let merging = Config { merge: Feature::On, ..several.clone() };
        for config in [config, several, moving(), merging] {
            check_in_order(&described(describe, &config), &core.ports(&config));
        }
    }
}
