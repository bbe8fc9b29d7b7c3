//! How results are printed.

use super::Failure;
use serde::Serialize;
use std::io::Write as _;

/// How results are printed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Output {
    /// For people.
    Text,
    /// For machines.
    Json,
}

impl Output {
    /// Prints a result: `value` as JSON, or `text`.
    pub fn print(self, value: &impl Serialize, text: &str) -> Result<(), Failure> {
        let text = match self {
            Self::Json => serde_json::to_string_pretty(value).expect("results have string keys"),
            Self::Text => text.trim_end().to_owned(),
        };
        let mut out = std::io::stdout().lock();
        writeln!(out, "{text}").and_then(|()| out.flush()).map_err(Failure::Print)
    }
}
