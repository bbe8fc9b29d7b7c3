//! The whole core: threads and their blocks, gathering and `kernel`, wired up cycle for cycle.
//!
//! In a cycle every unit first shows its outputs, which depend on registers only, then all are clocked.

use super::{Gatherer, Kernel, KernelPipelines, Latencies, Threads, gatherer, kernel, threads};
use crate::unit::Model;
use pointcore_contract::process::Config;
use pointcore_contract::process::stages::Events;
pub use pointcore_contract::process::stages::top::{In, Out};

/// The whole core.
#[derive(Clone, Debug)]
pub struct Top {
    threads: Threads,
    gatherer: Gatherer,
    kernel: Kernel,
    event_kernel: bool,
    event_kernel_wait: bool,
}

impl Top {
    /// The core after reset, with pipelines of the given lengths.
    #[must_use]
    pub fn new(config: &Config, latencies: Latencies, pipelines: KernelPipelines) -> Self {
        Self {
            threads: Threads::new(config, latencies),
            gatherer: Gatherer::new(config),
            kernel: Kernel::new(config, pipelines),
            event_kernel: false,
            event_kernel_wait: false,
        }
    }
}

impl Model for Top {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let threads = self.threads.outputs();
        let gatherer = self.gatherer.outputs();
        Out {
            query_ready: threads.query_ready,
            wanted: threads.wanted,
            found_ready: threads.found_ready,
            fetch: gatherer.fetch,
            fill_ready: gatherer.fill_ready,
            result: threads.result,
            idle: threads.idle,
            events: Events {
                query_wait: threads.event_query_wait,
                kernel: self.event_kernel,
                kernel_wait: self.event_kernel_wait,
                again: threads.event_again,
                gather: gatherer.events,
            },
        }
    }

    fn clock(&mut self, inputs: &In) {
        let threads = self.threads.outputs();
        let gatherer = self.gatherer.outputs();
        let kernel = self.kernel.outputs();
        self.event_kernel = threads.kernel.is_some() && kernel.neighbor_ready;
        self.event_kernel_wait = threads.kernel.is_some() && !kernel.neighbor_ready;
        self.threads.clock(&threads::In {
            settings: inputs.settings,
            iterations_max: inputs.iterations_max,
            query: inputs.query,
            wanted_ready: inputs.wanted_ready,
            found: inputs.found,
            gather_ready: gatherer.gather_ready,
            gathered: gatherer.gathered,
            kernel_ready: kernel.neighbor_ready,
            sums: kernel.sums,
            result_ready: inputs.result_ready,
        });
        self.gatherer.clock(&gatherer::In {
            gather: threads.gather,
            gathered_ready: threads.gathered_ready,
            fetch_ready: inputs.fetch_ready,
            fill: inputs.fill,
            forget: inputs.forget,
        });
        self.kernel.clock(&kernel::In {
            settings: inputs.settings,
            neighbor: threads.kernel,
            sums_ready: threads.sums_ready,
        });
    }
}
