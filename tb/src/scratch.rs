//! Folders of unfinished work: removed when it ends, however it ends.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Folders that are in use.
static FOLDERS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
/// How often an interruption tries to remove a folder into which tools may be writing still.
const ATTEMPTS: u32 = 5;

/// A folder that is removed when this value is dropped, or by [`remove_all`].
#[derive(Debug)]
pub struct Scratch(PathBuf);

fn folders() -> MutexGuard<'static, Vec<PathBuf>> {
    // A list of paths is whole at any time.
    FOLDERS.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Scratch {
    /// Makes the folder anew; what an earlier run has left of it goes.
    ///
    /// # Errors
    /// It cannot be removed or made.
    pub fn create(path: PathBuf) -> io::Result<Self> {
        if path.exists() {
            fs::remove_dir_all(&path)?;
        }
        folders().push(path.clone());
        let scratch = Self(path);
        fs::create_dir(&scratch.0)?;
        Ok(scratch)
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What cannot be removed now is removed by the next run.
        _ = fs::remove_dir_all(&self.0);
        folders().retain(|folder| *folder != self.0);
    }
}

/// Removes the folders of all unfinished work, for a program that is about to end.
pub fn remove_all() {
    for folder in folders().drain(..) {
        let gone = || fs::remove_dir_all(&folder).is_ok() || !folder.exists();
        (0..ATTEMPTS).any(|_| gone());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_left_of_unfinished_work() {
        let place = tempfile::tempdir().expect("the system has a temporary folder");
        let folder = |name: &str| Scratch::create(place.path().join(name)).expect("a temporary folder can be written");
        let left = || fs::read_dir(place.path()).expect("it is there").count();
        let (first, second) = (folder("first"), folder("second"));
        fs::write(second.path().join("half"), "a result").expect("a temporary folder can be written");
        drop(second);
        assert_eq!(left(), 1);
        fs::write(first.path().join("half"), "a result").expect("a temporary folder can be written");
        std::mem::forget(first);
        let again = folder("first");
        assert_eq!(fs::read_dir(again.path()).expect("it is there").count(), 0, "what an earlier run left is gone");
    }
}
