//! What the fixed-function datapaths share: records as program inputs and outputs.

use crate::compiler::{Program, Type, Value};
use pointcore_contract::Format;
use pointcore_contract::splat::Field;

/// The fields of a record as inputs of a program.
pub(crate) struct Inputs {
    fields: Vec<(String, Value)>,
}

impl Inputs {
    /// Declares every field as an input.
    pub fn new(program: &Program, record: &[Field]) -> Self {
        let declare = |(name, width): &Field| (name.clone(), program.input(name, Type::Unsigned(*width)));
        Self { fields: record.iter().map(declare).collect() }
    }

    /// A field's bits.
    pub fn bits(&self, name: &str) -> Value {
        let field = self.fields.iter().find(|(field, _)| field == name);
        field.map(|(_, value)| *value).expect("the unit names fields of its own record")
    }

    /// A field that holds a floating-point number.
    pub fn float(&self, format: Format, name: &str) -> Value {
        self.bits(name).reinterpret(Type::Float(format))
    }

    /// Declares a record as outputs: the computed fields, and the input's own of the same name for the others.
    pub fn output(&self, program: &Program, record: &[Field], computed: &[(&str, Value)]) {
        for (name, _) in record {
            match computed.iter().find(|(field, _)| field == name) {
                Some((_, value)) => program.output(name, *value),
                None => program.output(name, self.bits(name)),
            }
        }
    }
}

/// A uniform register of a format.
pub(crate) fn uniform(program: &Program, format: Format, name: &str) -> Value {
    program.uniform(name, Type::Float(format))
}

/// `⟨a, b⟩`, summed from left to right.
pub(crate) fn dot<const N: usize>(a: &[Value; N], b: &[Value; N]) -> Value {
    let products = a.iter().zip(b).map(|(a, b)| *a * *b);
    products.reduce(|sum, product| sum + product).expect("vectors have components")
}
