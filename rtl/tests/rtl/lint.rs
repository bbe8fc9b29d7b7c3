//! Runs Verilator, Icarus and yosys on a text, which they must take without a warning.

use std::path::Path;
use std::process::{Command, Output};

use rtl::Design;

/// Runs a tool in a folder; its absence is told apart from its refusal.
pub fn run(program: &str, arguments: &[&str], folder: &Path) -> Output {
    let spawned = Command::new(program).args(arguments).current_dir(folder).output();
    spawned.unwrap_or_else(|error| panic!("cannot run {program} ({error}): apt-get install verilator iverilog yosys"))
}

/// A tool must take arguments about a text without a word.
pub fn accepts(program: &str, arguments: &[&str], folder: &Path, verilog: &str) {
    let output = run(program, arguments, folder);
    let text = [&output.stdout[..], &output.stderr[..]].map(String::from_utf8_lossy).concat();
    let clean = output.status.success() && !text.contains("%Warning") && !text.to_lowercase().contains("warning:");
    assert!(clean, "{program} {arguments:?} says\n{text}\nabout\n{verilog}");
}

/// Every tool must take the design without a word.
pub fn lint(design: &Design) {
    lint_but(design, &[]);
}

/// As [`lint`], with flags that let Verilator overlook a rule.
pub fn lint_but(design: &Design, overlooked: &[&str]) {
    lint_text(design.top(), design.verilog(), overlooked);
}

/// As [`lint_but`], of any text.
pub fn lint_text(top: &str, verilog: &str, overlooked: &[&str]) {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let file = format!("{top}.v");
    std::fs::write(folder.path().join(&file), verilog).expect("a temporary folder can be written");
    let verilator = [&["--lint-only", "-Wall", "--top-module", top, &file], overlooked].concat();
    accepts("verilator", &verilator, folder.path(), verilog);
    let with_checks = [&verilator[..], &["-DRTL_ASSERT"]].concat();
    accepts("verilator", &with_checks, folder.path(), verilog);
    accepts("iverilog", &["-Wall", "-t", "null", &file], folder.path(), verilog);
    let script = format!("read_verilog {file}; hierarchy -check -top {top}; proc; check -assert");
    accepts("yosys", &["-q", "-p", &script], folder.path(), verilog);
}
