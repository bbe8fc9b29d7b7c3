//! Instances that take items at `in` and show items at `out`: queues, and the datapaths that the compiler makes.

use std::marker::PhantomData;

use pointcore_contract::Record;
use pointcore_contract::unit::{In, Out};
use rtl::{Expr, Instance, Module};

use super::ports::{Flow, StreamInPorts, StreamOutPorts};
use super::wires::{Bundle, Wired};

/// An instance with records `I` at `in` and records `O` at `out`.
pub(crate) struct Passage<I, O = I> {
    instance: Instance,
    records: PhantomData<(I, O)>,
}

impl<I: Record, O: Record> Passage<I, O> {
    const IN: In<I> = In::new("in", "valid", "");
    const OUT: Out<O> = Out::new("out", "valid", "");

    /// Places a module as an instance of that name.
    pub fn place(m: &mut Module, name: &str, module: Module) -> Self {
        Self { instance: m.instance(name, module), records: PhantomData }
    }

    /// The instance, for what else it has.
    pub const fn instance(&self) -> Instance {
        self.instance
    }

    /// An item can be taken in this cycle.
    pub fn room(&self, m: &mut Module) -> Expr {
        Self::IN.room(m, self.instance)
    }

    /// States that an item can be taken in each cycle where `valid` is set.
    pub fn has_room_for(&self, m: &mut Module, valid: Expr) {
        let room = self.room(m);
        m.assert(&format!("{}_has_room", self.instance.name()), !valid | room);
    }

    /// Offers an item in cycles where `valid` is set; to be called once.
    pub fn push(&self, m: &mut Module, config: &I::Config, valid: impl Into<Expr>, record: Wired<I>) {
        Self::IN.push(m, config, self.instance, valid, record);
    }

    /// What is shown.
    pub fn out(&self, m: &mut Module, config: &O::Config) -> Flow<Wired<O>> {
        Self::OUT.of(m, config, self.instance)
    }

    /// Whether an item is shown, and the item; who calls it says with [`Passage::take`] when it is taken.
    pub fn shown(&self, m: &mut Module, config: &O::Config) -> (Expr, Wired<O>) {
        Self::OUT.shown(m, config, self.instance)
    }

    /// States when what is shown is taken; to be called once.
    pub fn take(&self, m: &mut Module, taken: impl Into<Expr>) {
        Self::OUT.take(m, self.instance, taken);
    }

    /// Drives inputs that are no part of an item: a datapath's uniforms.
    pub fn set<R: Record>(&self, m: &mut Module, config: &R::Config, record: Wired<R>) {
        record.connect(m, config, self.instance, "");
    }
}
