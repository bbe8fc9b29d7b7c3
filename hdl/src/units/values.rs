//! Records of the contract as values of a program: `splat.normal[0]` is a value.
//!
//! A [`Terms`] is a record whose values are those of a [`Program`]. Inputs and outputs of datapaths take names, widths and order from
//! the record's own description, as ports do from a [`Bundle`](super::wires::Bundle).

use pointcore_contract::{Domain, Field, Format, Places, Record, Visitor, Word, fields, places};

use crate::compiler::{Program, Type, Value};

/// The terms of datapaths: values of a program.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Values;

impl Domain for Values {
    type Bits<W: Word> = Value;
}

/// Collects the values of a record.
struct Collector(Vec<Value>);

impl Visitor<Values> for Collector {
    fn bits<W: Word>(&mut self, value: &mut Value) {
        self.0.push(*value);
    }
}

/// Replaces the values of a record.
struct Filler<I>(I);

impl<I: Iterator<Item = Value>> Visitor<Values> for Filler<I> {
    fn bits<W: Word>(&mut self, value: &mut Value) {
        *value = self.0.next().expect("a record has as many values as fields");
    }
}

/// A record of a program's values.
pub(crate) trait Terms: Record<Domain = Values> {
    /// Its values, in the order of its fields.
    fn values(mut self, config: &Self::Config) -> Vec<Value> {
        let mut collector = Collector(vec![]);
        self.visit(config, &mut collector);
        collector.0
    }

    /// The record of what is made of each field.
    fn from_fields(config: &Self::Config, value: impl FnMut(&Field) -> Value) -> Self {
        let mut record = Self::default();
        record.visit(config, &mut Filler(fields::<Self>(config).iter().map(value)));
        record
    }

    /// Every field as an input of the program, its bits as they come: [`Value::as_float`] reads them as a number.
    fn inputs(program: &Program, config: &Self::Config) -> Self {
        Self::from_fields(config, |field| program.input(&field.name, Type::Unsigned(field.width)))
    }

    /// Every field as a uniform of the program that holds a number of `format`.
    fn uniforms(program: &Program, config: &Self::Config, format: Format) -> Self {
        Self::from_fields(config, |field| program.uniform(&field.name, Type::Float(format)))
    }

    /// Declares every field as an output of the program.
    fn outputs(self, program: &Program, config: &Self::Config) {
        let fields = fields::<Self>(config).into_iter().zip(self.values(config));
        fields.for_each(|(field, value)| program.output(&field.name, value));
    }
}

impl<R: Record<Domain = Values>> Terms for R {}

/// Uniforms of a program that are declared where they are first used: among operands the compiler puts the oldest first.
pub(crate) struct Uniforms<'a, R: Record> {
    program: &'a Program,
    kind: Type,
    names: Vec<String>,
    places: R::In<Places>,
}

impl<'a, R: Record> Uniforms<'a, R> {
    /// Uniforms that hold numbers of `format`.
    pub fn new(program: &'a Program, config: &R::Config, format: Format) -> Self {
        Self::of(program, config, Type::Float(format))
    }

    /// Uniforms of one type.
    pub fn of(program: &'a Program, config: &R::Config, kind: Type) -> Self {
        let names = fields::<R>(config).into_iter().map(|field| field.name).collect();
        Self { program, kind, names, places: places::<R>(config) }
    }

    /// Declares one of them, once.
    pub fn declare(&self, field: impl FnOnce(&R::In<Places>) -> Option<usize>) -> Value {
        let place = field(&self.places).expect("datapaths read the uniforms that they have");
        self.program.uniform(&self.names[place], self.kind)
    }
}
