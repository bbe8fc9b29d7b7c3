//! Waveforms of runs: which cycles, and how a viewer shows them.

mod view;

pub use view::{View, search_view, splat_view};

use pointcore_tb::verilated::{VerilatedError, VerilatedModel};
use std::ops::Range;
use std::path::PathBuf;
use std::str::FromStr;

/// Cycles of a run, counted from the end of the reset.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Window(pub Range<u64>);

impl FromStr for Window {
    type Err = String;

    /// `A..B`: from cycle A up to, but not, B.
    fn from_str(text: &str) -> Result<Self, String> {
        let bounds = text.split_once("..").and_then(|(from, to)| Some((from.parse().ok()?, to.parse().ok()?)));
        let window = bounds.filter(|(from, to)| from < to).map(|(from, to)| Self(from..to));
        window.ok_or_else(|| "expected cycles A..B with A below B, such as 1000..1200".to_owned())
    }
}

/// A waveform to be written.
#[derive(Clone, Debug)]
pub struct Waveform {
    /// The FST file.
    pub path: PathBuf,
    /// Its cycles; the whole run with its reset where none are said.
    pub window: Option<Window>,
}

impl Waveform {
    /// Before the first cycle of a run and its reset.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn begin(&self, model: &mut VerilatedModel) -> Result<(), VerilatedError> {
        if self.window.is_none() { model.open_trace(&self.path) } else { Ok(()) }
    }

    /// Before each cycle after the reset.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn before(&self, cycle: u64, model: &mut VerilatedModel) -> Result<(), VerilatedError> {
        let Some(Window(window)) = &self.window else { return Ok(()) };
        if cycle == window.start {
            model.open_trace(&self.path)?;
        } else if cycle == window.end {
            model.close_trace();
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_are_cycles_in_order() {
        assert_eq!("10..12".parse(), Ok(Window(10..12)));
        for text in ["", "10", "..", "12..10", "5..5", "-1..3", "a..b", "1..2..3"] {
            assert!(text.parse::<Window>().unwrap_err().contains("1000..1200"), "{text}");
        }
    }
}
