//! Output: counts iterations, and lets queries leave; golden twin: `pointcore_golden::process::output`.

use crate::units::ports::{PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort};
use pointcore_contract::process::config::{Config, ITERATION_BITS};
use pointcore_contract::process::queries::{Again, Outcome, Update};
use pointcore_contract::process::stages::output::PORTS;
use rtl::{Module, bit, lit};

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("process_output", "Counts iterations, and lets queries leave.");
    m.parameter("threads", config.threads);
    let iterations_max = PORTS.iterations_max.declare_word(&mut m, ITERATION_BITS);
    let numbered = PORTS.numbered.declare(&mut m, config);
    let finished = PORTS.finished.declare(&mut m, config);
    let update = PORTS.update.half(&mut m, config);
    let result = PORTS.result.half(&mut m, config);

    // What is kept of the thread is read, and then used: two cycles a query, of which there is one in eight at most.
    let thread = finished.record.thread;
    let words = 1 << config.thread_bits();
    let numbers = m.memory_distributed("numbers", words, config.index_bits);
    m.write(numbers, numbered.valid, numbered.record.thread.thread, numbered.record.number);
    let number = m.read(numbers, "number", thread.thread);
    let counts = m.memory_distributed("counts", words, ITERATION_BITS);
    let count = m.read(counts, "count", thread.thread);
    let has_read = m.reg_reset("has_read", 1, 0);
    m.drive(finished.ready, has_read & (update.room & result.room));
    let take = m.wire("take", finished.transfer());
    m.next(has_read, finished.valid & !take);

    let iterations = m.wire("iterations", count.add_lit(1));
    let done = finished.record.done;
    let capped = m.wire("capped", !done & iterations.eq(iterations_max));
    let leaves = m.wire("leaves", done | capped);
    let goes_on = m.wire("goes_on", take & !leaves);
    // What begins anew waits for the count that is written now; neither comes in two cycles in a row.
    let begun = m.reg_reset("begun", 1, 0);
    let begun_thread = m.reg("begun_thread", config.thread_bits());
    m.assert("one_begins_at_a_time", !(begun & goes_on) | !numbered.valid);
    for (name, begins, beginner) in [
        ("finishes_after_begin", numbered.valid, numbered.record.thread.thread),
        ("finishes_after_begun", begun.expr(), begun_thread.expr()),
    ] {
        m.assert(name, !(begins & finished.valid) | !thread.thread.eq(beginner));
    }
    m.next(begun, numbered.valid | (begun & goes_on));
    m.next_if(begun_thread, numbered.valid, numbered.record.thread.thread);
    let count_thread = goes_on.mux(thread.thread, begun_thread);
    m.write(counts, goes_on | begun, count_thread, goes_on.mux(iterations, lit(ITERATION_BITS, 0)));
    let search = if config.has_search() { finished.record.search } else { bit(false) };
    let again = Again { thread, search };
    update.push(&mut m, config, goes_on, Update { again, change: finished.record.change, count: iterations });
    let outcome = Outcome { number, iterations, capped, outputs: finished.record.outputs };
    result.push(&mut m, config, take & leaves, outcome);
    PORTS.released.registered(&mut m, config, take & leaves, thread);
    m
}
