//! `valid`/`ready` streams at a unit's border.

use pointcore_contract::Record;
use pointcore_contract::unit::{In, Out, READY};
use rtl::{Expr, Instance, Module, Stream, Wire};

use crate::stream::{fifo_distributed, half_buffer, skid};
use crate::units::documents::{self, prefix};
use crate::units::passage::Passage;
use crate::units::wires::{Bundle, Wired, layout};

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

    /// As [`StreamInPorts::offer`], which is called where nobody asks for the answer.
    fn push(self, m: &mut Module, config: &R::Config, instance: Instance, valid: impl Into<Expr>, record: Wired<R>);

    /// Whether an instance of the unit can take a record in this cycle.
    fn room(self, m: &mut Module, instance: Instance) -> Expr;
}

impl<R: Record> StreamInPorts<R> for In<R> {
    fn declare(self, m: &mut Module, config: &R::Config) -> Flow<Wired<R>> {
        let stream = m.stream_in(self.name, &layout::<R>(config));
        documents::flagged::<R>(m, config, (self.name, self.flag), self.doc);
        let flow: Flow<Wired<R>> = Flow::typed(stream, config);
        flow.record.assert_range(m, config, self.name, flow.valid);
        flow
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
        self.push(m, config, instance, valid, record);
        self.room(m, instance)
    }

    fn push(self, m: &mut Module, config: &R::Config, instance: Instance, valid: impl Into<Expr>, record: Wired<R>) {
        m.connect(instance, &self.port(self.flag), valid);
        record.connect(m, config, instance, &prefix(self.name));
    }

    fn room(self, m: &mut Module, instance: Instance) -> Expr {
        m.out(instance, &self.port(READY))
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

    /// As [`StreamOutPorts::queue`], of `depth` items in look-up tables.
    fn deep(self, m: &mut Module, config: &R::Config, depth: u32) -> QueueOut<R>;

    /// The stream that an instance of the unit puts out.
    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Flow<Wired<R>>;

    /// Whether an instance of the unit puts out a record, and the record: what is taken is said by [`StreamOutPorts::take`].
    fn shown(self, m: &mut Module, config: &R::Config, instance: Instance) -> (Expr, Wired<R>);

    /// States when an instance's record is taken.
    fn take(self, m: &mut Module, instance: Instance, taken: impl Into<Expr>);
}

impl<R: Record> StreamOutPorts<R> for Out<R> {
    fn export(self, m: &mut Module, config: &R::Config, stream: Flow<Wired<R>>) {
        m.stream_export(self.name, &stream.plain(config));
        documents::flagged::<R>(m, config, (self.name, self.flag), self.doc);
    }

    fn drive(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>) -> Expr {
        let ready = m.stream_out(self.name, valid, record.named(config));
        documents::flagged::<R>(m, config, (self.name, self.flag), self.doc);
        ready
    }

    fn queue(self, m: &mut Module, config: &R::Config) -> QueueOut<R> {
        QueueOut::new(self, m, config, skid(&layout::<R>(config)))
    }

    fn half(self, m: &mut Module, config: &R::Config) -> QueueOut<R> {
        QueueOut::new(self, m, config, half_buffer(&layout::<R>(config)))
    }

    fn deep(self, m: &mut Module, config: &R::Config, depth: u32) -> QueueOut<R> {
        QueueOut::new(self, m, config, fifo_distributed(depth, &layout::<R>(config)))
    }

    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Flow<Wired<R>> {
        Flow::from(m, config, instance, self.name)
    }

    fn shown(self, m: &mut Module, config: &R::Config, instance: Instance) -> (Expr, Wired<R>) {
        let record = Bundle::shown_by(m, config, instance, &prefix(self.name));
        (m.out(instance, &self.port(self.flag)), record)
    }

    fn take(self, m: &mut Module, instance: Instance, taken: impl Into<Expr>) {
        m.connect(instance, &self.port(READY), taken);
    }
}

/// A queue whose head is a stream that goes out.
pub(crate) struct QueueOut<R> {
    queue: Passage<R>,
    /// An item can be pushed in this cycle.
    pub room: Expr,
    /// It holds an item.
    pub holds: Expr,
}

impl<R: Record> QueueOut<R> {
    fn new(ports: Out<R>, m: &mut Module, config: &R::Config, buffer: Module) -> Self {
        let queue = Passage::place(m, &format!("{}_queue", ports.name), buffer);
        let head = queue.out(m, config);
        ports.export(m, config, head);
        let room = queue.room(m);
        Self { queue, room, holds: head.valid }
    }

    /// Pushes a record in cycles where `valid` is set, which implies room; to be called once.
    pub fn push(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>) {
        self.queue.push(m, config, valid, record);
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
