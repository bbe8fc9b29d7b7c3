//! Records as hardware values, and the queues of two that stand at the units' ports.

use pointcore_contract::splat::Field;

use crate::stream::{half_buffer, skid};
use rtl::{Expr, Instance, Module, Reg, Stream, StreamIn, Wire, cat, lit};

/// A value for every field of a record, in order.
#[derive(Clone)]
pub(crate) struct Record(Vec<(String, Expr)>);

impl Record {
    /// Asks for each field's value by its name.
    #[track_caller]
    pub fn new(fields: &[Field], mut value: impl FnMut(&str) -> Expr) -> Self {
        Self(fields.iter().map(|(name, _)| (name.clone(), value(name))).collect())
    }

    /// Input ports `<prefix><field>`.
    #[track_caller]
    pub fn input(m: &mut Module, prefix: &str, fields: &[Field]) -> Self {
        Self(fields.iter().map(|(name, width)| (name.clone(), m.input(&format!("{prefix}{name}"), *width))).collect())
    }

    /// All bits zero.
    #[track_caller]
    pub fn zeros(fields: &[Field]) -> Self {
        Self(fields.iter().map(|(name, width)| (name.clone(), lit(*width, 0))).collect())
    }

    /// The fields of a word that [`Record::pack`] made, the first field on top.
    #[track_caller]
    pub fn unpack(fields: &[Field], word: impl Into<Expr>) -> Self {
        let word = word.into();
        let mut top = word.width();
        let values = fields.iter().map(|(name, width)| {
            top -= *width;
            (name.clone(), word.bits(top + *width - 1, top))
        });
        Self(values.collect())
    }

    /// All fields side by side, the first on top.
    #[track_caller]
    pub fn pack(&self) -> Expr {
        cat(self.0.iter().map(|(_, value)| *value))
    }

    /// Names and values.
    pub fn named(&self) -> impl Iterator<Item = (&str, Expr)> {
        self.0.iter().map(|(name, value)| (name.as_str(), *value))
    }

    /// A field by its name, which must be one of the record's.
    #[track_caller]
    pub fn get(&self, name: &str) -> Expr {
        let field = self.0.iter().find(|(field, _)| field == name);
        field.map(|(_, value)| *value).expect("units ask for fields of their own records")
    }

    /// Those of the values that `fields` names.
    #[track_caller]
    pub fn only(&self, fields: &[Field]) -> Self {
        Self::new(fields, |name| self.get(name))
    }

    /// These fields, each where `selector` is set, else the other's.
    #[track_caller]
    pub fn mux(&self, selector: impl Into<Expr>, other: &Self) -> Self {
        let selector = selector.into();
        Self(self.0.iter().map(|(name, value)| (name.clone(), selector.mux(*value, other.get(name)))).collect())
    }

    /// Registers `<prefix><field>` that take the values at clock edges where `enable` is set.
    #[track_caller]
    pub fn register(&self, m: &mut Module, prefix: &str, enable: impl Into<Expr>) -> Self {
        let enable = enable.into();
        let fields = self.0.iter().map(|(name, value)| {
            let register = m.reg(&format!("{prefix}{name}"), value.width());
            m.next_if(register, enable, *value);
            (name.clone(), register.expr())
        });
        Self(fields.collect())
    }

    /// Drives an instance's inputs `<prefix><field>`.
    #[track_caller]
    pub fn connect(&self, m: &mut Module, instance: Instance, prefix: &str) {
        for (name, value) in &self.0 {
            m.connect(instance, &format!("{prefix}{name}"), *value);
        }
    }

    /// Output ports `<prefix><field>`.
    #[track_caller]
    pub fn output(&self, m: &mut Module, prefix: &str) {
        for (name, value) in &self.0 {
            m.output(&format!("{prefix}{name}"), *value);
        }
    }
}

impl From<&Stream> for Record {
    fn from(stream: &Stream) -> Self {
        Self(stream.fields.clone())
    }
}

/// The bits that hold a record.
pub(crate) fn width(fields: &[Field]) -> u32 {
    fields.iter().map(|(_, width)| *width).sum()
}

/// A record's fields with the widths the front end counts in.
pub(crate) fn layout(record: &[Field]) -> Vec<(&str, u32)> {
    record.iter().map(|(name, width)| (name.as_str(), *width)).collect()
}

/// Declares the ports of a stream of records that comes in.
#[track_caller]
pub(crate) fn stream_in(m: &mut Module, name: &str, record: &[Field]) -> StreamIn {
    m.stream_in(name, &layout(record))
}

/// Declares the ports of a stream that comes in and puts a register behind them; returns what it holds. At half rate: for records so
/// wide that a register for one is enough to pay.
pub(crate) fn half_in(m: &mut Module, name: &str, fields: &[Field]) -> Stream {
    buffered_in(m, name, fields, half_buffer(&layout(fields)))
}

fn buffered_in(m: &mut Module, name: &str, fields: &[Field], buffer: Module) -> Stream {
    let ports = stream_in(m, name, fields);
    let queue = m.instance(&format!("{name}_queue"), buffer);
    m.stream_into(queue, "in", &ports);
    m.stream_from(queue, "out")
}

/// A register behind a queue: what is decided about its record starts from flip-flops, and can be prepared while it comes in.
pub(crate) struct Head {
    /// It holds a record.
    pub valid: Reg,
    /// That record.
    pub record: Record,
    /// It takes what the queue shows.
    pub takes: Wire,
    /// That record.
    pub arriving: Record,
    /// The queue shows one.
    arrives: Expr,
}

impl Head {
    /// Puts the register behind `queue`.
    #[track_caller]
    pub fn new(m: &mut Module, queue: &Stream) -> Self {
        let takes = m.forward("head_takes", 1);
        let valid = m.reg_reset("head_valid", 1, 0);
        m.ready(queue, takes);
        let arriving = Record::from(queue);
        let record = arriving.register(m, "head_", takes);
        Self { valid, record, takes, arriving, arrives: queue.valid }
    }

    /// States when the record leaves; to be called once.
    #[track_caller]
    pub fn leaves(&self, m: &mut Module, leaves: impl Into<Expr>) {
        let leaves = leaves.into();
        m.drive(self.takes, !*self.valid | leaves);
        m.next_if(self.valid, self.takes, self.arrives);
    }

    /// As [`Head::leaves`], but the next record is taken a cycle later, as behind a half buffer it can only come: what takes it then
    /// waits for nothing.
    #[track_caller]
    pub fn leaves_at_half_rate(&self, m: &mut Module, leaves: impl Into<Expr>) {
        let leaves = leaves.into();
        m.drive(self.takes, !*self.valid);
        m.next(self.valid, self.valid.mux(!leaves, self.arrives));
    }
}

/// A queue whose head is a stream that goes out.
pub(crate) struct QueueOut {
    instance: Instance,
    fields: Vec<Field>,
    /// An item can be pushed in this cycle.
    pub room: Expr,
    /// It holds an item.
    pub holds: Expr,
}

/// Declares the ports of a stream that goes out, with a queue of two before them.
#[track_caller]
pub(crate) fn queue_out(m: &mut Module, name: &str, fields: &[Field]) -> QueueOut {
    buffered_out(m, name, fields, skid(&layout(fields)))
}

/// As [`queue_out`] at half rate, for records so wide that a register for one is enough to pay.
#[track_caller]
pub(crate) fn half_out(m: &mut Module, name: &str, fields: &[Field]) -> QueueOut {
    buffered_out(m, name, fields, half_buffer(&layout(fields)))
}

fn buffered_out(m: &mut Module, name: &str, fields: &[Field], buffer: Module) -> QueueOut {
    let instance = m.instance(&format!("{name}_queue"), buffer);
    let head = m.stream_from(instance, "out");
    m.stream_export(name, &head);
    let room = m.out(instance, "in_ready");
    QueueOut { instance, fields: fields.to_vec(), room, holds: head.valid }
}

impl QueueOut {
    /// Pushes a record in cycles where `valid` is set, which implies room; to be called once.
    #[track_caller]
    pub fn push(self, m: &mut Module, valid: impl Into<Expr>, mut value: impl FnMut(&str) -> Expr) {
        m.connect(self.instance, "in_valid", valid);
        for (name, _) in &self.fields {
            m.connect(self.instance, &format!("in_{name}"), value(name));
        }
    }
}
