//! Wrong input of every kind, and what the command must say of it: one error that names the file or option, and what would be right.

mod damaged;
mod files;
mod options;
mod scenes;

use super::program::Program;
use std::collections::BTreeMap;
use std::path::Path;

/// The exit code of wrong input.
const WRONG_INPUT: i32 = 2;
/// How the line of an error begins.
const ERROR: &str = "error: ";
/// What an unfinished build is called.
const BUILD: &str = ".build-";
/// What no user should have to read: the program's types and the words of its libraries.
const FOREIGN: [&str; 22] = [
    "panicked",
    "RUST_BACKTRACE",
    "Vec<",
    "Option",
    "Some(",
    "Err(",
    "ParseFloatError",
    "ParseIntError",
    "usize",
    "isize",
    "u16",
    "u32",
    "u64",
    "i32",
    "i64",
    "i128",
    "f64",
    "invalid digit",
    "invalid float literal",
    "cannot parse integer",
    "target type",
    ".rs:",
];

/// A command that must be refused.
#[derive(Clone, Copy, Debug)]
pub struct Refusal {
    /// Its arguments, separated by blanks; variables of its environment before them.
    pub arguments: &'static str,
    /// How the error names what is wrong: a file, an option, a key, a place within.
    pub place: &'static str,
    /// What the error says would be right, or what it has found in its place.
    pub remedy: &'static str,
}

/// A table's rows: arguments, place, remedy.
type Rows = &'static [(&'static str, &'static str, &'static str)];

/// All refusals.
#[must_use]
pub fn cases() -> Vec<Refusal> {
    let tables: [Rows; 4] = [files::ROWS, damaged::ROWS, scenes::ROWS, options::ROWS];
    let refusal = |&(arguments, place, remedy): &_| Refusal { arguments, place, remedy };
    tables.into_iter().flatten().map(refusal).collect()
}

/// Writes the files that refusals are about into a folder.
///
/// # Errors
/// It cannot be written.
pub fn prepare(folder: &Path) -> std::io::Result<()> {
    for name in ["folder", "folder.ply", "folder.toml"] {
        std::fs::create_dir(folder.join(name))?;
    }
    for (name, bytes) in [files::files(), damaged::files(), scenes::files(), options::files()].concat() {
        std::fs::write(folder.join(name), bytes)?;
    }
    Ok(())
}

/// A file's name and its contents.
type File = (&'static str, Vec<u8>);

impl Refusal {
    /// Runs the command in the folder that was prepared; an error says how its refusal falls short.
    ///
    /// # Errors
    /// It is not one clear error, or something is left behind.
    pub fn judge(&self, program: &Program) -> Result<(), String> {
        let before = listing(&program.folder);
        let said = program.run(self.arguments.split(' ').filter(|word| !word.is_empty()))?;
        let error = &said.error;
        let fault = |problem: &str| Err(format!("`pointcore {}`: {problem}\n{error}", self.arguments));
        if said.code != Some(WRONG_INPUT) {
            return fault(&format!("exit code {:?}, expected {WRONG_INPUT}", said.code));
        }
        if !said.out.is_empty() {
            return fault(&format!("prints {}", said.out));
        }
        if error.lines().filter(|line| line.starts_with(ERROR)).count() != 1 {
            return fault("expected one error");
        }
        if let Some(word) = FOREIGN.iter().find(|word| error.contains(*word)) {
            return fault(&format!("speaks of `{word}`"));
        }
        for part in [self.place, self.remedy] {
            if !error.contains(part) {
                return fault(&format!("does not say `{part}`"));
            }
        }
        let after = listing(&program.folder);
        match after.iter().find(|(path, size)| before.get(*path) != Some(*size)) {
            Some((path, _)) => fault(&format!("leaves {path} behind")),
            None if after.len() != before.len() => fault("removes a file"),
            None => Ok(()),
        }
    }
}

/// What is in a folder, by path with size; of caches only what was never finished.
fn listing(folder: &Path) -> BTreeMap<String, u64> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for item in std::fs::read_dir(&folder).into_iter().flatten().flatten() {
            let (path, is_folder) = (item.path(), item.file_type().is_ok_and(|kind| kind.is_dir()));
            let is_of_cache = path.components().any(|part| part.as_os_str() == super::CACHE_FOLDER);
            let is_unfinished = item.file_name().to_string_lossy().starts_with(BUILD);
            if !is_of_cache || is_unfinished {
                let size = if is_folder { 0 } else { item.metadata().map_or(0, |metadata| metadata.len()) };
                found.insert(path.display().to_string(), size);
            }
            folders.extend(is_folder.then_some(path));
        }
    }
    found
}
