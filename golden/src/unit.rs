//! How a model meets a test bench: one call a cycle, a word a port.
//!
//! A [`Model`] works on typed records. A [`Record`] names its fields in the order of the ports that carry them, once, and
//! [`Ported`] reads and writes words by that description.

/// A unit seen at its ports.
pub trait Unit {
    /// One cycle. `inputs` and `outputs` hold a word for each port of the unit's list in the specification, each in the
    /// list's order, `rst` the first input. Writes what the unit shows in this cycle, then clocks it.
    fn step(&mut self, inputs: &[u64], outputs: &mut [u64]);
}

/// A synchronous circuit whose outputs are functions of its registers.
pub trait Model: Clone {
    /// What the layout of the records depends on.
    type Shape: Copy;
    /// What the unit sees in a cycle.
    type In: Record<Self::Shape>;
    /// What the unit shows in a cycle.
    type Out: Record<Self::Shape>;

    /// The layout of this unit's records.
    fn shape(&self) -> Self::Shape;

    /// What the unit shows in this cycle.
    fn outputs(&self) -> Self::Out;

    /// One clock edge.
    fn clock(&mut self, inputs: &Self::In);
}

/// A value that a port carries.
pub trait Word: Copy {
    /// The port's bits.
    fn to_word(self) -> u64;
    /// The value of a port's bits, which fit by the port's width.
    fn from_word(word: u64) -> Self;
}

macro_rules! integer_words {
    ($($integer:ty),*) => {
        $(impl Word for $integer {
            fn to_word(self) -> u64 {
                u64::from(self)
            }

            fn from_word(word: u64) -> Self {
                word as Self
            }
        })*
    };
}

integer_words!(u8, u16, u32, u64);

impl Word for bool {
    fn to_word(self) -> u64 {
        u64::from(self)
    }

    fn from_word(word: u64) -> Self {
        word != 0
    }
}

/// Meets the fields of a record one by one and may change them.
pub trait Visitor {
    /// One field.
    fn field(&mut self, name: &str, value: &mut impl Word);

    /// Fields `name_0`, `name_1`, …
    fn fields(&mut self, name: &str, values: &mut [impl Word]);

    /// What precedes the names of the fields that follow.
    fn prefix(&mut self, prefix: &'static str);
}

/// Fields in port order.
pub trait Record<S>: Default {
    /// Hands every field of the layout to the visitor.
    fn visit(&mut self, shape: S, visitor: &mut impl Visitor);
}

/// Visits a record that is there only while the flag before it is high, and its fields by names that begin with `prefix`.
pub fn optional<S, T: Record<S>>(
    visitor: &mut impl Visitor,
    shape: S,
    prefix: &'static str,
    flag: &str,
    value: &mut Option<T>,
) {
    let mut present = value.is_some();
    let mut record = value.take().unwrap_or_default();
    visitor.prefix(prefix);
    visitor.field(flag, &mut present);
    record.visit(shape, visitor);
    visitor.prefix("");
    *value = present.then_some(record);
}

/// Visits `valid` and the fields of a stream, without the `ready` that runs the other way.
pub fn stream<S, T: Record<S>>(visitor: &mut impl Visitor, shape: S, prefix: &'static str, value: &mut Option<T>) {
    optional(visitor, shape, prefix, "valid", value);
}

/// What a unit sees that one stream runs through, ports `in` and `out`.
#[derive(Clone, Copy, Debug, Default)]
pub struct ThroughIn<T> {
    /// The item on offer.
    pub input: Option<T>,
    /// Whether the consumer is ready.
    pub out_ready: bool,
}

/// What a unit shows that one stream runs through.
#[derive(Clone, Copy, Debug, Default)]
pub struct ThroughOut<T> {
    /// Whether an item is accepted.
    pub in_ready: bool,
    /// The item on offer.
    pub out: Option<T>,
}

impl<S: Copy, T: Record<S>> Record<S> for ThroughIn<T> {
    fn visit(&mut self, shape: S, visitor: &mut impl Visitor) {
        stream(visitor, shape, "in_", &mut self.input);
        visitor.field("out_ready", &mut self.out_ready);
    }
}

impl<S: Copy, T: Record<S>> Record<S> for ThroughOut<T> {
    fn visit(&mut self, shape: S, visitor: &mut impl Visitor) {
        visitor.field("in_ready", &mut self.in_ready);
        stream(visitor, shape, "out_", &mut self.out);
    }
}

/// A model with its ports as words.
#[derive(Clone, Debug)]
pub struct Ported<M> {
    reset: M,
    model: M,
}

impl<M: Model> Ported<M> {
    /// Wires up a model that is in its initial state.
    pub fn new(model: M) -> Self {
        Self { reset: model.clone(), model }
    }
}

impl<M: Model> Unit for Ported<M> {
    fn step(&mut self, inputs: &[u64], outputs: &mut [u64]) {
        let shape = self.model.shape();
        write(shape, self.model.outputs(), outputs);
        let (rst, ports) = inputs.split_first().expect("every unit has the input rst");
        if *rst == 0 {
            self.model.clock(&read(shape, ports));
        } else {
            self.model.clone_from(&self.reset);
        }
    }
}

/// The record that words hold, one a field in port order.
#[must_use]
pub fn read<S, R: Record<S>>(shape: S, words: &[u64]) -> R {
    let mut record = R::default();
    record.visit(shape, &mut Reader(words.iter()));
    record
}

/// Writes a record to words, one a field in port order.
pub fn write<S, R: Record<S>>(shape: S, mut record: R, words: &mut [u64]) {
    record.visit(shape, &mut Writer(words.iter_mut()));
}

const FEWER_WORDS: &str = "there is a word for each port of the unit's list";

/// Fills a record from words.
struct Reader<'a>(std::slice::Iter<'a, u64>);

impl Visitor for Reader<'_> {
    fn field(&mut self, _name: &str, value: &mut impl Word) {
        *value = Word::from_word(*self.0.next().expect(FEWER_WORDS));
    }

    fn fields(&mut self, name: &str, values: &mut [impl Word]) {
        values.iter_mut().for_each(|value| self.field(name, value));
    }

    fn prefix(&mut self, _prefix: &'static str) {}
}

/// Writes a record to words.
struct Writer<'a>(std::slice::IterMut<'a, u64>);

impl Visitor for Writer<'_> {
    fn field(&mut self, _name: &str, value: &mut impl Word) {
        *self.0.next().expect(FEWER_WORDS) = value.to_word();
    }

    fn fields(&mut self, name: &str, values: &mut [impl Word]) {
        values.iter_mut().for_each(|value| self.field(name, value));
    }

    fn prefix(&mut self, _prefix: &'static str) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy, Debug, Default)]
    struct Count {
        value: u32,
    }

    impl Record<()> for Count {
        fn visit(&mut self, (): (), visitor: &mut impl Visitor) {
            visitor.field("value", &mut self.value);
        }
    }

    impl Model for Count {
        type Shape = ();
        type In = Self;
        type Out = Self;

        fn shape(&self) {}

        fn outputs(&self) -> Self {
            *self
        }

        fn clock(&mut self, inputs: &Self) {
            self.value += inputs.value;
        }
    }

    #[test]
    fn shows_then_clocks_then_resets() {
        let mut unit = Ported::new(Count { value: 7 });
        let shown = [[0, 1], [0, 2], [1, 3], [0, 4], [0, 0]].map(|inputs| {
            let mut outputs = [0];
            unit.step(&inputs, &mut outputs);
            outputs[0]
        });
        assert_eq!(shown, [7, 8, 10, 7, 11]);
    }
}
