//! The whole process core: queries and neighbors found in, points behind a memory port, results out; golden twin:
//! `pointcore_golden::process::top`.

use std::collections::BTreeMap;

use pointcore_contract::process::config::{Config, ITERATION_BITS};
use pointcore_contract::process::stages::top::PORTS;
use pointcore_contract::process::stages::{Events, threads as of_threads};
use pointcore_contract::process::units::{gatherer as of_gatherer, kernel as of_kernel};

use super::kernel::Kernel;
use super::{gatherer, kernel, threads};
use crate::compiler::{CompileError, Manifest, Options};
use crate::units::ports::{InputPorts, OutputPorts, StreamInPorts, StreamOutPorts, WordPort, pipe};
use crate::units::wires::Wires;
use rtl::{Expr, Instance, Module};

/// The core's module and what the compiler decided about its datapaths.
pub struct Core {
    /// The top module, `process_top`.
    pub module: Module,
    /// By block: `init` where there is one, `kernel`, `sums` for the adders behind it, `final`.
    pub manifests: BTreeMap<String, Manifest>,
}

/// The units.
#[derive(Clone, Copy)]
struct Units {
    threads: Instance,
    gatherer: Instance,
    kernel: Instance,
}

impl Units {
    /// Leads what holds for a run in.
    fn constants(self, m: &mut Module, config: &Config) {
        let settings = PORTS.settings.declare(m, config);
        of_threads::PORTS.settings.feed(m, config, self.threads, settings);
        of_kernel::PORTS.settings.feed(m, config, self.kernel, settings);
        let iterations_max = PORTS.iterations_max.declare_word(m, ITERATION_BITS);
        of_threads::PORTS.iterations_max.feed_word(m, self.threads, iterations_max);
        let forget = PORTS.forget.declare_word(m, 1);
        of_gatherer::PORTS.forget.feed_word(m, self.gatherer, forget);
    }

    /// Leads neighbors through the units; returns whether `kernel` takes one and whether one waits.
    fn neighbors(self, m: &mut Module, config: &Config) -> (Expr, Expr) {
        let Self { threads, gatherer, kernel } = self;
        pipe(m, config, (threads, of_threads::PORTS.gather), (gatherer, of_gatherer::PORTS.gather));
        pipe(m, config, (gatherer, of_gatherer::PORTS.gathered), (threads, of_threads::PORTS.gathered));
        let neighbor = of_threads::PORTS.kernel.of(m, config, threads);
        of_kernel::PORTS.neighbor.feed(m, config, kernel, neighbor);
        pipe(m, config, (kernel, of_kernel::PORTS.sums), (threads, of_threads::PORTS.sums));
        (neighbor.transfer(), neighbor.valid & !neighbor.ready)
    }

    /// Leads queries, searches, the memory and results in and out.
    fn border(self, m: &mut Module, config: &Config) {
        let Self { threads, gatherer, .. } = self;
        let query = PORTS.query.declare(m, config);
        of_threads::PORTS.query.feed(m, config, threads, query);
        let wanted = of_threads::PORTS.wanted.of(m, config, threads);
        PORTS.wanted.export(m, config, wanted);
        let found = PORTS.found.declare(m, config);
        of_threads::PORTS.found.feed(m, config, threads, found);
        let fetch = of_gatherer::PORTS.fetch.of(m, config, gatherer);
        PORTS.fetch.export(m, config, fetch);
        let fill = PORTS.fill.declare(m, config);
        of_gatherer::PORTS.fill.feed(m, config, gatherer, fill);
        let result = of_threads::PORTS.result.of(m, config, threads);
        PORTS.result.export(m, config, result);
        let idle = of_threads::PORTS.idle.word_of(m, threads);
        PORTS.idle.drive_word(m, idle);
    }
}

/// Builds the core.
///
/// # Errors
/// What the compiler rejects.
pub fn core(config: &Config, options: &Options) -> Result<Core, CompileError> {
    let mut m = Module::new("process_top", "Queries and neighbors found in, what a program makes of them out.");
    let threads::Core { module: threads, mut manifests } = threads::core(config, options)?;
    let Kernel { module: kernel, kernel: block, sums } = kernel::unit(config, options)?;
    manifests.extend([("kernel".to_owned(), block), ("sums".to_owned(), sums)]);
    let units = Units {
        threads: m.instance("threads", threads),
        gatherer: m.instance("gatherer", gatherer::module(config)),
        kernel: m.instance("kernel", kernel),
    };
    units.constants(&mut m, config);
    let (takes, waits) = units.neighbors(&mut m, config);
    units.border(&mut m, config);
    let [kernel, kernel_wait] = [("kernel_took", takes), ("kernel_waited", waits)].map(|(name, happens)| {
        let happened = m.reg_reset(name, 1, 0);
        m.next(happened, happens);
        happened.expr()
    });
    let events = Events::<Wires> {
        query_wait: of_threads::PORTS.event_query_wait.word_of(&mut m, units.threads),
        kernel,
        kernel_wait,
        again: of_threads::PORTS.event_again.word_of(&mut m, units.threads),
        gather: of_gatherer::PORTS.events.of(&mut m, config, units.gatherer),
    };
    PORTS.events.drive(&mut m, config, events);
    Ok(Core { module: m, manifests })
}
