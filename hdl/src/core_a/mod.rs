//! Core A, the surface-splat renderer. `docs/core_a.md` states what every unit does in every cycle; each file names the
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

mod datapath;
mod heap_level;
mod heap_order;
mod records;
mod tile_directory;

use crate::rtl::{Module, StreamIn};
use pointcore_spec::core_a::Field;

/// A record's fields with the widths the front end counts in.
fn layout(record: &[Field]) -> Vec<(&str, usize)> {
    record.iter().map(|(name, width)| (name.as_str(), *width as usize)).collect()
}

/// Declares the ports of a stream of records that comes in.
fn stream_in(m: &mut Module, name: &str, record: &[Field]) -> StreamIn {
    m.stream_in(name, &layout(record))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiler::{CompileError, Datapath, Options};
    use crate::rtl::{self, elaborate};
    use pointcore_spec::core_a::{Config, Direction, Feature, Port, ports};

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

    fn spec_port(port: &rtl::Port) -> Port {
        let direction = match port.direction {
            rtl::Direction::Input => Direction::Input,
            rtl::Direction::Output => Direction::Output,
        };
        Port { name: port.name.clone(), width: port.width as u32, direction }
    }

    /// Ports as specified, in any order since the harness finds them by name, and no path from input to output.
    fn check(module: &Module, mut specified: Vec<Port>) {
        let design = elaborate(module).unwrap_or_else(|error| panic!("{error}"));
        let mut found: Vec<_> = design.ports().iter().filter(|port| port.name != "clk").map(spec_port).collect();
        found.sort_by(|a, b| a.name.cmp(&b.name));
        specified.sort_by(|a, b| a.name.cmp(&b.name));
        assert_eq!(found, specified, "{}", module.unit());
        assert_eq!(design.combinational_paths(), [], "{}", module.unit());
    }

    #[test]
    fn units_have_the_specified_ports() {
        let small = Config {
            heap_levels: 2,
            sequence_bits: 2,
            tile_slots: 5,
            cardinal: 2,
            width: 8,
            culling: Feature::Off,
            screen_filter: Feature::Off,
            ..Config::default()
        };
        for config in [Config::default(), small] {
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
        let design = elaborate(&core.module).unwrap_or_else(|error| panic!("{error}"));
        let found: Vec<_> = design.ports().iter().filter(|port| port.name != "clk").map(spec_port).collect();
        assert_eq!(found, ports::top(&config));
        assert_eq!(design.combinational_paths(), []);
    }
}
