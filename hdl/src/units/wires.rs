//! Records of the contract as expressions: `beat.distances[0]` is a wire.
//!
//! A [`Bundle`] is a record whose values are expressions. Ports, registers and packed words take names, widths and order from the
//! record's own description, so none of them is spelled here.

use std::ops::Deref;

use pointcore_contract::{Domain, Field, Record, Visitor, Word, fields};
use rtl::{Expr, Instance, Module, Reg, cat, lit};

/// The terms of hardware: expressions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Wires;

impl Domain for Wires {
    type Bits<W: Word> = Expr;
}

/// A record of the contract in hardware.
pub(crate) type Wired<R> = <R as Record>::In<Wires>;

/// Collects the expressions of a record.
struct Collector(Vec<Expr>);

impl Visitor<Wires> for Collector {
    fn bits<W: Word>(&mut self, value: &mut Expr) {
        self.0.push(*value);
    }
}

/// Replaces the expressions of a record.
struct Filler<I>(I);

impl<I: Iterator<Item = Expr>> Visitor<Wires> for Filler<I> {
    fn bits<W: Word>(&mut self, value: &mut Expr) {
        *value = self.0.next().expect("a record has as many values as fields");
    }
}

/// A record of expressions.
pub(crate) trait Bundle: Record<Domain = Wires> {
    /// Its expressions, in the order of its fields.
    fn values(mut self, config: &Self::Config) -> Vec<Expr> {
        let mut collector = Collector(vec![]);
        self.visit(config, &mut collector);
        collector.0
    }

    /// The record of these expressions, in the order of its fields.
    fn from_values(config: &Self::Config, values: impl IntoIterator<Item = Expr>) -> Self {
        let mut record = Self::default();
        record.visit(config, &mut Filler(values.into_iter()));
        record
    }

    /// The record of what is made of each field.
    fn from_fields(config: &Self::Config, value: impl FnMut(&Field) -> Expr) -> Self {
        Self::from_values(config, fields::<Self>(config).iter().map(value))
    }

    /// Names and expressions.
    fn named(self, config: &Self::Config) -> impl Iterator<Item = (String, Expr)> {
        fields::<Self>(config).into_iter().map(|field| field.name).zip(self.values(config))
    }

    /// Asserts, while `valid` is set, that each value is below what its field says.
    fn assert_range(self, m: &mut Module, config: &Self::Config, name: &str, valid: Expr) {
        for (field, value) in fields::<Self>(config).iter().zip(self.values(config)) {
            let below = field.below.map(u128::from).filter(|below| *below < 1 << field.width);
            if let Some(below) = below {
                m.assert(&format!("{name}_{}_in_range", field.name), !valid | value.lt_lit(below));
            }
        }
    }

    /// All bits zero.
    fn zeros(config: &Self::Config) -> Self {
        Self::from_fields(config, |field| lit(field.width, 0))
    }

    /// All fields side by side, the first on top.
    fn pack(self, config: &Self::Config) -> Expr {
        cat(self.values(config))
    }

    /// The fields of a word that [`Bundle::pack`] made.
    fn unpack(config: &Self::Config, word: impl Into<Expr>) -> Self {
        let word = word.into();
        let mut top = word.width();
        Self::from_fields(config, |field| {
            top -= field.width;
            word.bits(top + field.width - 1, top)
        })
    }

    /// One of two records.
    fn choose(config: &Self::Config, selector: impl Into<Expr>, when_true: Self, when_false: Self) -> Self {
        let selector = selector.into();
        let pairs = when_true.values(config).into_iter().zip(when_false.values(config));
        Self::from_values(config, pairs.map(|(when_true, when_false)| selector.mux(when_true, when_false)))
    }

    /// Input ports `<prefix><field>`.
    fn input(m: &mut Module, config: &Self::Config, prefix: &str) -> Self {
        Self::from_fields(config, |field| m.input(&format!("{prefix}{}", field.name), field.width))
    }

    /// Output ports `<prefix><field>`.
    fn output(self, m: &mut Module, config: &Self::Config, prefix: &str) {
        self.named(config).for_each(|(name, value)| m.output(&format!("{prefix}{name}"), value));
    }

    /// The outputs `<prefix><field>` of an instance.
    fn shown_by(m: &mut Module, config: &Self::Config, instance: Instance, prefix: &str) -> Self {
        Self::from_fields(config, |field| m.out(instance, &format!("{prefix}{}", field.name)))
    }

    /// Drives an instance's inputs `<prefix><field>`.
    fn connect(self, m: &mut Module, config: &Self::Config, instance: Instance, prefix: &str) {
        self.named(config).for_each(|(name, value)| m.connect(instance, &format!("{prefix}{name}"), value));
    }

    /// Registers `<prefix><field>` that take the values at clock edges where `enable` is set.
    fn register(self, m: &mut Module, config: &Self::Config, prefix: &str, enable: impl Into<Expr>) -> Self {
        let enable = enable.into();
        let registers = Registers::<Self>::new(m, config, prefix);
        registers.next_if(m, config, enable, self);
        registers.record
    }
}

impl<R: Record<Domain = Wires>> Bundle for R {}

/// Names and widths of a record's fields, as the front end takes layouts.
pub(crate) fn layout<R: Record>(config: &R::Config) -> Vec<(String, u32)> {
    fields::<R>(config).into_iter().map(|field| (field.name, field.width)).collect()
}

/// Registers that hold a record, to be told once what they take.
pub(crate) struct Registers<B> {
    record: B,
    registers: Vec<Reg>,
}

impl<B: Bundle> Registers<B> {
    /// Registers `<prefix><field>`, which the Verilog explains in the record's words.
    pub fn new(m: &mut Module, config: &B::Config, prefix: &str) -> Self {
        let register = |field: Field| {
            let name = format!("{prefix}{}", field.name);
            let register = m.reg(&name, field.width);
            m.document(&name, field.doc);
            register
        };
        let registers: Vec<_> = fields::<B>(config).into_iter().map(register).collect();
        Self { record: B::from_values(config, registers.iter().map(|register| register.expr())), registers }
    }

    /// They take a record at every clock edge.
    pub fn next(&self, m: &mut Module, config: &B::Config, record: B) {
        self.registers.iter().zip(record.values(config)).for_each(|(register, value)| m.next(*register, value));
    }

    /// They take a record at clock edges where `enable` is set.
    pub fn next_if(&self, m: &mut Module, config: &B::Config, enable: impl Into<Expr>, record: B) {
        let enable = enable.into();
        let registers = self.registers.iter().zip(record.values(config));
        registers.for_each(|(register, value)| m.next_if(*register, enable, value));
    }
}

/// What they hold.
impl<B> Deref for Registers<B> {
    type Target = B;

    fn deref(&self) -> &B {
        &self.record
    }
}
