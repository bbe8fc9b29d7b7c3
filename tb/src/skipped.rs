//! Tests that cannot run here say so, past the capture of the test harness: a test that was skipped looks like one that passed.

use std::fs::OpenOptions;
use std::io::Write as _;
use std::thread;

/// The environment variable that names the file in which tests that were skipped are collected (`scripts/test`).
pub const SKIPPED_VARIABLE: &str = "POINTCORE_SKIPPED";

/// Says that the test that calls it is skipped, whole or in part, and why.
///
/// # Panics
/// The file that the environment names cannot be written.
pub fn skipped(why: &str) {
    // The test harness gives a test's thread its name.
    let thread = thread::current();
    let line = format!("{}: {}\n", thread.name().unwrap_or("a test"), why.trim_end().replace('\n', " "));
    std::io::stderr().write_all(format!("skipped: {line}").as_bytes()).expect("standard error is open");
    if let Some(path) = std::env::var_os(SKIPPED_VARIABLE) {
        let file = OpenOptions::new().create(true).append(true).open(&path);
        // In one piece, for other tests write at the same time.
        let written = file.and_then(|mut file| file.write_all(line.as_bytes()));
        written.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
}
