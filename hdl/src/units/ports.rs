//! The contract's descriptions of ports, declared, driven and wired up.
//!
//! A unit takes them from its own `PORTS` and declares them on its module; whoever places the unit takes them from there as well and
//! connects the instance.

use std::marker::PhantomData;

use pointcore_contract::unit::{In, Input, Out, Output, PulseIn, PulseOut};
use pointcore_contract::{Record, fields};
use rtl::{Expr, Instance, Module, Stream, Wire, bit};

use super::documents::{self, prefix};
use super::wires::{Bundle, Places, Wired, layout, places};
use crate::stream::{half_buffer, skid};

/// A stream inside a module: what the producer shows, and the consumer's answer, to be driven once.
#[derive(Clone, Copy)]
pub(crate) struct Flow<B> {
    /// An item is there.
    pub valid: Expr,
    /// The item.
    pub record: B,
    /// The consumer takes the item.
    pub ready: Wire,
}

impl<B: Bundle> Flow<B> {
    /// The item moves in this cycle.
    pub fn transfer(&self) -> Expr {
        self.valid & self.ready
    }

    /// The stream of what is made of its items.
    pub fn map<T>(self, item: impl FnOnce(B) -> T) -> Flow<T> {
        Flow { valid: self.valid, record: item(self.record), ready: self.ready }
    }

    /// The stream field by field.
    pub fn plain(self, config: &B::Config) -> Stream {
        Stream { valid: self.valid, fields: self.record.named(config).collect(), ready: self.ready }
    }

    fn typed(stream: Stream, config: &B::Config) -> Self {
        let values = stream.fields.iter().map(|(_, value)| *value);
        Self { valid: stream.valid, record: B::from_values(config, values), ready: stream.ready }
    }

    /// Feeds the ports `<port>_…` of an instance.
    pub fn into(self, m: &mut Module, config: &B::Config, instance: Instance, port: &str) {
        m.stream_into(instance, port, &self.plain(config));
    }

    /// What an instance puts out at the ports `<port>_…`.
    pub fn from(m: &mut Module, config: &B::Config, instance: Instance, port: &str) -> Self {
        Self::typed(m.stream_from(instance, port), config)
    }

    /// Leads the stream through a queue, an instance of that name.
    pub fn through(self, m: &mut Module, config: &B::Config, name: &str, queue: Module) -> Self {
        let queue = m.instance(name, queue);
        self.into(m, config, queue, "in");
        Self::from(m, config, queue, "out")
    }
}

/// A record that is always taken: it comes with `valid` and without `ready`.
#[derive(Clone, Copy)]
pub(crate) struct Pulse<B> {
    /// The record is there.
    pub valid: Expr,
    /// The record.
    pub record: B,
}

/// A stream into a unit.
pub(crate) trait StreamInPorts<R: Record>: Sized {
    /// Declares the ports on the unit.
    fn declare(self, m: &mut Module, config: &R::Config) -> Flow<Wired<R>>;

    /// Declares the ports and puts a queue of two behind them; returns the queue's head.
    fn queue(self, m: &mut Module, config: &R::Config) -> Flow<Wired<R>>;

    /// As [`StreamInPorts::queue`] at half rate, for records so wide that a register for one is enough to pay.
    fn half(self, m: &mut Module, config: &R::Config) -> Flow<Wired<R>>;

    /// Feeds an instance of the unit.
    fn feed(self, m: &mut Module, config: &R::Config, instance: Instance, stream: Flow<Wired<R>>);

    /// Offers an instance of the unit a record in cycles where `valid` is set; returns whether it can take one.
    fn offer(
        self,
        m: &mut Module,
        config: &R::Config,
        instance: Instance,
        valid: impl Into<Expr>,
        record: Wired<R>,
    ) -> Expr;
}

impl<R: Record> StreamInPorts<R> for In<R> {
    fn declare(self, m: &mut Module, config: &R::Config) -> Flow<Wired<R>> {
        let stream = m.stream_in(self.name, &layout::<R>(config));
        documents::flagged::<R>(m, config, (self.name, "valid"), self.doc);
        Flow::typed(stream, config)
    }

    fn queue(self, m: &mut Module, config: &R::Config) -> Flow<Wired<R>> {
        let ports = self.declare(m, config);
        ports.through(m, config, &format!("{}_queue", self.name), skid(&layout::<R>(config)))
    }

    fn half(self, m: &mut Module, config: &R::Config) -> Flow<Wired<R>> {
        let ports = self.declare(m, config);
        ports.through(m, config, &format!("{}_queue", self.name), half_buffer(&layout::<R>(config)))
    }

    fn feed(self, m: &mut Module, config: &R::Config, instance: Instance, stream: Flow<Wired<R>>) {
        stream.into(m, config, instance, self.name);
    }

    fn offer(
        self,
        m: &mut Module,
        config: &R::Config,
        instance: Instance,
        valid: impl Into<Expr>,
        record: Wired<R>,
    ) -> Expr {
        m.connect(instance, &format!("{}_valid", self.name), valid);
        record.connect(m, config, instance, &format!("{}_", self.name));
        m.out(instance, &format!("{}_ready", self.name))
    }
}

/// A stream out of a unit.
pub(crate) trait StreamOutPorts<R: Record>: Sized {
    /// Drives the ports on the unit; returns whether an item is taken.
    fn drive(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>) -> Expr;

    /// Leads an inner stream out of the unit.
    fn export(self, m: &mut Module, config: &R::Config, stream: Flow<Wired<R>>);

    /// Declares the ports on the unit, with a queue of two before them.
    fn queue(self, m: &mut Module, config: &R::Config) -> QueueOut<R>;

    /// As [`StreamOutPorts::queue`] at half rate, for records so wide that a register for one is enough to pay.
    fn half(self, m: &mut Module, config: &R::Config) -> QueueOut<R>;

    /// The stream that an instance of the unit puts out.
    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Flow<Wired<R>>;
}

impl<R: Record> StreamOutPorts<R> for Out<R> {
    fn export(self, m: &mut Module, config: &R::Config, stream: Flow<Wired<R>>) {
        m.stream_export(self.name, &stream.plain(config));
        documents::flagged::<R>(m, config, (self.name, "valid"), self.doc);
    }

    fn drive(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>) -> Expr {
        let ready = m.stream_out(self.name, valid, record.named(config));
        documents::flagged::<R>(m, config, (self.name, "valid"), self.doc);
        ready
    }

    fn queue(self, m: &mut Module, config: &R::Config) -> QueueOut<R> {
        QueueOut::new(self, m, config, skid(&layout::<R>(config)))
    }

    fn half(self, m: &mut Module, config: &R::Config) -> QueueOut<R> {
        QueueOut::new(self, m, config, half_buffer(&layout::<R>(config)))
    }

    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Flow<Wired<R>> {
        Flow::from(m, config, instance, self.name)
    }
}

/// A queue whose head is a stream that goes out.
pub(crate) struct QueueOut<R> {
    instance: Instance,
    record: PhantomData<R>,
    /// An item can be pushed in this cycle.
    pub room: Expr,
    /// It holds an item.
    pub holds: Expr,
}

impl<R: Record> QueueOut<R> {
    fn new(ports: Out<R>, m: &mut Module, config: &R::Config, buffer: Module) -> Self {
        let instance = m.instance(&format!("{}_queue", ports.name), buffer);
        let head = Flow::from(m, config, instance, "out");
        ports.export(m, config, head);
        let room = m.out(instance, "in_ready");
        Self { instance, record: PhantomData, room, holds: head.valid }
    }

    /// Pushes a record in cycles where `valid` is set, which implies room; to be called once.
    pub fn push(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>) {
        m.connect(self.instance, "in_valid", valid);
        record.connect(m, config, self.instance, "in_");
    }
}

/// Leads a stream from one unit to another.
pub(crate) fn pipe<R: Record>(
    m: &mut Module,
    config: &R::Config,
    (from, out): (Instance, Out<R>),
    (to, input): (Instance, In<R>),
) {
    let stream = out.of(m, config, from);
    input.feed(m, config, to, stream);
}

/// Leads records that are always taken from one unit to another.
pub(crate) fn pulse<R: Record>(
    m: &mut Module,
    config: &R::Config,
    (from, out): (Instance, PulseOut<R>),
    (to, input): (Instance, PulseIn<R>),
) {
    let pulse = out.of(m, config, from);
    input.feed(m, config, to, pulse);
}

/// Records into a unit that are always taken.
pub(crate) trait PulseInPorts<R: Record>: Sized {
    /// Declares the ports on the unit.
    fn declare(self, m: &mut Module, config: &R::Config) -> Pulse<Wired<R>>;

    /// Feeds an instance of the unit.
    fn feed(self, m: &mut Module, config: &R::Config, instance: Instance, pulse: Pulse<Wired<R>>);
}

impl<R: Record> PulseInPorts<R> for PulseIn<R> {
    fn declare(self, m: &mut Module, config: &R::Config) -> Pulse<Wired<R>> {
        let (valid, values) = m.pulse_in(self.name, self.flag, &layout::<R>(config));
        documents::flagged::<R>(m, config, (self.name, self.flag), self.doc);
        Pulse { valid, record: Bundle::from_values(config, values) }
    }

    fn feed(self, m: &mut Module, config: &R::Config, instance: Instance, pulse: Pulse<Wired<R>>) {
        m.connect(instance, &format!("{}_{}", self.name, self.flag), pulse.valid);
        pulse.record.connect(m, config, instance, &format!("{}_", self.name));
    }
}

/// Records out of a unit that are always taken.
pub(crate) trait PulseOutPorts<R: Record>: Sized {
    /// Drives the ports on the unit.
    fn drive(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>);

    /// Drives them in the cycle after `valid`. The record follows every cycle: who decides on `valid` need not reach it.
    fn registered(
        self,
        m: &mut Module,
        config: &R::Config,
        valid: impl Into<Expr>,
        record: Wired<R>,
    ) -> Pulse<Wired<R>>;

    /// What an instance of the unit puts out.
    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Pulse<Wired<R>>;
}

impl<R: Record> PulseOutPorts<R> for PulseOut<R> {
    fn drive(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>) {
        m.pulse_out(self.name, self.flag, valid, record.named(config));
        documents::flagged::<R>(m, config, (self.name, self.flag), self.doc);
    }

    fn registered(
        self,
        m: &mut Module,
        config: &R::Config,
        valid: impl Into<Expr>,
        record: Wired<R>,
    ) -> Pulse<Wired<R>> {
        let shown = m.reg_reset(&format!("{}_{}", self.name, self.flag), 1, 0);
        m.next(shown, valid);
        let record = record.register(m, config, &format!("{}_", self.name), bit(true));
        self.drive(m, config, shown, record);
        Pulse { valid: shown.expr(), record }
    }

    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Pulse<Wired<R>> {
        let valid = m.out(instance, &format!("{}_{}", self.name, self.flag));
        Pulse { valid, record: Bundle::shown_by(m, config, instance, &format!("{}_", self.name)) }
    }
}

/// A record into a unit in every cycle.
pub(crate) trait InputPorts<R: Record>: Sized {
    /// Declares the ports on the unit.
    fn declare(self, m: &mut Module, config: &R::Config) -> Wired<R>;

    /// Feeds an instance of the unit.
    fn feed(self, m: &mut Module, config: &R::Config, instance: Instance, record: Wired<R>);
}

impl<R: Record> InputPorts<R> for Input<R> {
    fn declare(self, m: &mut Module, config: &R::Config) -> Wired<R> {
        let record = Bundle::input(m, config, &prefix(self.name));
        documents::of_fields::<R>(m, config, self.name);
        record
    }

    fn feed(self, m: &mut Module, config: &R::Config, instance: Instance, record: Wired<R>) {
        record.connect(m, config, instance, &prefix(self.name));
    }
}

/// A record out of a unit in every cycle.
pub(crate) trait OutputPorts<R: Record>: Sized {
    /// Drives the ports on the unit.
    fn drive(self, m: &mut Module, config: &R::Config, record: Wired<R>);

    /// Drives one of the record's bits in the cycle after `happens`.
    fn event(
        self,
        m: &mut Module,
        config: &R::Config,
        which: impl FnOnce(R::In<Places>) -> Option<usize>,
        happens: impl Into<Expr>,
    );

    /// Drives them in the cycle after; after reset they are zero.
    fn events(self, m: &mut Module, config: &R::Config, happens: Wired<R>);

    /// What an instance of the unit puts out.
    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Wired<R>;
}

impl<R: Record> OutputPorts<R> for Output<R> {
    fn event(
        self,
        m: &mut Module,
        config: &R::Config,
        which: impl FnOnce(R::In<Places>) -> Option<usize>,
        happens: impl Into<Expr>,
    ) {
        let place = which(places::<R>(config)).expect("a unit has the events that it tells of");
        let field = &fields::<R>(config)[place];
        let name = format!("{}{}", prefix(self.name), field.name);
        event_out(m, &name, happens);
        m.document(&name, field.doc);
    }

    fn drive(self, m: &mut Module, config: &R::Config, record: Wired<R>) {
        record.output(m, config, &prefix(self.name));
        documents::of_fields::<R>(m, config, self.name);
    }

    fn events(self, m: &mut Module, config: &R::Config, happens: Wired<R>) {
        let prefix = prefix(self.name);
        let registers: Vec<_> = happens
            .named(config)
            .map(|(name, value)| {
                let register = m.reg_reset(&format!("{prefix}{name}"), value.width(), 0);
                m.next(register, value);
                register.expr()
            })
            .collect();
        self.drive(m, config, Bundle::from_values(config, registers));
    }

    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Wired<R> {
        Bundle::shown_by(m, config, instance, &prefix(self.name))
    }
}

/// An integer into or out of a unit in every cycle.
pub(crate) trait WordPort: Copy {
    /// Its name.
    fn name(self) -> &'static str;

    /// What it is for.
    fn doc(self) -> &'static str;

    /// Declares it on the unit.
    fn declare_word(self, m: &mut Module, width: u32) -> Expr {
        let value = m.input(self.name(), width);
        m.document(self.name(), self.doc());
        value
    }

    /// Drives it on the unit.
    fn drive_word(self, m: &mut Module, value: impl Into<Expr>) {
        m.output(self.name(), value);
        m.document(self.name(), self.doc());
    }

    /// Drives it on the unit in the cycle after `happens`.
    fn event(self, m: &mut Module, happens: impl Into<Expr>) {
        event_out(m, self.name(), happens);
        m.document(self.name(), self.doc());
    }

    /// What an instance of the unit puts out.
    fn word_of(self, m: &mut Module, instance: Instance) -> Expr {
        m.out(instance, self.name())
    }

    /// Feeds an instance of the unit.
    fn feed_word(self, m: &mut Module, instance: Instance, value: impl Into<Expr>) {
        m.connect(instance, self.name(), value);
    }
}

impl<W> WordPort for Input<W> {
    fn name(self) -> &'static str {
        self.name
    }

    fn doc(self) -> &'static str {
        self.doc
    }
}

impl<W> WordPort for Output<W> {
    fn name(self) -> &'static str {
        self.name
    }

    fn doc(self) -> &'static str {
        self.doc
    }
}

/// An output that is set in the cycle after `happens`.
pub(crate) fn event_out(m: &mut Module, name: &str, happens: impl Into<Expr>) {
    let happened = m.reg_reset(name, 1, 0);
    m.next(happened, happens);
    m.output(name, happened);
}

/// A register that takes a value at clock edges where `enable` is set.
pub(crate) fn held(m: &mut Module, name: &str, enable: impl Into<Expr>, value: impl Into<Expr>) -> Expr {
    let value = value.into();
    let register = m.reg(name, value.width());
    m.next_if(register, enable, value);
    register.expr()
}
