//! What travels together, described once: a record is a struct whose fields are words in a model and expressions in hardware, and
//! which says their names, widths and meaning for ports, packets and documents.
//!
//! ```
//! use pointcore_contract::{fields, record};
//!
//! #[derive(Clone)]
//! pub struct Config {
//!     lanes: u32,
//! }
//!
//! /// A beat of squared distances.
//! #[record(config: Config)]
//! pub struct Beat {
//!     /// Closes its leaf.
//!     pub last: bool,
//!     /// Squared distance of each lane's point.
//!     #[count(config.lanes)]
//!     #[bits(24)]
//!     pub distance: [u32; 8],
//! }
//!
//! let names: Vec<_> = fields::<Beat>(&Config { lanes: 2 }).into_iter().map(|field| (field.name, field.width)).collect();
//! assert_eq!(names, [("last".into(), 1), ("distance0".into(), 24), ("distance1".into(), 24)]);
//! ```

use std::fmt::Debug;

/// In which terms a record's values are given.
pub trait Domain: Copy + Debug + Default + 'static {
    /// A value that a model keeps in a `W`.
    type Bits<W: Word>: Copy + Debug + Default;
}

/// The terms of models: integers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Words;

impl Domain for Words {
    type Bits<W: Word> = W;
}

/// An integer that holds the bits of a port.
pub trait Word: Copy + Debug + Default + PartialEq + Eq {
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

/// A field as ports and documents see it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// Its bits.
    pub width: u32,
    /// What every value is below, where not all of its bits' are.
    pub below: Option<u64>,
    /// What it holds.
    pub doc: &'static str,
}

impl Field {
    /// A field without a word on what it holds.
    #[must_use]
    pub fn new(name: impl Into<String>, width: u32) -> Self {
        Self { name: name.into(), width, below: None, doc: "" }
    }
}

/// Meets the values of a record one by one, in the order of its fields, and may change them. It hears no names: a model meets its
/// ports in every cycle.
pub trait Visitor<D: Domain> {
    /// One value.
    fn bits<W: Word>(&mut self, value: &mut D::Bits<W>);
}

/// Values in the order of ports.
pub trait Visit<D: Domain>: Copy + Debug + Default {
    /// What the layout depends on.
    type Config: Clone;

    /// Hands every value of the layout to the visitor.
    fn visit(&mut self, config: &Self::Config, visitor: &mut impl Visitor<D>);
}

/// What travels together; made by [`record`](macro@crate::record).
pub trait Record: Visit<Self::Domain> {
    /// In which terms its values are given.
    type Domain: Domain;
    /// The same record in other terms.
    type In<E: Domain>: Record<Domain = E, Config = Self::Config>;
    /// What it is.
    const DOC: &'static str;

    /// Appends the fields of the layout, in the order of a visit.
    fn describe(config: &Self::Config, fields: &mut Vec<Field>);
}

/// The fields of a record.
#[must_use]
pub fn fields<R: Record>(config: &R::Config) -> Vec<Field> {
    let mut fields = vec![];
    R::describe(config, &mut fields);
    fields
}

/// The bits of a record, all fields side by side.
#[must_use]
pub fn width<R: Record>(config: &R::Config) -> u32 {
    fields::<R>(config).iter().map(|field| field.width).sum()
}

/// Visits a flag, and a record that is there only while it is high.
#[inline]
pub fn visit_optional<R: Record<Domain = Words>>(
    value: &mut Option<R>,
    config: &R::Config,
    visitor: &mut impl Visitor<Words>,
) {
    let mut present = value.is_some();
    let mut record = value.take().unwrap_or_default();
    visitor.bits::<bool>(&mut present);
    record.visit(config, visitor);
    *value = present.then_some(record);
}

/// The values that words hold, one each in the order of a visit.
///
/// # Panics
/// When there are fewer words.
#[must_use]
pub fn read<V: Visit<Words>>(config: &V::Config, words: &[u64]) -> V {
    let mut values = V::default();
    values.visit(config, &mut Reader(words.iter()));
    values
}

/// Writes values to words, one each in the order of a visit.
///
/// # Panics
/// When there are fewer words.
pub fn write<V: Visit<Words>>(config: &V::Config, mut values: V, words: &mut [u64]) {
    values.visit(config, &mut Writer(words.iter_mut()));
}

/// As [`write()`], into a new list.
#[must_use]
pub fn words<V: Visit<Words>>(config: &V::Config, mut values: V) -> Vec<u64> {
    let mut collector = Collector(vec![]);
    values.visit(config, &mut collector);
    collector.0
}

const FEWER_WORDS: &str = "there is a word for each value";

struct Reader<'a>(std::slice::Iter<'a, u64>);

impl Visitor<Words> for Reader<'_> {
    fn bits<W: Word>(&mut self, value: &mut W) {
        *value = W::from_word(*self.0.next().expect(FEWER_WORDS));
    }
}

struct Writer<'a>(std::slice::IterMut<'a, u64>);

impl Visitor<Words> for Writer<'_> {
    fn bits<W: Word>(&mut self, value: &mut W) {
        *self.0.next().expect(FEWER_WORDS) = value.to_word();
    }
}

struct Collector(Vec<u64>);

impl Visitor<Words> for Collector {
    fn bits<W: Word>(&mut self, value: &mut W) {
        self.0.push(value.to_word());
    }
}
