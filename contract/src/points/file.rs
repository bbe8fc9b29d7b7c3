//! A configuration as a file has it: the tables of a search core, and what becomes of the neighbors.

use super::config::Config;
use crate::configuration::{Derived, Table, table};
use crate::process::{self, Program, ProgramError, library};
use crate::{bus, search};
use std::sync::Arc;

table! {
    /// What becomes of the neighbors.
    struct Process {
        /// What is made of a query and its neighbors (docs/programs.md): a program of the library, a file, or the text itself.
        program: String = "mls".to_owned(), described("a name such as `\"mls\"`, a path that ends in `.pasm`, a text of several lines"), User;
        /// Queries under way at a time; those that want neighbors are among the search's `threads`.
        process_threads: u32 = 128, range(1, 128), User;
        /// Cycles a neighbor: operators are shared among as many.
        rate: u32 = 1, range(1, 8), User;
        /// Points that the program's memory is asked for together.
        line_points: u32 = 4, described("1, 2, 4, 8"), User;
        /// Lines of points that are kept.
        line_cache: u32 = 256, described("a power of two from 2 to 65536"), User;
    }
}

/// The core, as a file says it.
#[derive(Clone, Copy, Default, serde::Serialize, serde::Deserialize)]
enum Kind {
    #[default]
    #[serde(rename = "points")]
    This,
}

/// A configuration as a file has it: in tables.
#[derive(Default, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    kind: Kind,
    #[serde(default)]
    features: search::config::Features,
    #[serde(default)]
    implementation: search::config::Implementation,
    #[serde(default)]
    process: Process,
    #[serde(default)]
    bus: bus::Config,
}

/// The key `program` does not say what is to be run.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(super) enum SourceError {
    /// A name that no program has.
    #[error("`program` = \"{0}\": expected {known}, a path that ends in `.pasm`, or the text of a program", known = listed())]
    Name(String),
    /// A text that is none.
    #[error(transparent)]
    Text(#[from] ProgramError),
}

fn listed() -> String {
    library::PROGRAMS.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ")
}

/// The program that a file names, or has.
fn program(source: &str) -> Result<Program, SourceError> {
    if source.contains('\n') {
        return Ok(Program::parse("program", source)?);
    }
    match library::PROGRAMS.iter().find(|(name, _)| *name == source) {
        Some((name, _)) => Ok(library::program(name)),
        None => Err(SourceError::Name(source.to_owned())),
    }
}

impl TryFrom<File> for Config {
    type Error = SourceError;

    fn try_from(File { features, implementation, process, bus, .. }: File) -> Result<Self, SourceError> {
        let Process { program: source, process_threads, rate, line_points, line_cache } = process;
        let program = Arc::new(program(&source)?);
        let search: search::Config =
            search::config::File { features, implementation, bus, ..search::config::File::default() }.into();
        let process = process::Config {
            program,
            format: search.geometry,
            index_bits: search.index_bits,
            neighbors: search.neighbors,
            threads: process_threads,
            rate,
            line_points,
            cache_lines: line_cache,
        };
        Ok(Self { search, process })
    }
}

impl From<Config> for File {
    fn from(Config { search, process }: Config) -> Self {
        let search::config::File { features, implementation, bus, .. } = search.into();
        let process::Config { program, threads, rate, line_points, cache_lines, .. } = process;
        let known = library::PROGRAMS.iter().find(|(_, text)| *text == program.text());
        let program = known.map_or_else(|| program.text().to_owned(), |(name, _)| (*name).to_owned());
        let process = Process { program, process_threads: threads, rate, line_points, line_cache: cache_lines };
        Self { kind: Kind::This, features, implementation, process, bus }
    }
}

impl Default for Config {
    fn default() -> Self {
        Self::try_from(File::default()).expect("the library has the program")
    }
}

impl Config {
    /// The tables of a configuration file, besides the line `kind`.
    pub const TABLES: &'static [Table] = &[
        search::Config::TABLES[0],
        search::Config::TABLES[1],
        Table { name: "process", doc: " What becomes of the neighbors.", keys: Process::KEYS },
        search::Config::TABLES[2],
    ];

    /// What follows from the keys.
    pub const DERIVED: &'static [Derived] = search::Config::DERIVED;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        let tiny = "kind = \"points\"\n[process]\nprogram = \"\"\"\n.program tiny\n.kernel\naccumulate ones, 1\n.final\noutput ones, ones\n\"\"\"\n";
        let tiny: Config = toml::from_str(tiny).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(tiny.process.program.name(), "tiny");
        for config in [Config::default(), tiny] {
            assert_eq!(config.validate(), Ok(()));
            let text = toml::to_string_pretty(&config).expect("a configuration is a table");
            assert_eq!(toml::from_str::<Config>(&text), Ok(config), "{text}");
        }
    }

    #[test]
    fn errors_say_what_a_program_may_be() {
        let error = |program: &str| {
            let text = format!("kind = \"points\"\nprocess.program = \"{program}\"");
            toml::from_str::<Config>(&text).unwrap_err().to_string()
        };
        assert!(error("mlt").contains("`program` = \"mlt\": expected covariance, normals, mls"), "{}", error("mlt"));
        assert!(error(".program a\\n.kernel\\n").contains("program:"), "{}", error(".program a\\n.kernel\\n"));
    }
}
