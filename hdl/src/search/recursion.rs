//! Stack recursion (thesis 6.5.2, listing 6.2): pops paths until one is nearer than the farthest neighbor; golden twin:
//! `pointcore_golden::search::recursion`.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Descent, Thread};
use pointcore_contract::search::units::recursion::PORTS;

use super::parts::radii::radii;
use super::parts::sets::{contains, decode};
use crate::units::ports::{InputPorts, PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::twins::{next_twins, twins};
use crate::units::wires::Bundle;
use rtl::Module;

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let thread_bits = config.thread_bits();
    let mut m = Module::new("search_recursion", "Pops paths until one is worth descending.");
    m.parameter("threads", config.threads);
    let start = PORTS.start.declare(&mut m, config);
    let radius = PORTS.radius.declare(&mut m, config);
    let head = PORTS.input.queue(&mut m, config);
    let top_empty = PORTS.top_empty.declare_word(&mut m, 1);
    let top = PORTS.top.declare(&mut m, config);
    let resume = PORTS.resume.queue(&mut m, config);

    let [r0_valid, r1_valid] = ["r0_valid", "r1_valid"].map(|name| m.reg_reset(name, 1, 0));
    let [r2_valid, r2_empty] = twins(&mut m, ["r2_valid", "r2_empty"]);
    let [r0_thread, r1_thread, r2_thread] =
        ["r0_thread", "r1_thread", "r2_thread"].map(|name| m.reg(name, thread_bits));
    let advance = m.wire("advance", !r2_valid | resume.room);
    // As `advance`, which moves all stages, but by another register: the stacks are far away.
    let pops = m.wire("pops", (r2_empty | resume.room) & r0_valid);
    PORTS.pop.drive(&mut m, config, pops, Thread { thread: *r0_thread });
    m.next_if(r1_valid, advance, r0_valid);
    m.next_if(r1_thread, advance, r0_thread);

    let begun = m.reg_reset("begun", config.threads, 0);
    m.next(begun, begun | decode(start.valid, start.record.thread.thread, config.threads));
    m.assert("a_query_begins_before_its_thread_pops", !r0_valid | contains(begun, r0_thread));

    // The path comes late in its cycle, from the memory of the stacks.
    next_twins(&mut m, "r2_valid_or_empty", [r2_valid, r2_empty], advance.mux(r1_valid, r2_valid));
    m.next_if(r2_thread, advance, r1_thread);
    let found = m.reg("found", 1);
    m.next_if(found, advance, !top_empty);
    let top = top.register(&mut m, config, "path_", advance);
    let radius2 = radii(&mut m, config, [start.into(), radius.into()], advance, r1_thread);

    let decides = m.wire("decides", advance & r2_valid);
    let popped = m.wire("popped", decides & found);
    let nearer = m.wire("nearer", top.distance2.lt(radius2));
    let back = m.wire("back", popped & !nearer);
    m.next_if(r0_valid, advance, back | head.valid);
    m.next_if(r0_thread, advance, back.mux(r2_thread, head.record.thread));
    m.drive(head.ready, advance & !back);
    let thread = Thread { thread: *r2_thread };
    resume.push(&mut m, config, popped & nearer, Descent { thread, node: top.node });
    PORTS.empty.registered(&mut m, config, decides & !found, thread);
    PORTS.event_pop.event(&mut m, popped);
    m
}
