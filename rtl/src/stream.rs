//! `valid`/`ready` streams: ports `<name>_valid`, `<name>_ready` and `<name>_<field>`.

use super::elaborate::Direction;
use super::expression::Expr;
use super::handle::Wire;
use super::instance::Instance;
use super::interface::StreamDeclaration;
use super::module::Module;

/// A stream inside a module: what the producer shows, and the consumer's answer, to be driven once.
#[derive(Clone)]
pub struct Stream {
    /// An item is there.
    pub valid: Expr,
    /// The item, field by field.
    pub fields: Vec<(String, Expr)>,
    /// The consumer takes the item; drive it with [`Module::ready`].
    pub ready: Wire,
}

/// A stream that enters a module by its ports.
pub type StreamIn = Stream;

impl Stream {
    /// A field by its name.
    #[must_use]
    #[track_caller]
    pub fn field(&self, name: &str) -> Expr {
        match self.fields.iter().find(|(field, _)| field == name) {
            Some((_, value)) => *value,
            None => Expr::poison(1, format!("the stream of `{}` has no field `{name}`", self.valid)),
        }
    }

    /// The item moves in this cycle.
    #[must_use]
    #[track_caller]
    pub fn transfer(&self) -> Expr {
        self.valid & self.ready
    }
}

impl Module {
    /// Declares the ports of a stream that comes in.
    #[track_caller]
    pub fn stream_in(&mut self, name: &str, layout: &[(impl AsRef<str>, u32)]) -> StreamIn {
        let valid = self.input(&format!("{name}_valid"), 1);
        let ready = self.forward(&format!("{name}_ready"), 1);
        self.output(&format!("{name}_ready"), ready);
        let mut fields = vec![];
        for (field, width) in layout {
            let field = field.as_ref();
            fields.push((field.to_string(), self.input(&format!("{name}_{field}"), *width)));
        }
        let names = fields.iter().map(|(field, _): &(String, Expr)| field.as_str());
        self.streams.push(StreamDeclaration::stream(name, Direction::Input, names));
        Stream { valid, fields, ready }
    }

    /// Answers a stream, once.
    #[track_caller]
    pub fn ready(&mut self, stream: &Stream, ready: impl Into<Expr>) {
        self.drive(stream.ready, ready);
    }

    /// Declares and drives the ports of a stream that goes out; returns the consumer's `ready`.
    #[track_caller]
    pub fn stream_out(
        &mut self,
        name: &str,
        valid: impl Into<Expr>,
        fields: impl IntoIterator<Item = (impl AsRef<str>, impl Into<Expr>)>,
    ) -> Expr {
        self.output(&format!("{name}_valid"), valid);
        let ready = self.input(&format!("{name}_ready"), 1);
        let mut names = vec![];
        for (field, value) in fields {
            self.output(&format!("{name}_{}", field.as_ref()), value);
            names.push(field.as_ref().to_owned());
        }
        self.streams.push(StreamDeclaration::stream(name, Direction::Output, names));
        ready
    }

    /// Leads an inner stream out through ports.
    #[track_caller]
    pub fn stream_export(&mut self, name: &str, stream: &Stream) {
        let fields = stream.fields.iter().map(|(field, value)| (field, *value));
        let ready = self.stream_out(name, stream.valid, fields);
        self.ready(stream, ready);
    }

    /// The stream that a child puts out at ports `<port>_…`.
    #[track_caller]
    pub fn stream_from(&mut self, instance: Instance, port: &str) -> Stream {
        let prefix = format!("{port}_");
        let valid = self.out(instance, &format!("{prefix}valid"));
        let mut fields = vec![];
        for field in self.output_fields(instance, port) {
            let value = self.out(instance, &format!("{prefix}{field}"));
            fields.push((field, value));
        }
        let ready = self.forward(&format!("{}_{prefix}ready", instance.name()), 1);
        self.connect(instance, &format!("{prefix}ready"), ready);
        Stream { valid, fields, ready }
    }

    /// Feeds a child's ports `<port>_…` from a stream, field by field.
    #[track_caller]
    pub fn stream_into(&mut self, instance: Instance, port: &str, stream: &Stream) {
        self.connect(instance, &format!("{port}_valid"), stream.valid);
        for (field, value) in &stream.fields {
            self.connect(instance, &format!("{port}_{field}"), *value);
        }
        let ready = self.out(instance, &format!("{port}_ready"));
        self.ready(stream, ready);
    }

    /// Leads a stream from a port of one child to a port of another.
    #[track_caller]
    pub fn pipe(&mut self, (from, out): (Instance, &str), (to, input): (Instance, &str)) {
        let stream = self.stream_from(from, out);
        self.stream_into(to, input, &stream);
    }
}
