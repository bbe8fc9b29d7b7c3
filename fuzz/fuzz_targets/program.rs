//! Any text as a program is one or an error with a place in it, never a panic.
#![no_main]

use libfuzzer_sys::fuzz_target;
use pointcore_contract::process::Program;

fuzz_target!(|text: &str| {
    if let Err(error) = Program::parse("fuzz.pasm", text) {
        assert!(error.line >= 1 && error.line <= text.lines().count().max(1) && error.column >= 1, "{error}");
    }
});
