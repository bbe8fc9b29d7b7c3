//! Threads: control, register bank, `init`, `final` and output wired up, cycle for cycle.
//!
//! In a cycle every unit first shows its outputs, which depend on registers only, then all are clocked.

use super::{Bank, Control, Finish, Init, Latencies, Output, bank, control, output};
use crate::unit::Model;
use pointcore_contract::process::Section;
use pointcore_contract::process::config::{Config, WORDS_MAX};
use pointcore_contract::process::queries::{FinalSettings, Fresh, InitSettings, Numbered};
pub use pointcore_contract::process::stages::threads::{In, Out};
use pointcore_contract::process::stages::{finish, init};

/// Threads and their blocks.
#[derive(Clone, Debug)]
pub struct Threads {
    control: Control,
    bank: Bank,
    init: Option<Init>,
    finish: Finish,
    output: Output,
    /// Which settings `init` and `final` read.
    read: [Vec<usize>; 2],
}

impl Threads {
    /// The unit after reset, with pipelines of the given lengths.
    ///
    /// # Panics
    /// When there is an `init` and no latency of it, or the other way round.
    #[must_use]
    pub fn new(config: &Config, latencies: Latencies) -> Self {
        assert_eq!(config.has_init(), latencies.init.is_some(), "an `init` has a latency");
        Self {
            control: Control::new(config),
            bank: Bank::new(config),
            init: latencies.init.map(|latency| Init::new(config, latency)),
            finish: Finish::new(config, latencies.finish),
            output: Output::new(config),
            read: [Section::Init, Section::Final].map(|section| config.settings_read_by(section)),
        }
    }
}

/// Those of the settings that a block reads.
fn chosen(settings: &[u32; WORDS_MAX], read: &[usize]) -> [u32; WORDS_MAX] {
    let mut words = [0; WORDS_MAX];
    words.iter_mut().zip(read).for_each(|(word, &place)| *word = settings[place]);
    words
}

impl Model for Threads {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let control = self.control.outputs();
        let bank = self.bank.outputs();
        let result = self.output.outputs().result;
        Out {
            query_ready: control.query_ready,
            wanted: bank.wanted,
            found_ready: control.found_ready,
            gather: control.gather,
            gathered_ready: bank.gathered_ready,
            kernel: bank.kernel,
            sums_ready: bank.sums_ready,
            result,
            idle: control.idle && result.is_none(),
            event_thread_wait: control.event_thread_wait,
            event_again: bank.again.is_some(),
        }
    }

    fn clock(&mut self, inputs: &In) {
        let control = self.control.outputs();
        let bank = self.bank.outputs();
        let init = self.init.as_ref().map(Model::outputs).unwrap_or_default();
        let finish = self.finish.outputs();
        let output = self.output.outputs();
        let settings = self.read.each_ref().map(|read| chosen(&inputs.settings.words, read));
        self.control.clock(&control::In {
            query: inputs.query,
            want_ready: bank.want_ready,
            found: inputs.found,
            prepare_ready: bank.prepare_ready,
            prepared: bank.prepared,
            gather_ready: inputs.gather_ready,
            again: bank.again,
            released: output.released,
        });
        self.bank.clock(&bank::In {
            fresh: control.start.map(|start| Fresh { thread: start.thread, words: start.query.words }),
            listed: control.listed,
            stores: init.output,
            update: output.update,
            want: control.want,
            wanted_ready: inputs.wanted_ready,
            prepare: control.prepare,
            gathered: inputs.gathered,
            init_ready: init.in_ready,
            kernel_ready: inputs.kernel_ready,
            sums: inputs.sums,
            finish_ready: finish.in_ready,
        });
        if let Some(unit) = &mut self.init {
            let settings = InitSettings { words: settings[0] };
            unit.clock(&init::In { settings, input: bank.init, out_ready: bank.stores_ready });
        }
        let settings = FinalSettings { words: settings[1] };
        self.finish.clock(&finish::In { settings, input: bank.finish, out_ready: output.finished_ready });
        self.output.clock(&output::In {
            iterations_max: inputs.iterations_max,
            numbered: control.start.map(|start| Numbered { thread: start.thread, number: start.query.number }),
            finished: finish.output,
            update_ready: bank.update_ready,
            result_ready: inputs.result_ready,
        });
    }
}
