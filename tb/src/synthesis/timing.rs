//! The report of place and route: the clock's frequency and the path that limits it.

use super::shell::UNIT_INSTANCE;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What limits the clock.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Timing {
    /// The clock's highest frequency in MHz.
    pub fmax_mhz: f64,
    /// Where the critical path begins, in the unit's own names.
    pub from: String,
    /// Where it ends.
    pub to: String,
}

#[derive(Deserialize)]
struct Report {
    fmax: BTreeMap<String, Frequency>,
    critical_paths: Vec<Path>,
}

#[derive(Deserialize)]
struct Frequency {
    achieved: f64,
}

#[derive(Deserialize)]
struct Path {
    from: String,
    to: String,
    path: Vec<Step>,
}

#[derive(Deserialize)]
struct Step {
    from: Pin,
    to: Pin,
}

#[derive(Deserialize)]
struct Pin {
    cell: String,
}

/// Reads nextpnr's `--report`.
///
/// # Errors
/// A report of another form, or of a design that has not exactly one clock.
pub(super) fn parse(report: &str) -> Result<Timing, String> {
    let report: Report = serde_json::from_str(report).map_err(|error| format!("report: {error}"))?;
    let mut clocks = report.fmax.values();
    let (Some(clock), None) = (clocks.next(), clocks.next()) else {
        return Err(format!("report: {} clocks, expected one", report.fmax.len()));
    };
    // Paths from pads and to pads are the shell's and lead from or to `<async>`.
    let critical = report.critical_paths.iter().find(|path| path.from == path.to);
    let ends = critical.and_then(|path| Some((path.path.first()?, path.path.last()?)));
    let (first, last) = ends.ok_or("report: no path from clock to clock")?;
    Ok(Timing { fmax_mhz: clock.achieved, from: signal(&first.from.cell), to: signal(&last.to.cell) })
}

/// What synthesis and packing append to a signal's name to make a cell's.
const CELL_MARKS: [&str; 10] =
    ["_TRELLIS_", "_SB_", "_DP16KD_", "_PDPW16KD_", "_MULT18X18D_", "_LUT4_", "_PFUMX_", "_L6MUX21_", "_CCU2C_", "_$"];

/// The signal that a cell is named for; of the shell's own, marked as such.
fn signal(cell: &str) -> String {
    let end = CELL_MARKS.iter().filter_map(|mark| cell.find(mark)).min().unwrap_or(cell.len());
    let name = &cell[..end];
    match name.strip_prefix(UNIT_INSTANCE).and_then(|rest| rest.strip_prefix('.')) {
        Some(inside) => inside.to_owned(),
        None => format!("shell: {name}"),
    }
}

/// The run with the middle frequency; of an even number, the lower of the two.
pub(super) fn median(runs: &[Timing]) -> Option<&Timing> {
    let mut order: Vec<_> = runs.iter().collect();
    order.sort_by(|a, b| a.fmax_mhz.total_cmp(&b.fmax_mhz));
    order.get(order.len().checked_sub(1)? / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What nextpnr-ecp5 0.11 says of `f32_add`.
    const ECP5: &str = include_str!("fixtures/ecp5_timing.json");

    #[test]
    fn a_report_is_read() {
        let timing = parse(ECP5).unwrap_or_else(|error| panic!("{error}"));
        assert!((timing.fmax_mhz - 158.579).abs() < 1e-3, "{}", timing.fmax_mhz);
        assert_eq!((timing.from.as_str(), timing.to.as_str()), ("sum_s3", "zeros_s4"));
    }

    #[test]
    fn the_shell_is_told_from_the_unit() {
        assert_eq!(signal("drive_a_TRELLIS_FF_Q_3"), "shell: drive_a");
        assert_eq!(signal("unit.queue.head_SB_DFFE_Q_D_SB_LUT4_O"), "queue.head");
        assert_eq!(signal("unit.entries.0.0"), "entries.0.0");
    }

    #[test]
    fn the_median_of_an_even_number_is_the_lower_of_the_two() {
        let run = |fmax_mhz| Timing { fmax_mhz, from: String::new(), to: String::new() };
        let frequency = |runs: &[f64]| median(&runs.iter().copied().map(run).collect::<Vec<_>>()).map(|t| t.fmax_mhz);
        assert_eq!(frequency(&[143.0, 120.0, 150.0]), Some(143.0));
        assert_eq!(frequency(&[143.0, 120.0, 150.0, 130.0]), Some(130.0));
        assert_eq!(frequency(&[]), None);
    }

    #[test]
    fn a_report_without_one_clock_is_an_error() {
        let none = parse(r#"{"fmax": {}, "critical_paths": []}"#).unwrap_err();
        assert!(none.contains("0 clocks"), "{none}");
        let pathless = r#"{"fmax": {"clk": {"achieved": 9.0, "constraint": 9.0}}, "critical_paths": []}"#;
        assert!(parse(pathless).unwrap_err().contains("no path"));
        assert!(parse("{").is_err());
    }
}
