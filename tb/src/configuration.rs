//! Hardware configurations as files: which core a file is for is said by its key `core`, core A if it has none.

use pointcore_spec::{core_a, core_b};
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
    CoreA(core_a::Config),
    /// Neighbor search.
    CoreB(core_b::Config),
}

/// What the key `core` may say.
#[derive(Clone, Copy, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
enum CoreName {
    A,
    B,
}

/// The one key that both cores' files have.
#[derive(Deserialize)]
struct Head {
    core: Option<Spanned<CoreName>>,
}

/// Reads a text file.
///
/// # Errors
/// It cannot be read.
pub fn read_text(path: &Path) -> Result<String, ConfigurationError> {
    std::fs::read_to_string(path).map_err(|error| wrong(path, format!("cannot be read: {error}")))
}

/// The core that a file is for, and the file without the line that says so.
fn split(path: &Path, text: &str) -> Result<(Option<CoreName>, String), ConfigurationError> {
    let syntax = |error: toml::de::Error| wrong(path, error.to_string().trim_end());
    let Some(core) = toml::from_str::<Head>(text).map_err(syntax)?.core else { return Ok((None, text.to_owned())) };
    // The line's end stays, so that lines keep their numbers.
    let begin = text[..core.span().start].rfind('\n').map_or(0, |end| end + 1);
    let rest = [&text[..begin], &text[core.span().end..]].concat();
    Ok((Some(core.into_inner()), rest))
}

/// Reads a configuration of either core.
///
/// # Errors
/// The text is no such configuration, or one that the hardware cannot hold.
pub fn parse(path: &Path, text: &str) -> Result<Configuration, ConfigurationError> {
    match split(path, text)? {
        (None | Some(CoreName::A), text) => core_a_config(path, &text).map(Configuration::CoreA),
        (Some(CoreName::B), text) => core_b_config(path, &text).map(Configuration::CoreB),
    }
}

/// Reads a configuration of core B.
///
/// # Errors
/// The text is no such configuration, or one that the hardware cannot hold.
pub fn parse_core_b(path: &Path, text: &str) -> Result<core_b::Config, ConfigurationError> {
    match split(path, text)? {
        (Some(CoreName::B), text) => core_b_config(path, &text),
        _ => Err(wrong(path, "is for core A: a neighbor search needs a file with the line `core = \"b\"`")),
    }
}

/// A configuration of core B as a file.
#[must_use]
pub fn core_b_text(config: &core_b::Config) -> String {
    "core = \"b\"\n".to_owned() + &toml::to_string_pretty(config).expect("a configuration is a TOML table")
}

fn core_a_config(path: &Path, text: &str) -> Result<core_a::Config, ConfigurationError> {
    let config: core_a::Config = toml::from_str(text).map_err(|error| wrong(path, error.to_string().trim_end()))?;
    config.validate().map_err(|error| wrong(path, error.to_string()))?;
    Ok(config)
}

fn core_b_config(path: &Path, text: &str) -> Result<core_b::Config, ConfigurationError> {
    let config: core_b::Config = toml::from_str(text).map_err(|error| wrong(path, error.to_string().trim_end()))?;
    config.validate().map_err(|error| wrong(path, error.to_string()))?;
    Ok(config)
}

/// Core A as it is measured on an ECP5.
///
/// # Panics
/// Never: a test reads the file.
#[must_use]
pub fn ecp5() -> core_a::Config {
    let path = Path::new("configs/ecp5.toml");
    match parse(path, include_str!("../../configs/ecp5.toml")) {
        Ok(Configuration::CoreA(config)) => config,
        other => unreachable!("{}: {other:?}", path.display()),
    }
}

/// Core B as it is measured on an ECP5.
///
/// # Panics
/// Never: a test reads the file.
#[must_use]
pub fn ecp5_knn() -> core_b::Config {
    let path = Path::new("configs/ecp5_knn.toml");
    match parse(path, include_str!("../../configs/ecp5_knn.toml")) {
        Ok(Configuration::CoreB(config)) => config,
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
        assert!(matches!(parsed("width = 64"), Ok(Configuration::CoreA(config)) if config.width == 64));
        assert!(matches!(parsed("core = \"a\"\nwidth = 64"), Ok(Configuration::CoreA(_))));
        let config = core_b::Config { lanes: 4, ..core_b::Config::default() };
        assert!(matches!(parsed(&core_b_text(&config)), Ok(Configuration::CoreB(same)) if same == config));
    }

    #[test]
    fn what_is_measured_is_what_the_files_say() {
        assert_eq!(ecp5().heap_levels, 12);
        assert_eq!(ecp5_knn().tree_cache, 0);
    }

    #[test]
    fn errors_name_line_and_key() {
        for (text, part) in [
            ("core = \"c\"", "expected `a` or `b`"),
            ("# a comment\ncore = \"b\" # and another\nwidth = 64", "line 3"),
            ("core = \"b\"\nlanes = 3", "`lanes` = 3"),
            ("lanes = 4", "unknown field `lanes`"),
            ("core = ", "line 1"),
        ] {
            let message = parsed(text).err().unwrap_or_default();
            assert!(message.contains(part), "{message}");
        }
    }
}
