//! The synthesis tools: of the search path where they are new enough, else those that `make setup-fpga` installs.

use super::SynthesisError;
use pointcore_tb::cache::{file, target_folder};
use pointcore_tb::toolchain::Version;
use std::convert::Infallible;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::Duration;

/// Older versions give larger and slower results, which would not compare.
const OLDEST_YOSYS: &str = "0.60";
/// The same for place and route.
const OLDEST_NEXTPNR: &str = "0.9";
/// Lines of a failed tool's output that an error repeats.
const LAST_LINES: usize = 12;
/// How often a process is looked after: of what it has taken so far a tenth, within these limits.
const SHORTEST_PAUSE: Duration = Duration::from_millis(2);
/// See there.
const LONGEST_PAUSE: Duration = Duration::from_secs(5);

/// A program that answered and is new enough.
#[derive(Clone, Debug)]
pub(crate) struct Tool {
    program: PathBuf,
    /// What it says of its version; part of every key.
    pub description: String,
}

impl Tool {
    /// `yosys`.
    pub fn yosys() -> Result<Self, SynthesisError> {
        Self::find("yosys", OLDEST_YOSYS)
    }

    /// `nextpnr-<family>`.
    pub fn nextpnr(program: &'static str) -> Result<Self, SynthesisError> {
        Self::find(program, OLDEST_NEXTPNR)
    }

    fn find(name: &'static str, needed: &'static str) -> Result<Self, SynthesisError> {
        let packaged = format!("yowasp-{name}");
        let installed = target_folder().join("tools/bin").join(&packaged);
        let candidates = [PathBuf::from(name), PathBuf::from(packaged), installed];
        let mut found = candidates.iter().filter_map(|program| describe(program));
        let usable = found.find(|(_, _, version)| Some(*version) >= Version::first_in(needed));
        let (program, description, _) = usable.ok_or(SynthesisError::Missing { tool: name, needed })?;
        Ok(Self { program: program.to_path_buf(), description })
    }

    /// Runs it in a folder. Its files are named relative to that: the packaged tools see nothing else.
    pub fn run(&self, unit: &str, folder: &Path, arguments: &[&str]) -> Result<(), SynthesisError> {
        match self.run_while(unit, folder, arguments, || None::<Infallible>)? {
            Ending::Done => Ok(()),
            Ending::Stopped(never) => match never {},
        }
    }

    /// The same, but stopped as soon as there is a reason to.
    pub fn run_while<R>(
        &self,
        unit: &str,
        folder: &Path,
        arguments: &[&str],
        reason: impl Fn() -> Option<R>,
    ) -> Result<Ending<R>, SynthesisError> {
        let mut command = Command::new(&self.program);
        command.args(arguments).current_dir(folder).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().map_err(file("start", &self.program))?;
        let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
        let (status, text) = thread::scope(|scope| {
            let [stdout, stderr] = [scope.spawn(|| all_of(stdout)), scope.spawn(|| all_of(stderr))];
            let status = wait(&mut child, reason);
            let text = [stdout, stderr].map(|reader| reader.join().expect("reading does not panic")).concat();
            (status, text)
        });
        match status.map_err(file("wait for", &self.program))? {
            Ok(status) if status.success() => return Ok(Ending::Done),
            Ok(_) => {}
            Err(reason) => return Ok(Ending::Stopped(reason)),
        }
        let text = String::from_utf8_lossy(&text);
        let lines: Vec<_> = text.lines().collect();
        let output = lines[lines.len().saturating_sub(LAST_LINES)..].join("\n");
        Err(SynthesisError::Tool { tool: self.program.clone(), unit: unit.to_owned(), output })
    }
}

/// How a tool came to its end.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Ending<R> {
    /// By itself.
    Done,
    /// It was stopped, for that reason.
    Stopped(R),
}

/// What can be read until the end.
fn all_of(pipe: Option<impl Read>) -> Vec<u8> {
    let mut text = Vec::new();
    // What a stopped tool said last may be lost.
    pipe.into_iter().for_each(|mut pipe| _ = pipe.read_to_end(&mut text));
    text
}

/// Waits for the end of a process, or for a reason to stop it.
fn wait<R>(child: &mut Child, reason: impl Fn() -> Option<R>) -> io::Result<Result<ExitStatus, R>> {
    let (mut pause, mut waited) = (SHORTEST_PAUSE, Duration::ZERO);
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Ok(status));
        }
        if let Some(reason) = reason() {
            child.kill()?;
            child.wait()?;
            return Ok(Err(reason));
        }
        thread::sleep(pause);
        waited += pause;
        pause = (waited / 10).clamp(SHORTEST_PAUSE, LONGEST_PAUSE);
    }
}

/// What a program says of its version, if it is there.
fn describe(program: &Path) -> Option<(&Path, String, Version)> {
    let output = Command::new(program).arg("--version").output().ok()?;
    // nextpnr answers on the error stream.
    let text = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    let line = text.lines().find(|line| Version::first_in(line).is_some())?.to_owned();
    let version = Version::first_in(&line)?;
    Some((program, line, version))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_tool_is_named_with_the_command_that_installs_it() {
        let error = Tool::find("tool-that-is-not-there", "1.0").unwrap_err().to_string();
        assert!(error.contains("`tool-that-is-not-there` 1.0") && error.contains("make setup-fpga"), "{error}");
    }

    #[test]
    fn a_tool_that_is_too_old_will_not_do() {
        let error = Tool::find("sh", "999.0").unwrap_err();
        assert!(matches!(error, SynthesisError::Missing { .. }), "no shell is as new: {error}");
    }

    #[test]
    fn a_failed_tool_is_quoted_with_its_last_lines() {
        let shell = Tool { program: "sh".into(), description: String::new() };
        let script = "for n in $(seq 50); do echo line $n; done; echo ERROR: no such cell >&2; exit 1";
        let error = shell.run("f32_add", Path::new("."), &["-c", script]).unwrap_err().to_string();
        for part in ["sh failed on `f32_add`", "line 50", "ERROR: no such cell"] {
            assert!(error.contains(part), "`{part}` is missing in: {error}");
        }
        assert!(!error.contains("line 38\n"), "only the last lines: {error}");
        assert!(shell.run("f32_add", Path::new("."), &["-c", "echo fine"]).is_ok());
    }

    #[test]
    fn a_tool_is_stopped_when_there_is_a_reason() {
        let shell = Tool { program: "sh".into(), description: String::new() };
        let run = |script: &str, reason| shell.run_while("f32_add", Path::new("."), &["-c", script], || reason);
        let endless = "while :; do :; done";
        assert_eq!(run(endless, Some("it never ends")).expect("it starts"), Ending::Stopped("it never ends"));
        assert_eq!(run("true", None).expect("it starts"), Ending::Done);
    }
}
