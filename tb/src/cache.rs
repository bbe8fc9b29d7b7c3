//! Results of external tools kept by the hash of everything they depend on, shared by threads and processes.

use std::fmt;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

use crate::scratch::Scratch;
use sha2::{Digest, Sha256};

/// File of an entry that holds the hashes of the others.
const CHECKSUMS: &str = "checksums";

/// The variable of the environment that says where caches are.
const VARIABLE: &str = "POINTCORE_CACHE";
/// What the folder of a build under way is called, before the build's key.
const UNFINISHED: &str = ".build-";

/// A file that could not be read or written.
#[derive(Debug, thiserror::Error)]
#[error("cannot {action} {}: {source}{remedy}", path.display())]
pub struct FileError {
    /// What was tried.
    pub action: &'static str,
    /// The file or folder.
    pub path: PathBuf,
    /// What the operating system said.
    pub source: std::io::Error,
    /// What to do, after a colon; may be empty.
    pub remedy: String,
}

/// A folder of finished builds.
#[derive(Debug, Clone)]
pub struct Cache {
    folder: PathBuf,
}

impl Cache {
    /// The builds in this folder. Tools run in folders of their own, so the path is made absolute.
    #[must_use]
    pub fn new(folder: PathBuf) -> Self {
        Self { folder: std::path::absolute(&folder).unwrap_or(folder) }
    }

    /// Where they lie.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// `POINTCORE_CACHE`, else the folder `name` in cargo's target folder.
    #[must_use]
    pub fn default_folder(name: &str) -> PathBuf {
        std::env::var_os(VARIABLE).map_or_else(|| target_folder().join(name), PathBuf::from)
    }

    /// The folder of entry `key`, if it is there and whole.
    #[must_use]
    pub fn existing(&self, key: &str) -> Option<PathBuf> {
        let entry = self.folder.join(key);
        intact(&entry).then_some(entry)
    }

    /// The folder of entry `key`; `build` fills it, in a folder of its own that is then moved, when it is missing or damaged.
    ///
    /// # Errors
    /// What `build` returns, or a file that cannot be written.
    pub fn entry<E: From<FileError>>(
        &self,
        key: &str,
        build: impl FnOnce(&Path) -> Result<(), E>,
    ) -> Result<PathBuf, E> {
        fs::create_dir_all(&self.folder).map_err(kept("create", &self.folder))?;
        let lock_path = self.lock(key);
        let lock = File::create(&lock_path).map_err(kept("create", &lock_path))?;
        lock.lock().map_err(kept("lock", &lock_path))?;
        let entry = self.folder.join(key);
        if intact(&entry) {
            return Ok(entry);
        }
        if entry.exists() {
            fs::remove_dir_all(&entry).map_err(kept("remove", &entry))?;
        }
        self.sweep();
        let folder = self.folder.join(format!("{UNFINISHED}{key}"));
        let scratch = Scratch::create(folder.clone()).map_err(kept("create", &folder))?;
        let content = scratch.path().join("content");
        fs::create_dir(&content).map_err(kept("create", &content))?;
        build(&content)?;
        let sums = checksums(&content).map_err(file("read", &content))?;
        let path = content.join(CHECKSUMS);
        fs::write(&path, sums).map_err(kept("write", &path))?;
        fs::rename(&content, &entry).map_err(kept("move a build to", &entry))?;
        Ok(entry)
    }

    fn lock(&self, key: &str) -> PathBuf {
        self.folder.join(format!("{key}.lock"))
    }

    /// Removes what killed processes have left: builds whose locks nobody holds.
    fn sweep(&self) {
        for item in fs::read_dir(&self.folder).into_iter().flatten().flatten() {
            let name = item.file_name();
            let Some(key) = name.to_str().and_then(|name| name.strip_prefix(UNFINISHED)) else { continue };
            let is_abandoned = File::open(self.lock(key)).is_ok_and(|lock| lock.try_lock().is_ok());
            if is_abandoned {
                // Another process may be faster.
                _ = fs::remove_dir_all(item.path());
            }
        }
    }
}

/// Cargo's target folder that this program runs from, else `target` here.
#[must_use]
pub fn target_folder() -> PathBuf {
    target_of(&std::env::current_exe().unwrap_or_default())
}

/// What cargo writes into its target folder, whoever made it.
const CARGO_MARK: &str = ".rustc_info.json";

/// The target folder that a program lies in, else `target` here. Absolute, for tools are started in other folders.
fn target_of(program: &Path) -> PathBuf {
    let target = program.ancestors().find(|folder| folder.join(CARGO_MARK).exists());
    let target = target.unwrap_or(Path::new("target"));
    std::path::absolute(target).unwrap_or_else(|_| target.to_path_buf())
}

/// The key of a build that depends on `parts`.
#[must_use]
pub fn key<'a>(parts: impl IntoIterator<Item = &'a str>) -> String {
    let mut hash = Sha256::new();
    for part in parts {
        // The length keeps ("ab", "c") apart from ("a", "bc").
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part);
    }
    hexadecimal(&hash.finalize())
}

/// A hash of all that a value holds, as it is printed for debugging.
#[must_use]
pub fn digest(value: &impl fmt::Debug) -> String {
    struct Hashed(Sha256);
    impl fmt::Write for Hashed {
        fn write_str(&mut self, text: &str) -> fmt::Result {
            self.0.update(text);
            Ok(())
        }
    }
    let mut hash = Hashed(Sha256::new());
    fmt::write(&mut hash, format_args!("{value:?}")).expect("a hash takes everything");
    hexadecimal(&hash.0.finalize())
}

/// Turns an I/O error into ours.
pub fn file(action: &'static str, path: &Path) -> impl FnOnce(std::io::Error) -> FileError {
    let path = path.to_path_buf();
    move |source| FileError { action, path, source, remedy: String::new() }
}

/// As [`file`], of a file in the cache's own folder.
pub(crate) fn kept(action: &'static str, path: &Path) -> impl FnOnce(std::io::Error) -> FileError {
    let error = file(action, path);
    let remedy = format!(": set {VARIABLE} to a folder that can be written");
    move |source| FileError { remedy, ..error(source) }
}

/// Whether every file of the entry still has the contents it was stored with. Loading a truncated library would be fatal.
fn intact(entry: &Path) -> bool {
    match (fs::read_to_string(entry.join(CHECKSUMS)), checksums(entry)) {
        (Ok(stored), Ok(actual)) => stored == actual,
        _ => false,
    }
}

fn checksums(folder: &Path) -> std::io::Result<String> {
    let mut lines = Vec::new();
    for item in fs::read_dir(folder)? {
        let item = item?;
        let name = item.file_name().to_string_lossy().into_owned();
        if name != CHECKSUMS {
            lines.push(format!("{} {name}\n", hexadecimal(&Sha256::digest(fs::read(item.path())?))));
        }
    }
    lines.sort();
    Ok(lines.concat())
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_entry_is_there_once_it_was_built() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let cache = Cache::new(folder.path().to_owned());
        assert_eq!(cache.existing("entry"), None);
        let built = cache.entry("entry", |folder| {
            let path = folder.join("result");
            fs::write(&path, "42").map_err(file("write", &path))
        });
        let built = built.expect("a temporary folder can be written");
        assert_eq!(cache.existing("entry"), Some(built.clone()));
        fs::write(built.join("result"), "4").expect("a temporary folder can be written");
        assert_eq!(cache.existing("entry"), None, "it was damaged");
    }

    #[test]
    fn what_a_killed_process_left_is_removed_by_the_next() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let cache = Cache::new(folder.path().to_owned());
        let build = |key: &str, during: &dyn Fn()| {
            cache.entry(key, |_| {
                during();
                Ok::<_, FileError>(())
            })
        };
        let there = |key: &str| folder.path().join(format!("{UNFINISHED}{key}")).exists();
        fs::create_dir(folder.path().join(format!("{UNFINISHED}killed"))).expect("a temporary folder can be written");
        fs::write(folder.path().join("killed.lock"), "").expect("a temporary folder can be written");
        let within = || {
            assert!(there("outer") && !there("killed"));
            build("inner", &|| assert!(there("outer"), "what is under way stays")).expect("it can be written");
        };
        build("outer", &within).expect("a temporary folder can be written");
        assert!(!there("outer") && !there("inner"));
    }

    #[test]
    fn a_cache_that_cannot_be_written_names_its_variable() {
        let folder = tempfile::tempdir().expect("the system has a temporary folder");
        let file = folder.path().join("file");
        fs::write(&file, "").expect("a temporary folder can be written");
        let error =
            Cache::new(file.join("cache")).entry("entry", |_| Ok::<_, FileError>(())).expect_err("it is a file");
        assert!(error.to_string().contains("POINTCORE_CACHE"), "{error}");
    }

    #[test]
    fn equal_values_have_one_digest() {
        assert_eq!(digest(&[1.5, 2.0]), digest(&vec![1.5, 2.0]));
        assert_ne!(digest(&[1.5, 2.0]), digest(&[1.5, -2.0]));
    }

    #[test]
    fn the_target_folder_is_absolute_wherever_the_program_lies() {
        let here = std::env::current_dir().expect("tests run somewhere");
        assert_eq!(target_of(Path::new("/nowhere/pointcore")), here.join("target"));
        let target = tempfile::tempdir().expect("the system has a temporary folder");
        fs::write(target.path().join(CARGO_MARK), "").expect("a temporary folder can be written");
        assert_eq!(target_of(&target.path().join("debug/pointcore")), target.path());
    }
}
