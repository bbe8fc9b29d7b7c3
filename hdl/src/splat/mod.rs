//! The renderer of surface splats. `docs/splat.md` and its pages state what every unit does in every cycle; each file names the
//! thesis section it implements.

pub mod accumulator;
pub mod depth_test;
pub mod heap;
pub mod normalizer;
pub mod rasterizer;
pub mod reorder;
pub mod setup;
pub mod splitter;
pub mod tile_cache;
pub mod top;
pub mod transform;
pub mod weighting;

mod parts;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiler::{CompileError, Datapath, Options};
    use crate::units::testing::{check, check_in_order};
    use pointcore_contract::splat::{
        AttributeFormat, Coefficient, Config, Division, Feature, Fraction, Port, RasterFormat, ports,
    };
    use pointcore_contract::{Format, FragmentDepth};
    use rtl::Module;

    type Unit = (fn(&Config) -> Module, fn(&Config) -> Vec<Port>);

    const CONTROL_UNITS: [Unit; 6] = [
        (splitter::module, ports::splitter),
        (heap::module, ports::heap),
        (reorder::module, ports::reorder),
        (tile_cache::module, ports::tile_cache),
        (depth_test::module, ports::depth_test),
        (accumulator::module, ports::accumulator),
    ];

    type Compiled = (fn(&Config, &Options) -> Result<Datapath, CompileError>, fn(&Config) -> Vec<Port>);

    const DATAPATHS: [Compiled; 5] = [
        (transform::datapath, ports::transform),
        (setup::datapath, ports::setup),
        (rasterizer::datapath, ports::rasterizer),
        (weighting::datapath, ports::weighting),
        (normalizer::datapath, ports::normalizer),
    ];

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
        for config in [Config::default(), small, fixed, coarse, integers] {
            for (module, ports) in CONTROL_UNITS {
                check(&module(&config), ports(&config));
            }
            for (datapath, ports) in DATAPATHS {
                let datapath = datapath(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
                check(&datapath.module, ports(&config));
            }
        }
    }

    #[test]
    fn the_core_has_the_specified_ports_in_order() {
        let config = Config { cardinal: 1, ..Config::default() };
        let core = top::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        check_in_order(&core.module, &ports::top(&config));
    }
}
