//! The blocks `init` and `final` as units, their thread beside what is computed; golden twin:
//! `pointcore_golden::process::stage`.

use crate::compiler::{CompileError, Datapath, Options, Program, Type};
use crate::process::program::{interval, lower};
use crate::units::datapath;
use pointcore_contract::process::config::Config;
use pointcore_contract::process::{Section, Source, stages};

/// The name of a thread's number at the ports.
const THREAD: &str = "thread";

/// `init`, which the program has.
///
/// # Errors
/// What the compiler rejects.
pub fn init(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = program(config, Section::Init, stages::init::UNIT.module, stages::init::UNIT.doc)?;
    datapath::unit(&stages::init::UNIT, config, &program, &paced(config, Section::Init, options))
}

/// `final`.
///
/// # Errors
/// What the compiler rejects.
pub fn finish(config: &Config, options: &Options) -> Result<Datapath, CompileError> {
    let program = program(config, Section::Final, stages::finish::UNIT.module, stages::finish::UNIT.doc)?;
    datapath::unit(&stages::finish::UNIT, config, &program, &paced(config, Section::Final, options))
}

fn paced(config: &Config, section: Section, options: &Options) -> Options {
    options.with_interval(interval(section, config.rate))
}

/// The block with its thread; sums come behind what else it reads, as in the record.
fn program(config: &Config, section: Section, unit: &str, doc: &str) -> Result<Program, CompileError> {
    let target = Program::new(unit, doc);
    let thread = target.input(THREAD, Type::Unsigned(config.thread_bits()));
    target.output(THREAD, thread);
    let mut ports = config.program.inputs(section);
    ports.sort_by_key(|port| matches!(port.source, Source::Sum(_)));
    lower(&target, &config.program, (section, &ports), config.format)?;
    Ok(target)
}
