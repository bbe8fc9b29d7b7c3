//! Builds kept by the hash of everything they depend on, shared by threads and processes.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use super::VerilatedError;

/// File of an entry that holds the hashes of the others.
const CHECKSUMS: &str = "checksums";

/// A folder of finished builds.
#[derive(Debug, Clone)]
pub struct Cache {
    folder: PathBuf,
}

impl Cache {
    /// Tools run in folders of their own, so the path is made absolute.
    pub fn new(folder: PathBuf) -> Self {
        Self { folder: std::path::absolute(&folder).unwrap_or(folder) }
    }

    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// `POINTCORE_CACHE`, else `verilated` in cargo's target folder that this program runs from, else `target/verilated` here.
    pub fn default_folder() -> PathBuf {
        if let Some(folder) = std::env::var_os("POINTCORE_CACHE") {
            return folder.into();
        }
        let program = std::env::current_exe().unwrap_or_default();
        let target = program.ancestors().find(|folder| folder.join("CACHEDIR.TAG").exists());
        target.map_or_else(|| PathBuf::from("target"), Path::to_path_buf).join("verilated")
    }

    /// The folder of entry `key`; `build` fills it, in a folder of its own that is then moved, when it is missing or damaged.
    pub fn entry(
        &self,
        key: &str,
        build: impl FnOnce(&Path) -> Result<(), VerilatedError>,
    ) -> Result<PathBuf, VerilatedError> {
        fs::create_dir_all(&self.folder).map_err(file("create", &self.folder))?;
        let lock_path = self.folder.join(format!("{key}.lock"));
        let lock = File::create(&lock_path).map_err(file("create", &lock_path))?;
        lock.lock().map_err(file("lock", &lock_path))?;
        let entry = self.folder.join(key);
        if intact(&entry) {
            return Ok(entry);
        }
        if entry.exists() {
            fs::remove_dir_all(&entry).map_err(file("remove", &entry))?;
        }
        let scratch = tempfile::Builder::new()
            .prefix(".build-")
            .tempdir_in(&self.folder)
            .map_err(file("create a folder in", &self.folder))?;
        let content = scratch.path().join("content");
        fs::create_dir(&content).map_err(file("create", &content))?;
        build(&content)?;
        let sums = checksums(&content).map_err(file("read", &content))?;
        let path = content.join(CHECKSUMS);
        fs::write(&path, sums).map_err(file("write", &path))?;
        fs::rename(&content, &entry).map_err(file("move a build to", &entry))?;
        Ok(entry)
    }
}

/// The key of a build that depends on `parts`.
pub fn key<'a>(parts: impl IntoIterator<Item = &'a str>) -> String {
    let mut hash = Sha256::new();
    for part in parts {
        // The length keeps ("ab", "c") apart from ("a", "bc").
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part);
    }
    hexadecimal(&hash.finalize())
}

/// Turns an I/O error into ours.
pub fn file(action: &'static str, path: &Path) -> impl FnOnce(std::io::Error) -> VerilatedError {
    let path = path.to_path_buf();
    move |source| VerilatedError::File { action, path, source }
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
