//! Threads: control, register bank, `init`, `final` and output wired up; golden twin:
//! `pointcore_golden::process::threads`.

use super::{bank, control, output, stage};
use crate::compiler::{CompileError, Manifest, Options};
use crate::units::ports::{
    InputPorts, Pulse, PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort, pipe, pulse,
};
use pointcore_contract::process::config::{Config, ITERATION_BITS, WORDS_MAX};
use pointcore_contract::process::queries::{FinalSettings, Fresh, InitSettings, Numbered};
use pointcore_contract::process::stages::threads::PORTS;
use pointcore_contract::process::{Section, stages};
use rtl::{Expr, Instance, Module};
use std::collections::BTreeMap;

/// The module and what the compiler decided about its datapaths.
pub struct Core {
    /// The module.
    pub module: Module,
    /// By block.
    pub manifests: BTreeMap<String, Manifest>,
}

/// The units.
struct Units {
    control: Instance,
    bank: Instance,
    init: Option<Instance>,
    finish: Instance,
    output: Instance,
}

/// Those of the settings that a block reads.
fn chosen(config: &Config, section: Section, settings: &[Expr; WORDS_MAX]) -> [Expr; WORDS_MAX] {
    let mut words = [Expr::default(); WORDS_MAX];
    let read = config.settings_read_by(section);
    words.iter_mut().zip(read).for_each(|(word, place)| *word = settings[place]);
    words
}

impl Units {
    /// Leads what goes round from one unit to the next.
    fn connect(&self, m: &mut Module, config: &Config) {
        let Self { control, bank, finish, output, init } = *self;
        let (of_control, of_bank, of_output) = (stages::control::PORTS, stages::bank::PORTS, stages::output::PORTS);
        let start = of_control.start.of(m, config, control);
        let (thread, query) = (start.record.thread, start.record.query);
        let fresh = Pulse { valid: start.valid, record: Fresh { thread, words: query.words } };
        of_bank.fresh.feed(m, config, bank, fresh);
        let numbered = Pulse { valid: start.valid, record: Numbered { thread, number: query.number } };
        of_output.numbered.feed(m, config, output, numbered);
        pipe(m, config, (control, of_control.want), (bank, of_bank.want));
        pulse(m, config, (control, of_control.listed), (bank, of_bank.listed));
        pulse(m, config, (bank, of_bank.again), (control, of_control.again));
        pulse(m, config, (output, of_output.released), (control, of_control.released));
        pipe(m, config, (bank, of_bank.finish), (finish, stages::finish::PORTS.input));
        pipe(m, config, (finish, stages::finish::PORTS.output), (output, of_output.finished));
        pipe(m, config, (output, of_output.update), (bank, of_bank.update));
        let Some(init) = init else { return };
        if !config.has_farthest() {
            pipe(m, config, (control, of_control.prepare), (bank, of_bank.prepare));
        }
        pulse(m, config, (bank, of_bank.prepared), (control, of_control.prepared));
        pipe(m, config, (bank, of_bank.init), (init, stages::init::PORTS.input));
        pipe(m, config, (init, stages::init::PORTS.output), (bank, of_bank.stores));
    }

    /// Leads settings in.
    fn settings(&self, m: &mut Module, config: &Config) {
        let settings = PORTS.settings.declare(m, config).words;
        if let Some(init) = self.init {
            let words = chosen(config, Section::Init, &settings);
            stages::init::PORTS.settings.feed(m, config, init, InitSettings { words });
        }
        let words = chosen(config, Section::Final, &settings);
        stages::finish::PORTS.settings.feed(m, config, self.finish, FinalSettings { words });
        let iterations_max = PORTS.iterations_max.declare_word(m, ITERATION_BITS);
        stages::output::PORTS.iterations_max.feed_word(m, self.output, iterations_max);
    }

    /// Leads streams in and out.
    fn border(&self, m: &mut Module, config: &Config) {
        let Self { control, bank, output, .. } = *self;
        let (of_control, of_bank, of_output) = (stages::control::PORTS, stages::bank::PORTS, stages::output::PORTS);
        let query = PORTS.query.declare(m, config);
        of_control.query.feed(m, config, control, query);
        let wanted = of_bank.wanted.of(m, config, bank);
        PORTS.wanted.export(m, config, wanted);
        let found = PORTS.found.declare(m, config);
        of_control.found.feed(m, config, control, found);
        let gather = of_control.gather.of(m, config, control);
        PORTS.gather.export(m, config, gather);
        let gathered = PORTS.gathered.declare(m, config);
        of_bank.gathered.feed(m, config, bank, gathered);
        let kernel = of_bank.kernel.of(m, config, bank);
        PORTS.kernel.export(m, config, kernel);
        let sums = PORTS.sums.declare(m, config);
        of_bank.sums.feed(m, config, bank, sums);
        let result = of_output.result.of(m, config, output);
        PORTS.result.export(m, config, result);
        let idle = of_control.idle.word_of(m, control);
        PORTS.idle.drive_word(m, idle & !result.valid);
        let wait = of_control.event_query_wait.word_of(m, control);
        PORTS.event_query_wait.drive_word(m, wait);
        let again = of_bank.again.of(m, config, bank);
        PORTS.event_again.drive_word(m, again.valid);
    }
}

/// Builds the unit.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Core, CompileError> {
    let mut m = Module::new("process_threads", "Queries and their threads, between searching, gathering and kernel.");
    let mut manifests = BTreeMap::new();
    let init = if config.has_init() {
        let init = stage::init(config, options)?;
        manifests.insert("init".to_owned(), init.manifest);
        Some(m.instance("init", init.module))
    } else {
        None
    };
    let finish = stage::finish(config, options)?;
    manifests.insert("final".to_owned(), finish.manifest);
    let units = Units {
        control: m.instance("control", control::module(config)),
        bank: m.instance("bank", bank::module(config)),
        init,
        finish: m.instance("finish", finish.module),
        output: m.instance("results", output::module(config)),
    };
    units.connect(&mut m, config);
    units.settings(&mut m, config);
    units.border(&mut m, config);
    Ok(Core { module: m, manifests })
}
