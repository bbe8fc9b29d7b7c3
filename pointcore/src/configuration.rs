//! Hardware configurations as files: the line `kind` says which core a file is for; its tables are those of `docs/configuration.md`.

mod layout;
#[cfg(test)]
mod reference;

use crate::wording::plain;
use layout::Kind;
use pointcore_contract::{points, search, splat};
use std::path::{Path, PathBuf};

/// A file with a fault.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
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
    /// Neighbor search with a program behind it.
    Points(points::Config),
}

/// Reads a text file.
///
/// # Errors
/// It cannot be read.
pub fn read_text(path: &Path) -> Result<String, ConfigurationError> {
    std::fs::read_to_string(path).map_err(|error| wrong(path, format!("cannot be read: {error}")))
}

/// Reads a configuration of either core.
///
/// # Errors
/// The text is no such configuration, or one that the hardware cannot hold.
pub fn parse(path: &Path, text: &str) -> Result<Configuration, ConfigurationError> {
    let kind = layout::check(text).map_err(|problem| wrong(path, problem))?;
    let syntax = |error: toml::de::Error| wrong(path, plain(&error));
    match kind {
        Kind::Splat => {
            let config: splat::Config = toml::from_str(text).map_err(syntax)?;
            config.validate().map_err(|error| wrong(path, error.to_string()))?;
            Ok(Configuration::Splat(config))
        }
        Kind::Search => {
            let config: search::Config = toml::from_str(text).map_err(syntax)?;
            config.validate().map_err(|error| wrong(path, error.to_string()))?;
            Ok(Configuration::Search(config))
        }
        Kind::Points => {
            let text = with_program(path, text)?;
            let config: points::Config = toml::from_str(&text).map_err(syntax)?;
            config.validate().map_err(|error| wrong(path, error.to_string()))?;
            Ok(Configuration::Points(config))
        }
    }
}

/// The text of a configuration of the point processor, with the program's text in the place of its path, which is relative to the
/// configuration's.
fn with_program(path: &Path, text: &str) -> Result<String, ConfigurationError> {
    let mut file: toml::Table = toml::from_str(text).map_err(|error| wrong(path, plain(&error)))?;
    let program = file.get_mut("process").and_then(|table| table.get_mut("program"));
    let Some(toml::Value::String(program)) = program.filter(|program| program.as_str().is_some_and(is_path)) else {
        return Ok(text.to_owned());
    };
    let place = path.parent().unwrap_or(Path::new("")).join(&*program);
    *program = read_text(&place)?;
    Ok(file.to_string())
}

/// Whether the key `program` is a file's path.
fn is_path(program: &str) -> bool {
    !program.contains('\n') && Path::new(program).extension().is_some_and(|extension| extension == "pasm")
}

/// Reads a configuration of the search core.
///
/// # Errors
/// The text is no such configuration, or one that the hardware cannot hold.
pub fn parse_search(path: &Path, text: &str) -> Result<search::Config, ConfigurationError> {
    match parse(path, text)? {
        Configuration::Search(config) => Ok(config),
        Configuration::Splat(_) => {
            Err(wrong(path, "is for the renderer: a neighbor search needs a file with the line `kind = \"search\"`"))
        }
        Configuration::Points(_) => Err(wrong(
            path,
            "is for the point processor: a neighbor search alone needs a file with the line `kind = \"search\"`",
        )),
    }
}

impl Configuration {
    /// The configuration as a file.
    ///
    /// # Panics
    /// Never: a configuration is a TOML table.
    #[must_use]
    pub fn text(&self) -> String {
        let text = match self {
            Self::Splat(config) => toml::to_string_pretty(config),
            Self::Search(config) => toml::to_string_pretty(config),
            Self::Points(config) => toml::to_string_pretty(config),
        };
        text.expect("a configuration is a TOML table")
    }
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
pub fn knn() -> search::Config {
    let path = Path::new("configs/knn.toml");
    match parse(path, include_str!("../../configs/knn.toml")) {
        Ok(Configuration::Search(config)) => config,
        other => unreachable!("{}: {other:?}", path.display()),
    }
}

/// The point processor as it is measured on an ECP5.
///
/// # Panics
/// Never: a test reads the file.
#[must_use]
pub fn points() -> points::Config {
    let path = Path::new("configs/points.toml");
    match parse(path, include_str!("../../configs/points.toml")) {
        Ok(Configuration::Points(config)) => config,
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
        let splat = splat::Config { width: 64, ..splat::Config::default() };
        assert_eq!(parsed("kind = \"splat\"\n[image]\nwidth = 64"), Ok(Configuration::Splat(splat)));
        let search = search::Config { lanes: 4, ..search::Config::default() };
        assert_eq!(parsed("kind = \"search\"\nimplementation.lanes = 4"), Ok(Configuration::Search(search)));
        let error = parse_search(Path::new("file.toml"), "kind = \"splat\"").unwrap_err().to_string();
        assert!(error.contains("is for the renderer"), "{error}");
    }

    #[test]
    fn what_is_measured_is_what_the_files_say() {
        assert_eq!((ecp5().heap_levels, ecp5().tile_slots), (10, 8));
        assert_eq!(knn().tree_cache, 0);
    }

    /// The named configurations and those written beside their Verilog.
    #[test]
    fn every_named_configuration_is_valid_and_reads_back_the_same() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../configs");
        let mut count = 0;
        for entry in std::fs::read_dir(&folder).expect("the folder is there") {
            let path = entry.expect("the folder is readable").path();
            let config = parse(&path, &read_text(&path).unwrap()).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(parse(&path, &config.text()), Ok(config.clone()));
            let name = path.file_stem().expect("it has a name");
            let generated = folder.with_file_name("generated").join(name).join("config.toml");
            assert_eq!(read_text(&generated).unwrap(), config.text(), "{}", generated.display());
            count += 1;
        }
        assert!(count > 0, "{} is empty", folder.display());
    }

    #[test]
    fn errors_name_line_and_key() {
        for (text, parts) in [
            ("", ["`kind = \"splat\"`", "`kind = \"search\"`"]),
            ("[image]\nwidth = 64", ["is missing", "`kind = \"splat\"`"]),
            ("# a comment\nkind = \"c\"", ["line 2: `kind = \"c\"`", "\"search\""]),
            ("kind = 1", ["line 1: `kind = 1`", "\"splat\""]),
            ("kind = ", ["line 1", "value"]),
            ("kind = \"splat\"\n\nheap_levels = 9", ["line 3: `heap_levels`", "[implementation]"]),
            ("kind = \"splat\"\n[image]\ndivision = \"newton\"", ["line 3: `division`", "[features]"]),
            ("kind = \"splat\"\n[features]\nlanes = 4", ["line 3: `lanes`", "kind = \"search\""]),
            ("kind = \"splat\"\nimage.widht = 4", ["line 2: `widht`", "`width`, `height`, `sampling`"]),
            ("kind = \"splat\"\nimage = 4", ["line 2: `image` is a table", "[image]"]),
            ("kind = \"search\" # a comment\n[image]\nwidth = 64", ["line 2: `image`", "kind = \"splat\""]),
            (
                "kind = \"splat\"\n[implementation]\nsequence_bits = 8",
                ["line 3: `sequence_bits`", "(`heap_levels` + 4)"],
            ),
            ("kind = \"search\"\nsieve_depth = 8", ["line 2: `sieve_depth`", "remove the line"]),
            ("kind = \"search\"\n[bus]\nfrob = 64", ["line 3: `frob`", "`memory_bits`"]),
            ("kind = \"search\"\nfrob = 64", ["line 2: `frob`", "[features], [implementation], [bus]"]),
            ("kind = \"search\"\n[implementation]\nlanes = 3", ["`lanes` = 3", "1, 2, 4 or 8"]),
            ("kind = \"search\"\n[implementation]\nthreads = 33", ["`threads` = 33", "1 to 32"]),
            ("kind = \"search\"\n[implementation]\nthreads = -1", ["line 3", "a whole number from 0 up"]),
            ("kind = \"search\"\n[features]\nneighbor_cache = 32\nindex_bits = 4", ["`index_bits` = 4", "5 to 32"]),
            ("kind = \"splat\"\n[features]\nculling = true", ["line 3", "culling = true"]),
            ("kind = \"splat\"\n[bus]\nmemory_bits = 48", ["`memory_bits` = 48", "64"]),
        ] {
            let message = parsed(text).expect_err(text);
            for part in [&["file.toml: "][..], &parts].concat() {
                assert!(message.contains(part), "`{part}` is missing in: {message}");
            }
        }
    }
}
