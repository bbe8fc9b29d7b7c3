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
            event_query_wait: control.event_query_wait,
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

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::Format;
    use pointcore_contract::process::queries::{Found, Query, QueryWords};
    use pointcore_contract::process::records::{Gathered, Neighbor, Sums};
    use pointcore_contract::process::{Program, library};
    use std::collections::VecDeque;
    use std::sync::Arc;

    const QUERIES: u32 = 400;
    const THREADS: u32 = 64;
    const LATENCIES: Latencies = Latencies { init: None, finish: 90 };

    /// Three iterations with the neighbors of the first.
    const AGAIN: &str = ".program again\n.kernel\naccumulate x, neighbor.position.x\n.final\nlast = less 1, count\n\
        output x, x\ndone last\n";
    /// One iteration, before which the farthest neighbor is looked at.
    const FARTHEST: &str = ".program farthest\n.state f: float3\n.init\nstore f, farthest.position\n.kernel\n\
        accumulate x, neighbor.position.x\n.final\noutput x, x\noutput f, f\n";

    /// Items that come some cycles after they were sent.
    struct Delay<T> {
        cycles: u32,
        items: VecDeque<(u32, T)>,
    }

    impl<T: Copy> Delay<T> {
        fn new(cycles: u32) -> Self {
            Self { cycles, items: VecDeque::new() }
        }

        fn send(&mut self, now: u32, item: T) {
            self.items.push_back((now + self.cycles, item));
        }

        fn first(&self, now: u32) -> Option<T> {
            self.items.front().filter(|(when, _)| *when <= now).map(|(_, item)| *item)
        }
    }

    fn config(program: Program, neighbors: u32) -> Config {
        Config {
            program: Arc::new(program),
            format: Format::F32,
            index_bits: 16,
            neighbors,
            threads: THREADS,
            rate: 1,
            line_points: 4,
            cache_lines: 8,
        }
    }

    /// Cycles that a query takes, where searching, gathering and `kernel` have a neighbor a cycle and nobody waits: all
    /// cycles in which `kernel` could take neighbors but for those of the first queries, for whose neighbors it waits, and of
    /// the last ones, which have not enough others beside them.
    fn cycles(program: Program, neighbors: u32, iterations: u32) -> f64 {
        let (margin, total) = [THREADS, QUERIES].map(|queries| queries * iterations * neighbors).into();
        let config = config(program, neighbors);
        let latencies = Latencies { init: config.has_init().then_some(20), ..LATENCIES };
        let mut threads = Threads::new(&config, latencies);
        let (mut found, mut gathered, mut sums) = (Delay::new(70), Delay::new(12), Delay::new(30));
        let (mut asked, mut left, mut met, mut first, mut last, mut now) = (0, 0, 0, 0, 0, 0_u32);
        while left < QUERIES {
            let out = threads.outputs();
            let query = (asked < QUERIES).then_some(Query { number: asked, words: QueryWords::default() });
            let inputs = In {
                iterations_max: 9,
                query,
                wanted_ready: true,
                found: found.first(now),
                gather_ready: true,
                gathered: gathered.first(now),
                kernel_ready: true,
                sums: sums.first(now),
                result_ready: true,
                ..In::default()
            };
            asked += u32::from(query.is_some() && out.query_ready);
            for rank in 0..out.wanted.map_or(0, |_| neighbors) {
                let thread = out.wanted.expect("there are neighbors").thread;
                found.send(now, Found { thread, last: rank + 1 == neighbors, found: true, index: rank });
            }
            found.items.drain(..usize::from(inputs.found.is_some() && out.found_ready));
            gathered.items.drain(..usize::from(inputs.gathered.is_some() && out.gathered_ready));
            sums.items.drain(..usize::from(inputs.sums.is_some() && out.sums_ready));
            if let Some(gather) = out.gather {
                gathered.send(now, Gathered { place: gather.place, neighbor: Neighbor::default() });
            }
            if let Some(input) = out.kernel {
                first = if met == margin { now } else { first };
                last = if met == total - margin { now } else { last };
                met += 1;
                if input.last {
                    sums.send(now, Sums { thread: input.thread, ..Sums::default() });
                }
            }
            left += u32::from(out.result.is_some());
            threads.clock(&inputs);
            now += 1;
            assert!(now < 100_000, "it stands still after {left} queries");
        }
        assert_eq!(met, total);
        f64::from(last - first) / f64::from(QUERIES - 2 * THREADS)
    }

    #[test]
    fn kernel_has_a_neighbor_in_every_cycle() {
        let parse = |text| Program::parse("test.pasm", text).unwrap_or_else(|error| panic!("{error}"));
        for neighbors in [8, 9, 16, 64] {
            assert_eq!(cycles(library::program("covariance"), neighbors, 1), f64::from(neighbors));
            assert_eq!(cycles(parse(AGAIN), neighbors, 3), f64::from(3 * neighbors));
            // A cycle for the farthest neighbor.
            assert_eq!(cycles(parse(FARTHEST), neighbors, 1), f64::from(neighbors + 1));
        }
    }
}
