//! The records that flow through the process core.
//!
//! A word is a value of a program: a float of [`Config::format`], an integer of 32 bits, or a truth value of one.

use super::PARTIAL_SUMS;
use super::config::{BLOCK_WORDS_MAX, Config, WORDS_MAX};
use super::program::Section;
use crate::record;

/// A query under way, by the place that it has in the core.
#[record(config: Config)]
pub struct Thread {
    /// Thread.
    #[bits(config.thread_bits())]
    #[below(config.threads)]
    pub thread: u8,
}

/// Constants of a run.
#[record(config: Config)]
pub struct Settings {
    /// Words of the settings.
    #[count(config.program.settings.len())]
    #[name(config.program.settings.words()[i].name)]
    #[bits(config.word_bits(config.program.settings.words()[i].ty))]
    pub words: [u32; WORDS_MAX],
}

/// Whose neighbor it is, and of what use.
#[record(config: Config)]
pub struct NeighborPlace {
    /// The query.
    pub thread: Thread,
    /// It is the farthest, for `init`; else one of those that `kernel` goes through.
    pub farthest: bool,
    /// There is none: the query has no neighbors.
    pub none: bool,
    /// The last one of its query that `kernel` goes through.
    pub last: bool,
}

/// A neighbor wanted.
#[record(config: Config)]
pub struct Gather {
    /// Whose, and of what use.
    pub place: NeighborPlace,
    /// Its index, where there is one.
    #[bits(config.index_bits)]
    pub index: u32,
}

/// A request for the points of a line, which come in order.
#[record(config: Config)]
pub struct LineFetch {
    /// The line: the points from `line_points · line` on.
    #[bits(config.line_bits())]
    pub line: u32,
}

/// A point as the program sees it.
#[record(config: Config)]
pub struct Neighbor {
    /// Words of the neighbor.
    #[count(config.program.neighbor.len())]
    #[name(config.program.neighbor.words()[i].name)]
    #[bits(config.word_bits(config.program.neighbor.words()[i].ty))]
    pub words: [u32; WORDS_MAX],
}

/// A neighbor with what it was wanted for.
#[record(config: Config)]
pub struct Gathered {
    /// Whose, and of what use.
    pub place: NeighborPlace,
    /// Its words; zeros where there is none.
    pub neighbor: Neighbor,
}

/// What `kernel` takes of a neighbor and its query.
#[record(config: Config)]
pub struct KernelInput {
    /// The query.
    pub thread: Thread,
    /// There is no neighbor: the query has none.
    pub none: bool,
    /// The query's last neighbor.
    pub last: bool,
    /// Words that `kernel` reads besides settings.
    #[count(config.read_by(Section::Kernel).len())]
    #[name(config.word_read_by(Section::Kernel, i).name)]
    #[bits(config.word_bits(config.word_read_by(Section::Kernel, i).ty))]
    pub words: [u32; BLOCK_WORDS_MAX],
}

/// The partial sums of a query's neighbors.
#[record(config: Config)]
pub struct Sums {
    /// The query.
    pub thread: Thread,
    /// Of each word of the sums its partial sums.
    #[count(config.program.sums.len())]
    #[name(format!("{}_{j}", config.program.sums.words()[i].name))]
    #[bits(config.word_bits(config.program.sums.words()[i].ty))]
    pub partial: [[u32; PARTIAL_SUMS]; WORDS_MAX],
}
