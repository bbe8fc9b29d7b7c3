//! Queues of records inside a unit, and the register behind one.

use super::passage::Passage;
use super::ports::Flow;
use super::twins::next_twins;
use super::wires::{Bundle, Wired};
use pointcore_contract::Record;
use rtl::{Expr, Module, Reg, Wire};

/// The side of a queue that takes records.
pub(crate) struct Pushed<R> {
    queue: Passage<R>,
    /// An item can be pushed in this cycle.
    pub room: Expr,
}

impl<R: Record> Pushed<R> {
    /// Places a queue; returns both of its sides.
    pub fn place(m: &mut Module, config: &R::Config, name: &str, queue: Module) -> (Self, Flow<Wired<R>>) {
        let queue = Passage::place(m, name, queue);
        let room = queue.room(m);
        let out = queue.out(m, config);
        (Self { queue, room }, out)
    }

    /// Offers a record in cycles where `valid` is set; to be called once.
    pub fn push(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>) {
        self.queue.push(m, config, valid, record);
    }
}

/// A register behind a queue: what is decided about its record starts from flip-flops, and can be prepared while it comes in.
#[derive(Clone, Copy)]
pub(crate) struct Head<B> {
    /// It holds a record.
    pub valid: Reg,
    /// That record.
    pub record: B,
    /// It takes what the queue shows.
    pub takes: Wire,
    /// That record.
    pub arriving: B,
    /// The queue shows one.
    pub arrives: Expr,
}

impl<B: Bundle> Head<B> {
    /// Puts the register behind `queue`.
    pub fn new(m: &mut Module, config: &B::Config, queue: Flow<B>) -> Self {
        let takes = m.forward("head_takes", 1);
        let valid = m.reg_reset("head_valid", 1, 0);
        m.drive(queue.ready, takes);
        let record = queue.record.register(m, config, "head_", takes);
        Self { valid, record, takes, arriving: queue.record, arrives: queue.valid }
    }

    /// States when the record leaves; to be called once.
    pub fn leaves(&self, m: &mut Module, leaves: impl Into<Expr>) {
        m.drive(self.takes, !self.valid | leaves.into());
        m.next_if(self.valid, self.takes, self.arrives);
    }

    /// As [`Head::leaves`], but the next record is taken a cycle later, as behind a half buffer it can only come: what takes it then
    /// waits for nothing. It takes by a register of its own, which moves all of the record; `valid` has few loads.
    pub fn leaves_at_half_rate(&self, m: &mut Module, leaves: impl Into<Expr>) {
        let empty = m.reg_reset("head_empty", 1, 1);
        m.drive(self.takes, empty);
        let holds = self.valid.mux(!leaves.into(), self.arrives);
        next_twins(m, "head_empty_or_valid", [self.valid, empty], holds);
    }
}
