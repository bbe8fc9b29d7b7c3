//! A configuration's files: Verilog, and what goes with it.

use crate::BindingError;
use crate::search::CONFIGURATION;
use pointcore::configuration::{self, Configuration};
use pointcore::package::Package;
use pointcore::points::PointsCore;
use pointcore::search::SearchCore;
use pointcore::splat::SplatCore;
use std::path::{Path, PathBuf};

/// Writes the files of a configuration, given as TOML, into a folder, which is made if it is missing; returns their
/// paths. The FuseSoC core among them bears `name`.
///
/// # Errors
/// The configuration is none that the hardware can hold; the name is no file's; the folder cannot be written.
pub fn generate(configuration: &str, folder: &Path, name: &str) -> Result<Vec<PathBuf>, BindingError> {
    let is_word = |character: char| character.is_ascii_alphanumeric() || "_-".contains(character);
    if name.is_empty() || !name.chars().all(is_word) {
        return Err(BindingError::input(format!("the name is {name:?}: expected letters, digits, `_` and `-`")));
    }
    let package = match configuration::parse(Path::new(CONFIGURATION), configuration)? {
        Configuration::Splat(config) => Package::splat(name, &SplatCore::generate(&config)?, &config)?,
        Configuration::Search(config) => Package::search(name, &SearchCore::generate(&config)?, &config)?,
        Configuration::Points(config) => Package::points(name, &PointsCore::generate(&config)?, &config)?,
    };
    std::fs::create_dir_all(folder).map_err(|error| BindingError::write(folder, &error))?;
    let write = |(name, text): (String, String)| {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(|error| BindingError::write(&path, &error))?;
        Ok(path)
    };
    package.files().into_iter().map(|file| (file.name, file.text)).map(write).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ErrorKind;

    const TINY: &str = include_str!("../../../configs/tiny_knn.toml");

    #[test]
    fn the_files_are_those_of_the_package() {
        let folder = tempfile::tempdir().expect("there is room for a folder");
        let paths = generate(TINY, &folder.path().join("a/b"), "tiny_knn").expect("the configuration is valid");
        let read = |name: &str| {
            let path = paths.iter().find(|path| path.ends_with(name)).unwrap_or_else(|| panic!("{name} was written"));
            std::fs::read_to_string(path).expect("it can be read")
        };
        let config = configuration::parse(Path::new("tiny_knn"), TINY).expect("the configuration is valid");
        let design = |config| SearchCore::generate(config).expect("the configuration is valid").design;
        let Configuration::Search(search) = &config else { panic!("it is the search core's") };
        assert_eq!(read("search_top.v"), design(search).verilog());
        assert_eq!(read("config.toml"), config.text());
        assert!(read("search_axi.v").contains("module search_axi") && read("tiny_knn.core").contains("search_axi.v"));
    }

    #[test]
    fn faults_are_told_apart() {
        let folder = tempfile::tempdir().expect("there is room for a folder");
        let kind = |configuration, folder: &Path, name| {
            let error = generate(configuration, folder, name).expect_err("something is wrong");
            assert!(!error.message.is_empty());
            error.kind
        };
        assert_eq!(kind("kind = \"frob\"", folder.path(), "x"), ErrorKind::Input);
        assert_eq!(kind(TINY, folder.path(), "../x"), ErrorKind::Input);
        let file = folder.path().join("file");
        std::fs::write(&file, "").expect("there is room for a file");
        assert_eq!(kind(TINY, &file, "x"), ErrorKind::File);
    }
}
