//! What can be wrong with a text.

/// A text that is no program, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}:{line}:{column}: {fault}")]
pub struct ProgramError {
    /// The file, as its reader calls it.
    pub file: String,
    /// Line, counted from 1.
    pub line: usize,
    /// Character of the line, counted from 1.
    pub column: usize,
    /// What is wrong there.
    pub fault: Fault,
}

/// What is wrong at a place.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    /// A character that no part of a statement begins with.
    #[error("`{0}` has no meaning: names are lower-case letters, digits and underscores; `;` begins a comment")]
    Character(char),
    /// Another part of a statement belongs here.
    #[error("expected {expected}, found {found}")]
    Expected {
        /// What belongs here.
        expected: String,
        /// What is there.
        found: String,
    },
    /// A number that its type does not have.
    #[error("`{number}` is no {ty}: expected {range}")]
    Number {
        /// The number.
        number: String,
        /// Its type.
        ty: &'static str,
        /// What the type has.
        range: &'static str,
    },
    /// A name that nothing has.
    #[error("nothing here is called `{name}`; the closest: {}", .known.join(", "))]
    Unknown {
        /// The name.
        name: String,
        /// Names that would do, the most similar first, not too many of them.
        known: Vec<String>,
    },
    /// A value that this block does not see.
    #[error("`.{section}` does not see `{name}`; it is seen in {seen}")]
    NotHere {
        /// The block.
        section: &'static str,
        /// The name.
        name: String,
        /// Blocks that see it.
        seen: &'static str,
    },
    /// A statement that this block does not have.
    #[error("`{statement}` has no place in `.{section}`; it belongs in {place}")]
    Misplaced {
        /// The statement's first word.
        statement: String,
        /// The block.
        section: String,
        /// Blocks that have it.
        place: &'static str,
    },
    /// A name that is used up.
    #[error("`{0}` is taken; a name is given once, in a `.repeat` with an index: `{0}[i]`")]
    Taken(String),
    /// A word of the language.
    #[error("`{0}` is a word of the language and no name")]
    Reserved(String),
    /// Operands do not suit an operation.
    #[error("`{operation}` of {found}: expected {expected}")]
    Operands {
        /// The operation.
        operation: String,
        /// Types of the operands.
        found: String,
        /// Types that would do.
        expected: String,
    },
    /// A value of another type.
    #[error("{value} is {found}: expected {expected}")]
    Type {
        /// What the value is for.
        value: String,
        /// Its type.
        found: String,
        /// The type that it has to be of.
        expected: String,
    },
    /// A statement that may stand once stands twice.
    #[error("`{0}` stands here for the second time: expected one")]
    Twice(String),
    /// A part that may not be left out.
    #[error("the program ends without {0}")]
    Missing(&'static str),
    /// More than there is room for.
    #[error("{what}: {found}, expected {maximum} at most")]
    TooMany {
        /// Of what.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many there may be.
        maximum: usize,
    },
}

/// Names that an error lists at most.
const SIMILAR_MAX: usize = 6;

impl Fault {
    /// A name that nothing has, where these have a meaning.
    pub(super) fn unknown(name: &str, known: impl IntoIterator<Item = String>) -> Self {
        let mut known: Vec<String> = known.into_iter().collect();
        known.sort_by_cached_key(|other| (strsim::osa_distance(name, other), other.clone()));
        known.dedup();
        known.truncate(SIMILAR_MAX);
        Self::Unknown { name: name.to_owned(), known }
    }

    pub(super) fn expected(expected: impl Into<String>, found: impl Into<String>) -> Self {
        Self::Expected { expected: expected.into(), found: found.into() }
    }
}
