//! Types of values, and the fields of queries, neighbors, state, settings, sums and outputs.

use std::fmt;

/// Type of a value in the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// A number in the format that the program is run in.
    Float,
    /// Three of them: x, y, z.
    Float3,
    /// 32 bits, signed, two's complement.
    Int,
    /// A truth value.
    Bool,
}

/// Type of a node, and of a word of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Scalar {
    /// A number in the format that the program is run in.
    Float,
    /// 32 bits, signed, two's complement.
    Int,
    /// A truth value.
    Bool,
}

/// The components of a vector, as names have them.
pub(super) const COMPONENTS: [&str; 3] = ["x", "y", "z"];

impl Type {
    pub(super) const NAMED: [(&'static str, Self); 4] =
        [("float", Self::Float), ("float3", Self::Float3), ("int", Self::Int), ("bool", Self::Bool)];

    /// Words that a value has.
    #[must_use]
    pub const fn words(self) -> usize {
        if matches!(self, Self::Float3) { COMPONENTS.len() } else { 1 }
    }

    /// Type of each word.
    #[must_use]
    pub const fn scalar(self) -> Scalar {
        match self {
            Self::Float | Self::Float3 => Scalar::Float,
            Self::Int => Scalar::Int,
            Self::Bool => Scalar::Bool,
        }
    }
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Float => "float",
            Self::Float3 => "float3",
            Self::Int => "int",
            Self::Bool => "bool",
        })
    }
}

/// A named value of a query, a neighbor, or another of the layouts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Type,
}

/// A word of a layout.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// The field's name, with `_x`, `_y`, `_z` behind it for a vector.
    pub name: String,
    /// Its type.
    pub ty: Scalar,
}

/// Where a field lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Position of its first word.
    pub first: usize,
    /// Its type.
    pub ty: Type,
}

/// Fields in the order of their words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    fields: Vec<Field>,
}

impl Layout {
    /// What queries and neighbors begin with.
    pub(super) fn of_point() -> Self {
        Self { fields: vec![Field { name: "position".into(), ty: Type::Float3 }] }
    }

    pub(super) const fn of_fields(fields: Vec<Field>) -> Self {
        Self { fields }
    }

    pub(super) fn push(&mut self, field: Field) {
        self.fields.push(field);
    }

    /// The fields in order.
    #[must_use]
    pub fn fields(&self) -> &[Field] {
        &self.fields
    }

    /// All words in order.
    #[must_use]
    pub fn words(&self) -> Vec<Word> {
        self.fields.iter().flat_map(Field::words).collect()
    }

    /// Number of words.
    #[must_use]
    pub fn len(&self) -> usize {
        self.fields.iter().map(|field| field.ty.words()).sum()
    }

    /// Whether there is no field.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.fields.is_empty()
    }

    /// Where the field of that name lies.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<Place> {
        let mut first = 0;
        for field in &self.fields {
            if field.name == name {
                return Some(Place { first, ty: field.ty });
            }
            first += field.ty.words();
        }
        None
    }
}

impl Field {
    pub(super) fn words(&self) -> Vec<Word> {
        let word = |name| Word { name, ty: self.ty.scalar() };
        match self.ty {
            Type::Float3 => COMPONENTS.iter().map(|axis| word(format!("{}_{axis}", self.name))).collect(),
            _ => vec![word(self.name.clone())],
        }
    }
}
