//! Hardware configurations as files: which core a file is for is said by its key `kind`, the renderer if it has none.

use pointcore_contract::{search, splat};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use toml::Spanned;

/// A file with a fault.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", path.display())]
pub struct ConfigurationError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong with it.
    pub problem: String,
}

/// A valid configuration.
#[derive(Clone, Debug, PartialEq)]
pub enum Configuration {
    /// Splatting.
    Splat(splat::Config),
    /// Neighbor search.
    Search(search::Config),
}

/// What the key `kind` may say.
#[derive(Clone, Copy, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Splat,
    Search,
}

/// The one key that both cores' files have.
#[derive(Deserialize)]
struct Head {
    kind: Option<Spanned<Kind>>,
}

/// Reads a text file.
///
/// # Errors
/// It cannot be read.
pub fn read_text(path: &Path) -> Result<String, ConfigurationError> {
    std::fs::read_to_string(path).map_err(|error| wrong(path, format!("cannot be read: {error}")))
}

/// The core that a file is for, and the file without the line that says so.
fn split(path: &Path, text: &str) -> Result<(Option<Kind>, String), ConfigurationError> {
    let syntax = |error: toml::de::Error| wrong(path, error.to_string().trim_end());
    let Some(kind) = toml::from_str::<Head>(text).map_err(syntax)?.kind else { return Ok((None, text.to_owned())) };
    // The line's end stays, so that lines keep their numbers.
    let begin = text[..kind.span().start].rfind('\n').map_or(0, |end| end + 1);
    let rest = [&text[..begin], &text[kind.span().end..]].concat();
    Ok((Some(kind.into_inner()), rest))
}

/// Reads a configuration of either core.
///
/// # Errors
/// The text is no such configuration, or one that the hardware cannot hold.
pub fn parse(path: &Path, text: &str) -> Result<Configuration, ConfigurationError> {
    match split(path, text)? {
        (None | Some(Kind::Splat), text) => splat_config(path, &text).map(Configuration::Splat),
        (Some(Kind::Search), text) => search_config(path, &text).map(Configuration::Search),
    }
}

/// Reads a configuration of the search core.
///
/// # Errors
/// The text is no such configuration, or one that the hardware cannot hold.
pub fn parse_search(path: &Path, text: &str) -> Result<search::Config, ConfigurationError> {
    match split(path, text)? {
        (Some(Kind::Search), text) => search_config(path, &text),
        _ => Err(wrong(path, "is for the renderer: a neighbor search needs a file with the line `kind = \"search\"`")),
    }
}

/// A configuration of the search core as a file.
#[must_use]
pub fn search_text(config: &search::Config) -> String {
    "kind = \"search\"\n".to_owned() + &toml::to_string_pretty(config).expect("a configuration is a TOML table")
}

fn splat_config(path: &Path, text: &str) -> Result<splat::Config, ConfigurationError> {
    let config: splat::Config = toml::from_str(text).map_err(|error| wrong(path, error.to_string().trim_end()))?;
    config.validate().map_err(|error| wrong(path, error.to_string()))?;
    Ok(config)
}

fn search_config(path: &Path, text: &str) -> Result<search::Config, ConfigurationError> {
    let config: search::Config = toml::from_str(text).map_err(|error| wrong(path, error.to_string().trim_end()))?;
    config.validate().map_err(|error| wrong(path, error.to_string()))?;
    Ok(config)
}

/// The renderer as it is measured on an ECP5.
///
/// # Panics
/// Never: a test reads the file.
#[must_use]
pub fn ecp5() -> splat::Config {
    let path = Path::new("configs/ecp5.toml");
    match parse(path, include_str!("../../configs/ecp5.toml")) {
        Ok(Configuration::Splat(config)) => config,
        other => unreachable!("{}: {other:?}", path.display()),
    }
}

/// The search core as it is measured on an ECP5.
///
/// # Panics
/// Never: a test reads the file.
#[must_use]
pub fn ecp5_knn() -> search::Config {
    let path = Path::new("configs/ecp5_knn.toml");
    match parse(path, include_str!("../../configs/ecp5_knn.toml")) {
        Ok(Configuration::Search(config)) => config,
        other => unreachable!("{}: {other:?}", path.display()),
    }
}

/// A fault of a configuration file.
#[must_use]
pub fn wrong(path: &Path, problem: impl Into<String>) -> ConfigurationError {
    ConfigurationError { path: path.to_owned(), problem: problem.into() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> Result<Configuration, String> {
        parse(Path::new("file.toml"), text).map_err(|failure| failure.to_string())
    }

    #[test]
    fn a_file_says_which_core_it_is_for() {
        assert!(matches!(parsed("width = 64"), Ok(Configuration::Splat(config)) if config.width == 64));
        assert!(matches!(parsed("kind = \"splat\"\nwidth = 64"), Ok(Configuration::Splat(_))));
        let config = search::Config { lanes: 4, ..search::Config::default() };
        assert!(matches!(parsed(&search_text(&config)), Ok(Configuration::Search(same)) if same == config));
    }

    #[test]
    fn what_is_measured_is_what_the_files_say() {
        assert_eq!(ecp5().heap_levels, 12);
        assert_eq!(ecp5_knn().tree_cache, 0);
    }

    #[test]
    fn errors_name_line_and_key() {
        for (text, part) in [
            ("kind = \"c\"", "expected `splat` or `search`"),
            ("# a comment\nkind = \"search\" # and another\nwidth = 64", "line 3"),
            ("kind = \"search\"\nlanes = 3", "`lanes` = 3"),
            ("lanes = 4", "unknown field `lanes`"),
            ("kind = ", "line 1"),
        ] {
            let message = parsed(text).err().unwrap_or_default();
            assert!(message.contains(part), "{message}");
        }
    }
}
