//! Stack recursion (thesis 6.5.2, listing 6.2): pops paths until one is nearer than the farthest neighbor; golden twin:
//! `pointcore_golden::search::recursion`.

use pointcore_contract::search::{Config, records};

use super::radii::radii;
use crate::units::records::{Record, event_out, pulse_in, pulse_out, queue_in, queue_out, registered_pulse_out};
use rtl::{Expr, Module};

/// The unit; ports as in `contract::search::ports::recursion`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let thread_bits = config.thread_bits();
    let thread_only = records::thread_only(config);
    let mut m = Module::new("search_recursion", "Pops paths until one is worth descending.");
    m.parameter("threads", config.threads);
    let start = pulse_in(&mut m, "start", &records::start(config));
    let radius = pulse_in(&mut m, "radius", &records::radius(config));
    let head = queue_in(&mut m, "in", &thread_only);
    let top_empty = m.input("top_empty", 1);
    let top = Record::input(&mut m, "top_", &records::path(config));
    let resume = queue_out(&mut m, "resume", &records::descent(config));

    let [r0_valid, r1_valid, r2_valid] = ["r0_valid", "r1_valid", "r2_valid"].map(|name| m.reg_reset(name, 1, 0));
    let [r0_thread, r1_thread, r2_thread] =
        ["r0_thread", "r1_thread", "r2_thread"].map(|name| m.reg(name, thread_bits));
    let advance = m.wire("advance", !r2_valid | resume.room);
    let threads_only = |thread: Expr| Record::new(&thread_only, |_| thread);
    pulse_out(&mut m, "pop", advance & r0_valid, &threads_only(*r0_thread));
    m.next_if(r1_valid, advance, r0_valid);
    m.next_if(r1_thread, advance, r0_thread);

    // The path comes late in its cycle, from the memory of the stacks.
    m.next_if(r2_valid, advance, r1_valid);
    m.next_if(r2_thread, advance, r1_thread);
    let found = m.reg("found", 1);
    m.next_if(found, advance, !top_empty);
    let top = top.register(&mut m, "path_", advance);
    let radius2 = radii(&mut m, config, [&start, &radius], advance, r1_thread);

    let decides = m.wire("decides", advance & r2_valid);
    let popped = m.wire("popped", decides & found);
    let nearer = m.wire("nearer", top.get("distance2").lt(radius2));
    let back = m.wire("back", popped & !nearer);
    m.next_if(r0_valid, advance, back | head.valid);
    m.next_if(r0_thread, advance, back.mux(r2_thread, head.field("thread")));
    m.ready(&head, advance & !back);
    resume.push(&mut m, popped & nearer, |name| match name {
        "thread" => r2_thread.expr(),
        field => top.get(field),
    });
    registered_pulse_out(&mut m, "empty", decides & !found, &threads_only(*r2_thread));
    event_out(&mut m, "event_pop", popped);
    m
}
