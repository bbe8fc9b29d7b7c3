//! Runs of the built command, as a user starts them.

use super::CACHE_FOLDER;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The variable that says where caches are.
pub const CACHE: &str = "POINTCORE_CACHE";

/// The command and where it is run.
pub struct Program {
    /// The executable.
    pub path: PathBuf,
    /// The folder it is started in.
    pub folder: PathBuf,
}

/// What a run left.
pub struct Said {
    /// Its exit code; `None` where a signal ended it.
    pub code: Option<i32>,
    /// Its output.
    pub out: String,
    /// Its error stream.
    pub error: String,
}

impl Program {
    /// Runs the command. Words before it of the shape `NAME=VALUE` are variables of its environment.
    ///
    /// # Errors
    /// The executable cannot be started.
    pub fn run<'a>(&self, words: impl IntoIterator<Item = &'a str>) -> Result<Said, String> {
        let mut command = Command::new(&self.path);
        command.env(CACHE, self.folder.join(CACHE_FOLDER));
        let mut words = words.into_iter().peekable();
        while let Some((name, value)) = words.peek().and_then(|word| word.split_once('=')) {
            command.env(name, value);
            words.next();
        }
        command.args(words).current_dir(&self.folder).stdin(Stdio::null());
        let output = command.output().map_err(|error| format!("{}: {error}", self.path.display()))?;
        let [out, error] = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
        Ok(Said { code: output.status.code(), out, error })
    }

    /// A file in its folder.
    #[must_use]
    pub fn file(&self, name: impl AsRef<Path>) -> PathBuf {
        self.folder.join(name)
    }
}
