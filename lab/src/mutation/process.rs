//! A test as a program of its own: a mutant may hang it, or bring it down.

use super::MutationError;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

/// Lines of output that an error repeats.
const LAST_LINES: usize = 20;

/// How a test ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It passed.
    Passed,
    /// It failed, with what it printed last.
    Failed(String),
    /// It did not end in its time.
    Stuck,
}

impl Verdict {
    /// Whether the test noticed something.
    pub fn is_found(&self) -> bool {
        *self != Self::Passed
    }
}

/// Kills the program when it is no longer waited for.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        // One that has ended cannot be killed.
        _ = self.0.kill();
        _ = self.0.wait();
    }
}

/// Runs `command` to its end, to the first line that `has_failed` knows, or for `limit`.
pub fn run(mut command: Command, limit: Duration, has_failed: fn(&str) -> bool) -> Result<Verdict, MutationError> {
    let program = command.get_program().to_string_lossy().into_owned();
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
    let failed = |error: std::io::Error| MutationError::Program { program: program.clone(), output: error.to_string() };
    let mut running = Running(command.spawn().map_err(failed)?);
    let output = running.0.stdout.take().expect("it is piped");
    let (sender, lines) = mpsc::channel();
    thread::spawn(move || {
        // A mutant may print anything; nobody listens any more when the test has ended.
        for line in BufReader::new(output).split(b'\n').map_while(Result::ok) {
            if sender.send(String::from_utf8_lossy(&line).into_owned()).is_err() {
                break;
            }
        }
    });
    let begin = Instant::now();
    let mut printed = Vec::new();
    loop {
        match lines.recv_timeout(limit.saturating_sub(begin.elapsed())) {
            Ok(line) => {
                let is_failure = has_failed(&line);
                printed.push(line);
                if is_failure {
                    return Ok(Verdict::Failed(last(&printed)));
                }
            }
            Err(RecvTimeoutError::Timeout) => return Ok(Verdict::Stuck),
            Err(RecvTimeoutError::Disconnected) => break,
        }
    }
    let status = running.0.wait().map_err(failed)?;
    Ok(if status.success() { Verdict::Passed } else { Verdict::Failed(last(&printed)) })
}

/// What a program prints.
pub fn output(command: &mut Command) -> Result<String, MutationError> {
    let program = command.get_program().to_string_lossy().into_owned();
    let failed = |output: String| MutationError::Program { program: program.clone(), output };
    let output = command.output().map_err(|error| failed(error.to_string()))?;
    if !output.status.success() {
        return Err(failed(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

fn last(lines: &[String]) -> String {
    lines[lines.len().saturating_sub(LAST_LINES)..].join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shell(script: &str, seconds: u64) -> Verdict {
        let mut command = Command::new("sh");
        command.args(["-c", script]);
        run(command, Duration::from_secs(seconds), |line| line.contains("FAILED"))
            .unwrap_or_else(|error| panic!("{error}"))
    }

    #[test]
    fn a_test_passes_fails_or_is_stuck() {
        assert_eq!(shell("echo fine", 10), Verdict::Passed);
        assert_eq!(shell("echo one; exit 3", 10), Verdict::Failed("one".to_owned()));
        assert_eq!(shell("echo test FAILED; sleep 60", 10), Verdict::Failed("test FAILED".to_owned()));
        assert_eq!(shell("sleep 60", 1), Verdict::Stuck);
        assert!(run(Command::new("/no/such/program"), Duration::from_secs(1), |_| false).is_err());
    }
}
