//! The processing module (thesis 6.5.4): programs as data paths, and the units that lead queries through them.

pub mod bank;
pub mod control;
pub mod gatherer;
pub mod kernel;
pub mod output;
mod partial_sums;
pub mod program;
pub mod stage;
pub mod threads;
pub mod top;

use pointcore_contract::Unit;
use pointcore_contract::process::{Config, stages, units};

use crate::compiler::{CompileError, Options};
use rtl::Module;

/// A unit and its hardware, with the compiler's default options.
pub type Described = (&'static Unit<Config>, fn(&Config) -> Result<Module, CompileError>);

/// Every unit of the process core, the core itself last.
pub const UNITS: [Described; 9] = [
    (&stages::control::UNIT, |config| Ok(control::module(config))),
    (&stages::bank::UNIT, |config| Ok(bank::module(config))),
    (&stages::init::UNIT, |config| Ok(stage::init(config, &Options::default())?.module)),
    (&stages::finish::UNIT, |config| Ok(stage::finish(config, &Options::default())?.module)),
    (&stages::output::UNIT, |config| Ok(output::module(config))),
    (&stages::threads::UNIT, |config| Ok(threads::core(config, &Options::default())?.module)),
    (&units::gatherer::UNIT, |config| Ok(gatherer::module(config))),
    (&units::kernel::UNIT, |config| Ok(kernel::unit(config, &Options::default())?.module)),
    (&stages::top::UNIT, |config| Ok(top::core(config, &Options::default())?.module)),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::testing::check;
    use pointcore_contract::Format;
    use pointcore_contract::process::Program;
    use pointcore_contract::process::library::{PROGRAMS, program};
    use std::sync::Arc;

    /// Looks at the farthest neighbor, stores under conditions, and reads all that there is.
    const FARTHEST: &str = include_str!("../../../tb/tests/process/farthest.pasm");

    fn config(program: Program, threads: u32) -> Config {
        Config {
            program: Arc::new(program),
            format: Format::F32.flushed(),
            index_bits: 12,
            neighbors: threads.min(64),
            threads,
            rate: 1,
            line_points: 4,
            cache_lines: 16,
        }
    }

    #[test]
    fn every_unit_is_listed() {
        assert!(UNITS.iter().map(|(unit, _)| unit.module).eq(stages::UNITS.iter().map(|unit| unit.module)));
    }

    #[test]
    fn units_have_the_specified_ports() {
        let farthest = Program::parse("farthest.pasm", FARTHEST).unwrap_or_else(|error| panic!("{error}"));
        let library = PROGRAMS.iter().zip([1, 2, 3, 16, 128].into_iter().cycle());
        let library = library.map(|((name, _), threads)| config(program(name), threads));
        for config in library.chain([config(farthest, 5)]) {
            for (unit, describe) in UNITS.iter().filter(|(unit, _)| (unit.is_present)(&config)) {
                let module = describe(&config).unwrap_or_else(|error| panic!("{}: {error}", unit.module));
                assert_eq!(module.unit(), unit.module);
                check(&module, unit.ports(&config));
            }
        }
    }
}
