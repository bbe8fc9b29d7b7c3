//! Signs of life and remarks beside a result.

use std::fmt;
use std::io::Write as _;

/// Writes a line to the error stream; where nobody can read it any more, it is lost.
pub fn note(text: fmt::Arguments) {
    _ = writeln!(std::io::stderr(), "{text}");
}

/// Writes a line to the error stream, as `eprintln!` but without a panic where that is closed or full.
#[macro_export]
macro_rules! note {
    ($($text:tt)*) => { $crate::note::note(format_args!($($text)*)) };
}
