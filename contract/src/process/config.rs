//! `Config`: the parameters of one process core, with the ranges the hardware holds.

use super::layout::{Scalar, Word};
use super::operation::Source;
use super::program::{Program, Section};
use super::{PARTIAL_SUMS, STATE_WORDS_MAX};
use crate::Format;
use crate::configuration::OutOfRange;
use crate::splat::config::index_bits;
use std::sync::Arc;

/// Words that a query, a neighbor, the sums and the outputs of a program have at most, each.
pub const WORDS_MAX: usize = 16;

/// Words that a block reads at most besides settings and sums.
pub const BLOCK_WORDS_MAX: usize = 32;

/// Bits of a number of iterations.
pub const ITERATION_BITS: u32 = 16;

/// The parameters of one process core.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// What becomes of queries.
    pub program: Arc<Program>,
    /// Format of its floats.
    pub format: Format,
    /// Bits of a point's index, and of a query's number.
    pub index_bits: u32,
    /// Neighbors of a query at most.
    pub neighbors: u32,
    /// Queries under way at a time.
    pub threads: u32,
    /// Cycles a neighbor.
    pub rate: u32,
    /// Points that are fetched together, one after the other in memory.
    pub line_points: u32,
    /// Lines of points that are kept.
    pub cache_lines: u32,
}

/// A configuration the hardware cannot hold.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ConfigError {
    /// A number lies outside its range.
    #[error(transparent)]
    Range(#[from] OutOfRange),
    /// A number that no bits of an address can choose among.
    #[error("`{key}` = {value}: expected a power of two from {low} to {high}")]
    PowerOfTwo {
        /// The key.
        key: &'static str,
        /// Its value.
        value: u32,
        /// Smallest value allowed.
        low: u32,
        /// Largest value allowed.
        high: u32,
    },
    /// A format the operators cannot compute in.
    #[error("`format` = \"{0}\": expected f32, f24, f32-ftz or f24-ftz")]
    Format(Format),
    /// A program that has too much of something.
    #[error("program `{program}`: {words} words of `{what}`: expected at most {most}")]
    Words {
        /// The program's name.
        program: String,
        /// What there is too much of.
        what: &'static str,
        /// How much.
        words: usize,
        /// How much there may be.
        most: usize,
    },
}

impl Config {
    /// Checks every range.
    ///
    /// # Errors
    /// The first parameter the hardware cannot hold.
    pub fn validate(&self) -> Result<(), ConfigError> {
        let ranges = [
            ("index_bits", self.index_bits, 4, 32),
            ("neighbors", self.neighbors, 1, 64),
            ("threads", self.threads, 1, 128),
            ("rate", self.rate, 1, PARTIAL_SUMS as u32),
        ];
        for (key, value, low, high) in ranges {
            OutOfRange::check(key, value.into(), f64::from(low), f64::from(high))?;
        }
        // A search bears its thread as its number.
        OutOfRange::check("index_bits", self.index_bits.into(), self.thread_bits().into(), 32.0)?;
        let powers = [("line_points", self.line_points, 1, 8), ("cache_lines", self.cache_lines, 2, 65_536)];
        for (key, value, low, high) in powers {
            if !(value.is_power_of_two() && (low..=high).contains(&value)) {
                return Err(ConfigError::PowerOfTwo { key, value, low, high });
            }
        }
        if self.format.exponent != 8 || self.format.mantissa < 15 {
            return Err(ConfigError::Format(self.format));
        }
        let Program { query, neighbor, sums, outputs, .. } = &*self.program;
        let layouts = [("query", query), ("neighbor", neighbor), ("sums", sums), ("outputs", outputs)]
            .map(|(what, layout)| (what, layout.len(), WORDS_MAX));
        let blocks = Section::ALL.map(|section| (section.name(), self.read_by(section).len(), BLOCK_WORDS_MAX));
        match layouts.into_iter().chain(blocks).find(|&(_, words, most)| words > most) {
            Some((what, words, most)) => {
                Err(ConfigError::Words { program: self.program.name().into(), what, words, most })
            }
            None => Ok(()),
        }
    }

    /// Bits of a thread's number.
    #[must_use]
    pub const fn thread_bits(&self) -> u32 {
        index_bits(self.threads)
    }

    /// Bits of a number of neighbors.
    #[must_use]
    pub const fn rank_bits(&self) -> u32 {
        index_bits(self.neighbors + 1)
    }

    /// Bits of a line's number.
    #[must_use]
    pub const fn line_bits(&self) -> u32 {
        let bits = self.index_bits - self.line_points.ilog2();
        if bits == 0 { 1 } else { bits }
    }

    /// Bits of a word.
    #[must_use]
    pub const fn word_bits(&self, ty: Scalar) -> u32 {
        match ty {
            Scalar::Float => self.format.width(),
            Scalar::Int => i32::BITS,
            Scalar::Bool => 1,
        }
    }

    /// What a block reads besides settings and sums, in the order of its ports.
    #[must_use]
    pub fn read_by(&self, section: Section) -> Vec<Source> {
        let sources = self.program.block(section).sources().into_iter();
        sources.filter(|source| !matches!(source, Source::Setting(_) | Source::Sum(_))).collect()
    }

    /// Name and type of the `index`-th of those values.
    ///
    /// # Panics
    /// If there are not as many.
    #[must_use]
    pub fn word_read_by(&self, section: Section, index: usize) -> Word {
        self.program.word(self.read_by(section)[index])
    }
}

const _: () = assert!(STATE_WORDS_MAX <= WORDS_MAX, "a block's words have room for the state's");

#[cfg(test)]
mod tests {
    use super::super::library::program;
    use super::*;

    fn config() -> Config {
        Config {
            program: Arc::new(program("mls")),
            format: Format::F32.flushed(),
            index_bits: 24,
            neighbors: 16,
            threads: 128,
            rate: 1,
            line_points: 4,
            cache_lines: 256,
        }
    }

    #[test]
    fn errors_name_what_is_out_of_range() {
        assert_eq!(config().validate(), Ok(()));
        let message = |config: Config| config.validate().unwrap_err().to_string();
        assert_eq!(message(Config { threads: 129, ..config() }), "`threads` = 129: expected 1 to 128");
        assert_eq!(message(Config { index_bits: 6, ..config() }), "`index_bits` = 6: expected 7 to 32");
        let expected = "`line_points` = 3: expected a power of two from 1 to 8";
        assert_eq!(message(Config { line_points: 3, ..config() }), expected);
        let fields: String = (0..6).map(|field| format!(".neighbor n{field}: float3\n")).collect();
        let text = format!(".program large\n{fields}.kernel\naccumulate a, neighbor.n0\n.final\noutput a, a\n");
        let large = Program::parse("large.pasm", &text).unwrap_or_else(|error| panic!("{error}"));
        let expected = "program `large`: 21 words of `neighbor`: expected at most 16";
        assert_eq!(message(Config { program: Arc::new(large), ..config() }), expected);
    }
}
