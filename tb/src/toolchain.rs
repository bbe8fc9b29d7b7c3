//! The external tools a simulation needs, found once and checked for their versions.

use std::fmt;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// The oldest Verilator whose generated code the shim is written for.
pub const OLDEST_VERILATOR: Version = Version { major: 5, minor: 6 };
/// The oldest g++ that compiles what Verilator generates (C++17).
pub const OLDEST_COMPILER: Version = Version { major: 7, minor: 0 };

/// Why the tools cannot be used, and what to install.
#[derive(Debug, thiserror::Error)]
pub enum ToolchainError {
    /// The program is not there or does not start.
    #[error("cannot run `{tool}` ({reason}); install it with `apt-get install verilator g++ zlib1g-dev`")]
    Missing {
        /// Name or path that was tried.
        tool: PathBuf,
        /// What the operating system said.
        reason: std::io::Error,
    },
    /// The program answers, but not with a version.
    #[error("`{tool} --version` does not name a version, it says: {answer}")]
    NoVersion {
        /// Name or path that was tried.
        tool: PathBuf,
        /// Its first line.
        answer: String,
    },
    /// The program is older than what the harness needs.
    #[error("`{tool}` is version {found}, {needed} or newer is needed; install it with `apt-get install {package}`")]
    TooOld {
        /// Name or path of the program.
        tool: PathBuf,
        /// Its version.
        found: Version,
        /// The oldest version that works.
        needed: Version,
        /// Debian's name for it.
        package: &'static str,
    },
}

/// Major and minor version of a tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Version {
    /// Number before the dot.
    pub major: u32,
    /// Number after the dot.
    pub minor: u32,
}

impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{:03}", self.major, self.minor)
    }
}

impl Version {
    /// The first word of `text` that reads as `major.minor…`, whatever stands before its first digit.
    #[must_use]
    pub fn first_in(text: &str) -> Option<Self> {
        text.split_whitespace().find_map(|word| {
            let mut numbers = word.trim_start_matches(|c: char| !c.is_ascii_digit()).split('.');
            let version = Self { major: numbers.next()?.parse().ok()?, minor: numbers.next()?.parse().ok()? };
            Some(version)
        })
    }
}

/// A program that answered and is new enough.
#[derive(Debug, Clone)]
pub struct Tool {
    /// Name or path to start it with.
    pub program: PathBuf,
    /// The line it describes itself with; part of every build's cache key.
    pub description: String,
    /// The version in that line.
    pub version: Version,
}

impl Tool {
    fn find(program: &Path, needed: Version, package: &'static str) -> Result<Self, ToolchainError> {
        let tool = program.to_path_buf();
        let output = Command::new(program)
            .arg("--version")
            .output()
            .map_err(|reason| ToolchainError::Missing { tool: tool.clone(), reason })?;
        let answer = String::from_utf8_lossy(&output.stdout).lines().next().unwrap_or_default().to_owned();
        match Version::first_in(&answer) {
            None => Err(ToolchainError::NoVersion { tool, answer }),
            Some(found) if found < needed => Err(ToolchainError::TooOld { tool, found, needed, package }),
            Some(version) => Ok(Self { program: tool, description: answer, version }),
        }
    }
}

/// Verilator, the compiler for its output, and where its run-time sources lie.
#[derive(Debug, Clone)]
pub struct Toolchain {
    /// Translates Verilog to C++.
    pub verilator: Tool,
    /// Compiles and links that C++.
    pub compiler: Tool,
    /// Folder of Verilator's run-time headers and sources.
    pub include: PathBuf,
}

impl Toolchain {
    /// `verilator` and `g++` from the search path, asked for their versions once in a process.
    ///
    /// # Errors
    /// When one of them is missing or too old.
    pub fn find() -> Result<Self, ToolchainError> {
        static FOUND: OnceLock<Toolchain> = OnceLock::new();
        if let Some(found) = FOUND.get() {
            return Ok(found.clone());
        }
        let found = Self::with(Path::new("verilator"), Path::new("g++"))?;
        Ok(FOUND.get_or_init(|| found).clone())
    }

    /// The named programs.
    ///
    /// # Errors
    /// When one of them is missing or too old.
    pub fn with(verilator: &Path, compiler: &Path) -> Result<Self, ToolchainError> {
        let verilator = Tool::find(verilator, OLDEST_VERILATOR, "verilator")?;
        let compiler = Tool::find(compiler, OLDEST_COMPILER, "g++")?;
        let output = Command::new(&verilator.program)
            .args(["--getenv", "VERILATOR_ROOT"])
            .output()
            .map_err(|reason| ToolchainError::Missing { tool: verilator.program.clone(), reason })?;
        let root = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        Ok(Self { verilator, compiler, include: Path::new(&root).join("include") })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_read_from_what_the_tools_print() {
        let verilator = Version::first_in("Verilator 5.006 2023-01-22 rev (Debian 5.006-3)");
        assert_eq!(verilator, Some(OLDEST_VERILATOR));
        assert_eq!(Version::first_in("g++ (Debian 12.2.0-14) 12.2.0"), Some(Version { major: 12, minor: 2 }));
        let nextpnr = Version::first_in("\"nextpnr-ecp5\" -- Next Generation Place and Route (Version nextpnr-0.11.1)");
        assert_eq!(nextpnr, Some(Version { major: 0, minor: 11 }));
        assert_eq!(Version::first_in("no number here"), None);
    }

    #[test]
    fn a_missing_tool_is_named_with_the_command_that_installs_it() {
        let error = Toolchain::with(Path::new("verilator-that-is-not-there"), Path::new("g++")).unwrap_err();
        let text = error.to_string();
        assert!(text.contains("verilator-that-is-not-there"), "{text}");
        assert!(text.contains("apt-get install verilator g++"), "{text}");
    }
}
