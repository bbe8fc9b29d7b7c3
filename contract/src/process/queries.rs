//! The records of queries on their way from block to block.

use super::PARTIAL_SUMS;
use super::config::{BLOCK_WORDS_MAX, Config, ITERATION_BITS, WORDS_MAX};
use super::operation::Source;
use super::program::Section;
use super::records::Thread;
use crate::record;

impl Config {
    /// Whether there is an `init`: one that stores something.
    #[must_use]
    pub fn has_init(&self) -> bool {
        !self.program.block(Section::Init).results().stores.is_empty()
    }

    /// Whether there is an `init` that looks at the farthest neighbor.
    #[must_use]
    pub fn has_farthest(&self) -> bool {
        self.has_init() && self.read_by(Section::Init).iter().any(|source| matches!(source, Source::Farthest(_)))
    }

    /// Whether queries may be moved.
    #[must_use]
    pub fn has_movement(&self) -> bool {
        self.program.block(Section::Final).results().movement.is_some()
    }

    /// Whether queries may be searched for anew.
    #[must_use]
    pub fn has_search(&self) -> bool {
        self.program.block(Section::Final).results().search.is_some()
    }

    /// The words of the state that a block stores, in the order of its ports.
    #[must_use]
    pub fn stored_by(&self, section: Section) -> Vec<usize> {
        let stores = self.program.block(section).results().stores.iter();
        stores.flat_map(|store| store.first..store.first + store.words.len()).collect()
    }

    /// The settings that a block reads.
    #[must_use]
    pub fn settings_read_by(&self, section: Section) -> Vec<usize> {
        let setting = |source| match source {
            Source::Setting(word) => Some(word),
            _ => None,
        };
        self.program.block(section).sources().into_iter().filter_map(setting).collect()
    }

    fn source_bits(&self, source: Source) -> u32 {
        self.word_bits(self.program.word(source).ty)
    }

    fn stored_name(&self, section: Section, index: usize) -> String {
        self.program.word(Source::State(self.stored_by(section)[index])).name
    }

    fn stored_bits(&self, section: Section, index: usize) -> u32 {
        self.source_bits(Source::State(self.stored_by(section)[index]))
    }

    fn write_name(&self, section: Section, index: usize) -> String {
        format!("write_{}", self.program.block(section).results().stores[index].field)
    }
}

/// What a query brings besides its number.
#[record(config: Config)]
pub struct QueryWords {
    /// Words of the query, its position first.
    #[count(config.program.query.len())]
    #[name(config.program.word(Source::Query(i)).name)]
    #[bits(config.source_bits(Source::Query(i)))]
    pub words: [u32; WORDS_MAX],
}

/// A query.
#[record(config: Config)]
pub struct Query {
    /// Its number, which its result bears.
    #[bits(config.index_bits)]
    pub number: u32,
    /// What it brings.
    pub words: QueryWords,
}

/// A thread taking up a query.
#[record(config: Config)]
pub struct Start {
    /// The thread.
    pub thread: Thread,
    /// The query.
    pub query: Query,
}

/// A thread that has taken up a query of a number.
#[record(config: Config)]
pub struct Numbered {
    /// The thread.
    pub thread: Thread,
    /// The query's number.
    #[bits(config.index_bits)]
    pub number: u32,
}

/// A thread that has taken up a query, and what it brings.
#[record(config: Config)]
pub struct Fresh {
    /// The thread.
    pub thread: Thread,
    /// What the query brings.
    pub words: QueryWords,
}

/// A search.
#[record(config: Config)]
pub struct Wanted {
    /// Whose.
    pub thread: Thread,
    /// Where.
    #[name(config.program.word(Source::Query(i)).name)]
    #[bits(config.format.width())]
    pub position: [u32; 3],
}

/// What a search found: one neighbor after the other, nearest first, a search after the other. A search that finds
/// nothing has one record with `found` low.
#[record(config: Config)]
pub struct Found {
    /// Whose search.
    pub thread: Thread,
    /// Closes the search.
    pub last: bool,
    /// There is a neighbor.
    pub found: bool,
    /// The neighbor.
    #[bits(config.index_bits)]
    pub index: u32,
}

/// How many neighbors a thread's query has.
#[record(config: Config)]
pub struct Listed {
    /// The thread.
    pub thread: Thread,
    /// How many.
    #[bits(config.rank_bits())]
    pub neighbors: u8,
}

/// A thread whose query is not done.
#[record(config: Config)]
pub struct Again {
    /// The thread.
    pub thread: Thread,
    /// It needs the neighbors of its position; else it goes on with those it has.
    pub search: bool,
}

/// What `init` takes of a query.
#[record(config: Config)]
pub struct InitInput {
    /// The query.
    pub thread: Thread,
    /// Words that `init` reads besides settings.
    #[count(config.read_by(Section::Init).len())]
    #[name(config.word_read_by(Section::Init, i).name)]
    #[bits(config.word_bits(config.word_read_by(Section::Init, i).ty))]
    pub words: [u32; BLOCK_WORDS_MAX],
}

/// What `init` writes.
#[record(config: Config)]
pub struct Stores {
    /// The query.
    pub thread: Thread,
    /// Words of the state.
    #[count(config.stored_by(Section::Init).len())]
    #[name(config.stored_name(Section::Init, i))]
    #[bits(config.stored_bits(Section::Init, i))]
    pub state: [u32; WORDS_MAX],
    /// Which fields of it are written.
    #[count(config.program.block(Section::Init).results().stores.len())]
    #[name(config.write_name(Section::Init, i))]
    pub writes: [bool; WORDS_MAX],
}

/// Constants of a run that `init` reads.
#[record(config: Config)]
pub struct InitSettings {
    /// Words of the settings.
    #[count(config.settings_read_by(Section::Init).len())]
    #[name(config.program.settings.words()[config.settings_read_by(Section::Init)[i]].name)]
    #[bits(config.source_bits(Source::Setting(config.settings_read_by(Section::Init)[i])))]
    pub words: [u32; WORDS_MAX],
}

/// What `final` takes of a query.
#[record(config: Config)]
pub struct FinalInput {
    /// The query.
    pub thread: Thread,
    /// Words that `final` reads besides settings and sums.
    #[count(config.read_by(Section::Final).len())]
    #[name(config.word_read_by(Section::Final, i).name)]
    #[bits(config.word_bits(config.word_read_by(Section::Final, i).ty))]
    pub words: [u32; BLOCK_WORDS_MAX],
    /// Of each word of the sums its partial sums.
    #[count(config.program.sums.len())]
    #[name(format!("{}_{j}", config.program.word(Source::Sum(i)).name))]
    #[bits(config.source_bits(Source::Sum(i)))]
    pub partial: [[u32; PARTIAL_SUMS]; WORDS_MAX],
}

/// What `final` writes.
#[record(config: Config)]
pub struct Change {
    /// Words of the state.
    #[count(config.stored_by(Section::Final).len())]
    #[name(config.stored_name(Section::Final, i))]
    #[bits(config.stored_bits(Section::Final, i))]
    pub state: [u32; WORDS_MAX],
    /// The query's new position.
    #[count(if config.has_movement() { 3 } else { 0 })]
    #[name(format!("moved_{}", config.program.query.words()[i].name))]
    #[bits(config.format.width())]
    pub moved: [u32; 3],
    /// Which fields of the state are written.
    #[count(config.program.block(Section::Final).results().stores.len())]
    #[name(config.write_name(Section::Final, i))]
    pub writes: [bool; WORDS_MAX],
    /// The query has moved there.
    #[when(config.has_movement())]
    #[name("move")]
    pub moves: bool,
}

/// What the program puts out.
#[record(config: Config)]
pub struct OutputWords {
    /// Words of the outputs.
    #[count(config.program.outputs.len())]
    #[name(format!("output_{}", config.program.outputs.words()[i].name))]
    #[bits(config.word_bits(config.program.outputs.words()[i].ty))]
    pub words: [u32; WORDS_MAX],
}

/// What comes of `final`.
#[record(config: Config)]
pub struct Finished {
    /// The query.
    pub thread: Thread,
    /// What leaves if the query does.
    pub outputs: OutputWords,
    /// What is written if it does not.
    pub change: Change,
    /// The query is done.
    pub done: bool,
    /// Else it needs the neighbors of its position.
    #[when(config.has_search())]
    pub search: bool,
}

/// Constants of a run that `final` reads.
#[record(config: Config)]
pub struct FinalSettings {
    /// Words of the settings.
    #[count(config.settings_read_by(Section::Final).len())]
    #[name(config.program.settings.words()[config.settings_read_by(Section::Final)[i]].name)]
    #[bits(config.source_bits(Source::Setting(config.settings_read_by(Section::Final)[i])))]
    pub words: [u32; WORDS_MAX],
}

/// What is written of a query that goes on.
#[record(config: Config)]
pub struct Update {
    /// Its thread, and whether it needs other neighbors.
    pub again: Again,
    /// What `final` writes.
    pub change: Change,
    /// Iterations that are complete.
    #[bits(ITERATION_BITS)]
    pub count: u16,
}

/// A query that leaves.
#[record(config: Config)]
pub struct Outcome {
    /// Its number.
    #[bits(config.index_bits)]
    pub number: u32,
    /// Iterations that it took.
    #[bits(ITERATION_BITS)]
    pub iterations: u16,
    /// It was not done, but had no iteration left.
    pub capped: bool,
    /// What the program puts out.
    pub outputs: OutputWords,
}
