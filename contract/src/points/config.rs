//! `Config`: a search core and a process core that fit each other.

use super::file::File;
use crate::{Format, process, search};

/// The parameters of one point processor. In a file they stand in the tables of a search core and one more.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(try_from = "File", into = "File")]
pub struct Config {
    /// Of the search, whose bus is that of the whole.
    pub search: search::Config,
    /// Of what becomes of the neighbors.
    pub process: process::Config,
}

/// Two cores of which one is not what the hardware holds, or that do not fit each other.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ConfigError {
    /// The search core.
    #[error(transparent)]
    Search(#[from] search::config::ConfigError),
    /// The process core.
    #[error(transparent)]
    Process(#[from] process::ConfigError),
    /// A number that both have.
    #[error("`{key}` is {search} in the search and {process} behind it: expected the same")]
    Differs {
        /// The key.
        key: &'static str,
        /// In the search.
        search: u32,
        /// In the process core.
        process: u32,
    },
    /// Floats in two formats.
    #[error("the search is in {search} and the program in {process}: expected the same format")]
    Formats {
        /// Format of the search.
        search: Format,
        /// Format of the program.
        process: Format,
    },
}

impl Config {
    /// Checks both cores, and whether what travels between them means the same.
    ///
    /// # Errors
    /// The first parameter that the hardware cannot hold, or that differs.
    pub fn validate(&self) -> Result<(), ConfigError> {
        let Self { search, process } = self;
        search.validate()?;
        process.validate()?;
        let shared =
            [("index_bits", search.index_bits, process.index_bits), ("neighbors", search.neighbors, process.neighbors)];
        if let Some((key, search, process)) = shared.into_iter().find(|(_, search, process)| search != process) {
            return Err(ConfigError::Differs { key, search, process });
        }
        if search.geometry != process.format {
            return Err(ConfigError::Formats { search: search.geometry, process: process.format });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::process::library::program;
    use std::sync::Arc;

    #[test]
    fn errors_name_what_does_not_fit() {
        let search = search::Config::default();
        let process = process::Config {
            program: Arc::new(program("mls")),
            format: search.geometry,
            index_bits: search.index_bits,
            neighbors: search.neighbors,
            threads: 128,
            rate: 1,
            line_points: 4,
            cache_lines: 256,
        };
        let message = |search: &search::Config, process: process::Config| {
            Config { search: search.clone(), process }.validate().unwrap_err().to_string()
        };
        assert_eq!(Config { search: search.clone(), process: process.clone() }.validate(), Ok(()));
        let expected = "`neighbors` is 16 in the search and 8 behind it: expected the same";
        assert_eq!(message(&search, process::Config { neighbors: 8, ..process.clone() }), expected);
        let expected = "the search is in f32-ftz and the program in f24: expected the same format";
        assert_eq!(message(&search, process::Config { format: Format::F24, ..process.clone() }), expected);
        assert_eq!(message(&search, process::Config { rate: 0, ..process }), "`rate` = 0: expected 1 to 8");
    }
}
