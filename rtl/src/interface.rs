//! Which of a module's ports form a stream or a pulse: what test benches and parents need not read off names.

use super::elaborate::Direction;
use super::error::FaultKind;
use super::expression::Expr;
use super::instance::Instance;
use super::module::{Module, Signal, Source};
use serde::{Deserialize, Serialize};

/// Ports that belong together: `<name>_<flag>`, for a stream `<name>_ready`, and `<name>_<field>`.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct StreamDeclaration {
    /// What their names begin with.
    pub name: String,
    /// Which way flag and fields go; `ready` goes the other way.
    pub direction: Direction,
    /// What the flag is called that says whether an item is there, usually `valid`.
    pub flag: String,
    /// Whether the receiver says when it takes the item; without it, every item is taken at once, as a pulse is.
    pub has_ready: bool,
    /// Names of the fields.
    pub fields: Vec<String>,
}

impl StreamDeclaration {
    /// A stream with `valid` and `ready`.
    pub fn stream(name: &str, direction: Direction, fields: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { has_ready: true, ..Self::pulse(name, "valid", direction, fields) }
    }

    /// A record that is always taken.
    pub fn pulse(
        name: &str,
        flag: &str,
        direction: Direction,
        fields: impl IntoIterator<Item = impl Into<String>>,
    ) -> Self {
        let fields = fields.into_iter().map(Into::into).collect();
        Self { name: name.into(), direction, flag: flag.into(), has_ready: false, fields }
    }

    /// The port that says whether an item is there.
    #[must_use]
    pub fn flag_port(&self) -> String {
        format!("{}_{}", self.name, self.flag)
    }

    /// The port by which the receiver takes an item.
    #[must_use]
    pub fn ready_port(&self) -> Option<String> {
        self.has_ready.then(|| format!("{}_ready", self.name))
    }

    /// The ports of the fields, in order.
    pub fn field_ports(&self) -> impl Iterator<Item = String> {
        self.fields.iter().map(|field| format!("{}_{field}", self.name))
    }
}

impl Module {
    /// Says what a port is for, or what a register holds: a comment behind its declaration in the Verilog. Text of several lines becomes
    /// one; where it is empty, nothing is said. Modules that differ in the words of comments alone are one, with those of the first.
    #[track_caller]
    pub fn document(&mut self, port: &str, text: &str) {
        let is_register = |signal: &Signal| &*signal.name == port && matches!(signal.source, Source::Register { .. });
        let is_port = self.ports.iter().any(|declared| declared.shape(self).0 == port);
        if !is_port && !self.signals.iter().any(is_register) {
            let (unit, port) = (self.unit.clone(), port.to_owned());
            return self.fault(FaultKind::UndeclaredPort { unit, port });
        }
        let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
        if !lines.is_empty() {
            self.documents.insert(port.to_owned(), lines.join(" "));
        }
    }

    /// Declares the ports of a record that comes in with a flag and is always taken; returns the flag and the fields.
    #[track_caller]
    pub fn pulse_in(&mut self, name: &str, flag: &str, layout: &[(impl AsRef<str>, u32)]) -> (Expr, Vec<Expr>) {
        let names = layout.iter().map(|(field, _)| field.as_ref());
        let declaration = StreamDeclaration::pulse(name, flag, Direction::Input, names);
        let valid = self.input(&declaration.flag_port(), 1);
        let widths = layout.iter().map(|(_, width)| *width);
        let fields = declaration.field_ports().zip(widths).map(|(port, width)| self.input(&port, width)).collect();
        self.streams.push(declaration);
        (valid, fields)
    }

    /// Declares and drives the ports of a record that goes out with a flag and is always taken.
    #[track_caller]
    pub fn pulse_out(
        &mut self,
        name: &str,
        flag: &str,
        valid: impl Into<Expr>,
        fields: impl IntoIterator<Item = (impl AsRef<str>, impl Into<Expr>)>,
    ) {
        let (names, values): (Vec<_>, Vec<Expr>) =
            fields.into_iter().map(|(field, value)| (field.as_ref().to_owned(), value.into())).unzip();
        let declaration = StreamDeclaration::pulse(name, flag, Direction::Output, names);
        self.output(&declaration.flag_port(), valid);
        for (port, value) in declaration.field_ports().zip(values) {
            self.output(&port, value);
        }
        self.streams.push(declaration);
    }

    /// The fields of a stream that a child puts out; a fault where it declares none of that name.
    #[track_caller]
    pub(super) fn output_fields(&mut self, instance: Instance, stream: &str) -> Vec<String> {
        let Some(child) = self.child(instance).map(|child| &child.module) else { return vec![] };
        if let Some(fields) = child.packed_fields(&format!("{stream}_")) {
            return fields;
        }
        let puts_out =
            |declared: &&StreamDeclaration| declared.direction == Direction::Output && declared.name == stream;
        if let Some(declared) = child.streams.iter().find(puts_out) {
            return declared.fields.clone();
        }
        let (instance, unit) = (instance.name(), child.unit.clone());
        let (direction, port) = ("output stream", stream.to_owned());
        self.fault(FaultKind::UnknownPort { instance, unit, direction, port });
        vec![]
    }
}
