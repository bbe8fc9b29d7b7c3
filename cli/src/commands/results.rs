//! A folder of results: all of one run, or those of the run before.

use super::Failure;
use pointcore_tb::scratch::Scratch;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

/// Where results lie until all of them are there.
const UNFINISHED: &str = ".unfinished";
/// What in there keeps two runs from writing into one folder.
const LOCK: &str = "lock";

/// Results that are being made.
pub struct Results {
    folder: PathBuf,
    scratch: Scratch,
    lock: File,
    // Dropped last.
    _made: MadeFolders,
}

/// Folders that were not there before, the innermost first; those that are still empty in the end go.
struct MadeFolders(Vec<PathBuf>);

impl MadeFolders {
    fn create(folder: &Path) -> io::Result<Self> {
        let missing = folder.ancestors().take_while(|folder| !folder.exists()).map(Path::to_owned).collect();
        let made = Self(missing);
        fs::create_dir_all(folder)?;
        Ok(made)
    }
}

impl Drop for MadeFolders {
    fn drop(&mut self) {
        // What is not empty stays.
        self.0.iter().for_each(|folder| _ = fs::remove_dir(folder));
    }
}

impl Results {
    /// Begins results in a folder; made if missing.
    pub fn begin(folder: &Path) -> Result<Self, Failure> {
        let failed = |source| Failure::Write { path: folder.to_owned(), source };
        // Tools run elsewhere.
        let folder = std::path::absolute(folder).map_err(failed)?;
        let made = MadeFolders::create(&folder).map_err(failed)?;
        let unfinished = folder.join(UNFINISHED);
        if File::open(unfinished.join(LOCK)).is_ok_and(|lock| lock.try_lock().is_err()) {
            let problem = "another run is writing to it: wait for it, or choose another -o";
            return Err(Failure::Usage(format!("{}: {problem}", folder.display())));
        }
        let scratch = Scratch::create(unfinished).map_err(failed)?;
        let lock = File::create(scratch.path().join(LOCK)).map_err(failed)?;
        lock.lock().map_err(failed)?;
        Ok(Self { folder, scratch, lock, _made: made })
    }

    /// Where to write until they are finished.
    pub fn folder(&self) -> &Path {
        self.scratch.path()
    }

    /// Puts everything in place; files and folders of `own` names that are not among it were another run's, and go.
    pub fn finish(self, own: &[&str]) -> Result<(), Failure> {
        let failed = |source| Failure::Write { path: self.folder.clone(), source };
        for name in own {
            let old = self.folder.join(name);
            if old.is_file() {
                fs::remove_file(&old).map_err(failed)?;
            } else if old.is_dir() {
                fs::remove_dir_all(&old).map_err(failed)?;
            }
        }
        let moved = fs::remove_file(self.folder().join(LOCK)).and_then(|()| place(self.folder(), &self.folder));
        drop(self.lock);
        moved.map_err(failed)
    }
}

/// Moves files from one folder to another, folder by folder.
fn place(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for item in fs::read_dir(from)? {
        let (item, target) = item.map(|item| (item.path(), to.join(item.file_name())))?;
        if item.is_dir() {
            place(&item, &target)?;
        } else {
            fs::rename(&item, &target)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_together_or_not_at_all() {
        let place = tempfile::tempdir().expect("the system has a temporary folder");
        let write = |folder: &Path, name: &str, text: &str| {
            fs::create_dir_all(folder.join(name).parent().expect("it has a folder")).expect("it can be written");
            fs::write(folder.join(name), text).expect("it can be written");
        };
        let begin = || Results::begin(place.path()).unwrap_or_else(|error| panic!("{error}"));
        let read = |name: &str| fs::read_to_string(place.path().join(name)).ok();
        let first = begin();
        write(first.folder(), "a", "1");
        write(first.folder(), "verilog/c", "1");
        assert!(Results::begin(place.path()).is_err(), "two at a time would mix");
        first.finish(&["a", "b"]).unwrap_or_else(|error| panic!("{error}"));
        let broken_off = begin();
        write(broken_off.folder(), "a", "2");
        drop(broken_off);
        assert_eq!((read("a"), read("verilog/c")), (Some("1".into()), Some("1".into())));
        let unfinished = Results::begin(&place.path().join("never/seen")).unwrap_or_else(|error| panic!("{error}"));
        drop(unfinished);
        assert!(!place.path().join("never").exists(), "nothing came of it");
        let last = begin();
        write(last.folder(), "b", "3");
        last.finish(&["a", "b"]).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!((read("a"), read("b"), read("verilog/c")), (None, Some("3".into()), Some("1".into())));
        assert!(!place.path().join(UNFINISHED).exists() && !place.path().join(LOCK).exists());
    }
}
