//! Thread control (thesis 6.5.2): gives queries to threads, and says when a thread pops and when it is finished;
//! golden twin: `pointcore_golden::search::threads`.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Descent, Start, Thread};
use pointcore_contract::search::units::threads::PORTS;
use pointcore_contract::splat::config::index_bits;
use pointcore_contract::unit::Out;

use super::parts::sets::{decode, index_of, lowest, set};
use crate::units::ports::{PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, WordPort};
use rtl::{Expr, Module, Reg, lit};

/// Shows a thread and, when it is taken, chooses the next: the first from a pointer on that has a wish, behind which the pointer
/// moves; returns whose wish is granted. Choice and pointer are sets, the pointer's those behind the thread granted last: a
/// thread's number is encoded on its way out.
fn grant(m: &mut Module, config: &Config, ports: Out<Thread>, wishes: Reg) -> Expr {
    let name = ports.name;
    let threads = wishes.width();
    let behind = m.reg_reset(&format!("behind_{name}"), threads, 0);
    let chosen = m.reg_reset(&format!("chosen_{name}"), threads, 0);
    let shown = m.reg_reset(&format!("{name}_shown"), 1, 0);
    let ready = ports.drive(m, config, shown, Thread { thread: index_of(chosen, config.thread_bits()) });
    let advance = m.wire(&format!("{name}_advance"), ready | !shown);
    m.next_if(shown, advance, wishes.any());

    // The first of those behind and the first of all are sought side by side.
    let next = m.wire(&format!("{name}_next"), wishes & behind);
    let [below_next, below_any] = [("next", &next), ("any", &wishes.expr())]
        .map(|(which, set)| m.wire(&format!("{name}_below_{which}"), *set - lit(threads, 1)));
    let from_next = m.wire(&format!("{name}_from_next"), next.any());
    let first = from_next.mux(next & !below_next, wishes & !below_any);
    let first = m.wire(&format!("first_{name}"), first);
    m.next_if(chosen, advance, first);
    let after = from_next.mux(next ^ below_next, wishes ^ below_any);
    m.next_if(behind, advance & wishes.any(), !after);
    m.wire(&format!("granted_{name}"), first & advance.repeat(threads))
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let threads = config.threads;
    let mut m = Module::new("search_threads", "Gives queries to threads and says what each does next.");
    m.parameter("threads", threads);
    m.parameter("leaves_in_flight", config.leaves_in_flight);
    let query = PORTS.query.declare(&mut m, config);
    let [busy, waiting, exhausted, wants_pop, wants_finish] =
        ["busy", "waiting", "exhausted", "wants_pop", "wants_finish"].map(|name| m.reg_reset(name, threads, 0));

    // A query goes to the lowest free thread, whose descent begins at the root a cycle later. Whether there is one is told before
    // it is known which.
    let any_free = m.reg_reset("any_free", 1, 1);
    let free = m.wire("free", lowest(!busy));
    let take = m.wire("take", query.transfer());
    let thread = Thread { thread: index_of(free, config.thread_bits()) };
    let start = PORTS.start.registered(&mut m, config, take, Start { thread, query: query.record });
    let descend = PORTS.descend.queue(&mut m, config);
    m.drive(query.ready, (any_free & !start.valid) & descend.room);
    let root = lit(config.node_bits(), 1);
    descend.push(&mut m, config, start.valid, Descent { thread: start.record.thread, node: root });

    let popped = grant(&mut m, config, PORTS.pop, wants_pop);
    let finished = grant(&mut m, config, PORTS.finish, wants_finish);

    let pulses = [PORTS.reached, PORTS.leaf_done, PORTS.skipped, PORTS.empty, PORTS.released];
    let [reached, leaf_done, skipped, empty, released] = pulses.map(|ports| {
        let pulse = ports.declare(&mut m, config);
        m.wire(&format!("{}_set", ports.name), decode(pulse.valid, pulse.record.thread, threads))
    });
    let leaf_ended = m.wire("leaf_ended", leaf_done | skipped);
    let count_bits = index_bits(config.leaves_in_flight + 1);
    let limit = config.leaves_in_flight.into();
    let (mut below, mut none, mut impossible) = (vec![], vec![], vec![]);
    for thread in 0..threads {
        let outstanding = m.reg_reset(&format!("outstanding_{thread}"), count_bits, 0);
        let [more, done, skip] = [&reached, &leaf_done, &skipped].map(|event| event.bit(thread).zext(count_bits));
        let next = m.wire(&format!("outstanding_{thread}_next"), outstanding + more - done - skip);
        m.next(outstanding, next);
        below.push(next.lt_lit(limit));
        none.push(next.is_zero());
        let ends = done.zext(count_bits + 1) + skip.zext(count_bits + 1);
        impossible.push([
            outstanding.zext(count_bits + 1).lt(ends),
            reached.bit(thread) & !outstanding.lt_lit(limit),
            released.bit(thread) & (outstanding.any() | reached.bit(thread)),
        ]);
    }
    let (below, none) = (set(&below), set(&none));
    let names =
        ["leaves_are_reached_before_they_end", "no_more_leaves_are_under_way", "threads_are_released_without_leaves"];
    for (place, name) in names.into_iter().enumerate() {
        let threads: Vec<_> = impossible.iter().map(|checks| checks[place]).collect();
        m.assert(name, !set(&threads).any());
    }

    let kept = m.wire("kept", !released);
    let taken = free & take.repeat(threads);
    let busy_next = m.wire("busy_next", (busy | taken) & kept);
    m.next(busy, busy_next);
    m.next(any_free, !busy_next.all());
    m.assert("a_free_thread_is_told", any_free.eq(!busy.all()));
    let exhausted_now = m.wire("exhausted_now", exhausted | empty);
    m.next(exhausted, exhausted_now & kept);
    m.next(waiting, ((waiting & !leaf_ended) | (reached & !below)) & kept);
    let pop_wishes = (reached & below) | (leaf_ended & waiting);
    m.next(wants_pop, ((wants_pop & !popped) | pop_wishes) & kept);
    let finish_wishes = (empty | leaf_ended) & (exhausted_now & none);
    m.next(wants_finish, ((wants_finish & !finished) | finish_wishes) & kept);
    PORTS.event_thread_wait.event(&mut m, query.valid & !any_free);
    m
}
