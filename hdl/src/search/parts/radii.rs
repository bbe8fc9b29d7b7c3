//! The search radii of the threads.

use pointcore_contract::search::Config;

use super::neighbor::without_sign;
use super::sets::{contains, decode};
use crate::units::ports::Pulse;
use crate::units::wires::Wires;
use pointcore_contract::search::records::{Radius, Start};
use rtl::{Expr, Module};

/// Who sets a thread's squared radius.
#[derive(Clone, Copy)]
pub(crate) struct Writer {
    /// It does in this cycle.
    pub valid: Expr,
    /// The thread's number.
    pub thread: Expr,
    /// The radius.
    pub radius2: Expr,
}

impl From<Pulse<Start<Wires>>> for Writer {
    fn from(start: Pulse<Start<Wires>>) -> Self {
        let Start { thread, query } = start.record;
        Self { valid: start.valid, thread: thread.thread, radius2: without_sign(query.radius2) }
    }
}

impl From<Pulse<Radius<Wires>>> for Writer {
    fn from(radius: Pulse<Radius<Wires>>) -> Self {
        let Radius { thread, radius2 } = radius.record;
        Self { valid: radius.valid, thread: thread.thread, radius2 }
    }
}

/// A squared radius for each thread, set by its query and by its leaves, which come in the same cycle for different
/// threads: a memory for each, and a bit that says which of the two was written last. Reads that of `thread`, as it was before
/// the cycle, without a register.
pub(crate) fn radii_now(m: &mut Module, config: &Config, writers: [Writer; 2], thread: impl Into<Expr>) -> Expr {
    let thread = thread.into();
    let threads = config.threads;
    let [(by_query, query_set), (by_leaf, leaf_set)] =
        [("query", writers[0]), ("leaf", writers[1])].map(|(name, writer)| {
            let memory =
                m.memory_distributed(&format!("{name}_radii"), 1 << config.thread_bits(), config.square_bits());
            m.write(memory, writer.valid, writer.thread, writer.radius2);
            let radius = m.read_now(memory, &format!("{name}_radius2"), thread);
            (radius, m.wire(&format!("{name}_set"), decode(writer.valid, writer.thread, threads)))
        });
    // Not reset: a thread's first query sets it.
    let from_leaf = m.reg("from_leaf", threads);
    m.next(from_leaf, (from_leaf & !query_set) | leaf_set);
    contains(from_leaf, thread).mux(by_leaf, by_query)
}

/// As [`radii_now`], into a register where `enable` is set: chosen in front of it, for behind it the radius is compared at once.
pub(crate) fn radii(
    m: &mut Module,
    config: &Config,
    writers: [Writer; 2],
    enable: impl Into<Expr>,
    thread: impl Into<Expr>,
) -> Expr {
    let (enable, thread) = (enable.into(), thread.into());
    let now = radii_now(m, config, writers, thread);
    let radius2 = m.reg("radius2", config.square_bits());
    m.next_if(radius2, enable, now);
    radius2.expr()
}
