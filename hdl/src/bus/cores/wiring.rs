//! What the tops share: a unit's record becomes the next one's, and the registers hear of what happens.

use pointcore_contract::Record;
use pointcore_contract::bus::packets::Packet;
use pointcore_contract::bus::registers::RegisterMap;
use pointcore_contract::bus::units::{abort, packet_in, packet_out, registers};
use pointcore_contract::search::{self, records::CacheSetup};
use pointcore_contract::unit::{In, Output, PulseIn};

use crate::bus::{self, ADDRESS_BITS};
use crate::units::ports::{InputPorts, OutputPorts, Pulse, PulseInPorts, StreamInPorts, WordPort};
use crate::units::wires::{Wired, Wires};
use rtl::{Expr, Instance, Module, Wire, cat, lit};

/// Leads a record into a unit that is not as the stream has it; it moves only while `gate` is set.
pub(super) fn feed<R: Record>(
    m: &mut Module,
    config: &R::Config,
    (valid, stream_ready): (Expr, Wire),
    (to, input): (Instance, In<R>),
    gate: Expr,
    record: Wired<R>,
) {
    let ready = input.offer(m, config, to, valid & gate, record);
    m.drive(stream_ready, ready & gate);
}

/// What ends a run before its time.
#[derive(Clone, Copy)]
pub(super) struct Abort {
    unit: Instance,
    /// The core is to stay in reset, and what still comes for it to be dropped.
    pub drops: Expr,
}

impl Abort {
    const PORTS: abort::Ports = abort::Ports::ALL;

    /// Places the unit beside the registers.
    pub fn place<M: RegisterMap>(m: &mut Module, control: Instance) -> Self {
        let unit = m.instance("early_end", bus::abort::module());
        let ports = registers::Ports::<M>::ALL;
        let asked = ports.aborts.word_of(m, control);
        Self::PORTS.asked.feed_word(m, unit, asked);
        let running = ports.busy.word_of(m, control);
        Self::PORTS.running.feed_word(m, unit, running);
        Self { unit, drops: Self::PORTS.aborts.word_of(m, unit) }
    }

    /// Whether the run has ended, by itself or early; nothing is under way on the buses while `quiet`.
    pub fn finished(&self, m: &mut Module, by_itself: Expr, quiet: Expr) -> Expr {
        Self::PORTS.quiet.feed_word(m, self.unit, quiet);
        let ended = Self::PORTS.ended.word_of(m, self.unit);
        (by_itself & !self.drops) | ended
    }
}

/// Tells the registers what packets did and what happened in the core; returns their interrupt.
pub(super) fn report<M: RegisterMap, I: Packet, O: Record>(
    m: &mut Module,
    config: &M::Config,
    control: Instance,
    (core, events): (Instance, Output<M::Events>),
    [receiver, sender]: [Instance; 2],
) -> Expr {
    let ports = registers::Ports::<M>::ALL;
    let taken = packet_in::Ports::<I>::ALL.taken.word_of(m, receiver);
    ports.packet_taken.feed_word(m, control, taken);
    let sent = packet_out::Ports::<O>::ALL.sent.word_of(m, sender);
    ports.packet_sent.feed_word(m, control, sent);
    let events = events.of(m, config, core);
    ports.events.feed(m, config, control, events);
    ports.irq.word_of(m, control)
}

/// An index times a stride, from a base.
pub(super) fn place(base: Expr, index: Expr, stride_bits: u32) -> Expr {
    base + cat([index, lit(stride_bits, 0)]).resize(ADDRESS_BITS)
}

/// Whether all queries of a run are answered: counts queries in, and those answered out. Tells the unit that takes packets which is
/// the last.
pub(super) fn run<Q: Packet>(m: &mut Module, wanted: Expr, queries: Instance, start: Expr, answered: Expr) -> Expr {
    let ports = packet_in::Ports::<Q>::ALL;
    let width = wanted.width();
    let countdown = |m: &mut Module, name: &str, goes: Expr| {
        let left = m.reg_reset(name, width, 0);
        m.next(left, start.mux(wanted, left - goes.zext(width)));
        left
    };
    // The pulse comes a cycle after its packet, in which the next one may already end.
    let taken = ports.taken.word_of(m, queries);
    let queries_left = countdown(m, "queries_left", taken);
    let few = queries_left.bits(width - 1, 2).is_zero();
    let last = taken.mux(queries_left.trunc(2).eq_lit(2), queries_left.trunc(2).eq_lit(1));
    ports.last.feed_word(m, queries, few & last);
    let answers_left = countdown(m, "answers_left", answered);
    !answers_left.any() & !start
}

/// Hands the neighbor cache its constants, after the cycle in which a start may reset the core.
pub(super) fn set_up(
    m: &mut Module,
    config: &search::Config,
    (core, port): (Instance, PulseIn<CacheSetup>),
    start: Expr,
    record: CacheSetup<Wires>,
) {
    let valid = m.reg_reset("sets_up", 1, 0);
    m.next(valid, start);
    port.feed(m, config, core, Pulse { valid: valid.expr(), record });
}
