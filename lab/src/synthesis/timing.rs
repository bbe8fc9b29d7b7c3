//! The report of place and route: the clock's frequency and the path that limits it.

use super::shell::UNIT_INSTANCE;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What limits the clock.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
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
    /// The wire, of a step from cell to cell.
    net: Option<String>,
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
    let ends = critical.and_then(|path| Some((path.path.first()?, path.path.last()?, &path.path)));
    let (first, last, steps) = ends.ok_or("report: no path from clock to clock")?;
    let nets = || steps.iter().filter_map(|step| step.net.as_deref());
    let (from, to) = (end(&first.from.cell, nets()), end(&last.to.cell, nets().rev()));
    Ok(Timing { fmax_mhz: clock.achieved, from, to })
}

/// The signal at an end of a path: the cell's, else that of the nearest wire, for a cell may have no name but the tools' own.
fn end<'a>(cell: &'a str, mut nets: impl Iterator<Item = &'a str>) -> String {
    signal(cell).or_else(|| nets.find_map(signal)).unwrap_or_else(|| cell.to_owned())
}

/// What synthesis and packing append to a signal's name to make a cell's.
const CELL_MARKS: [&str; 11] = [
    "_TRELLIS_",
    "_SB_",
    "_DP16KD_",
    "_PDPW16KD_",
    "_MULT18X18D_",
    "_LUT4_",
    "_PFUMX_",
    "_L6MUX21_",
    "_CCU2C_",
    "_$",
    "$",
];

/// The signal that a cell or wire is named for, with the instances it lies in; of the shell's own, marked as such. None if the tools
/// made up its name.
pub(super) fn signal(cell: &str) -> Option<String> {
    let end = CELL_MARKS.iter().filter_map(|mark| cell.find(mark)).min().unwrap_or(cell.len());
    let mut name = cell[..end].split('[').next()?;
    // A memory's cell is named by column and row; no name of ours begins with a digit.
    while let Some((memory, place)) = name.rsplit_once('.')
        && place.starts_with(|c: char| c.is_ascii_digit())
    {
        name = memory;
    }
    match name.strip_prefix(UNIT_INSTANCE).and_then(|rest| rest.strip_prefix('.')) {
        Some(inside) if inside.is_empty() || inside.ends_with('.') => None,
        Some(inside) => Some(inside.to_owned()),
        None if name.is_empty() || name == UNIT_INSTANCE => None,
        None => Some(format!("shell: {name}")),
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
        assert_eq!(signal("drive_a_TRELLIS_FF_Q_3").as_deref(), Some("shell: drive_a"));
        assert_eq!(signal("unit.queue.head_SB_DFFE_Q_D_SB_LUT4_O").as_deref(), Some("queue.head"));
    }

    #[test]
    fn names_are_those_of_the_verilog_however_deep() {
        for (cell, name) in [
            ("unit.reorder.heap.level_8.left_nodes.0.0", "reorder.heap.level_8.left_nodes"),
            ("unit.tree_cache.tags.0.18$DPRAM_COMB3", "tree_cache.tags"),
            ("unit.rasterizer.add_f24_ftz_unit.sum_s3[13]", "rasterizer.add_f24_ftz_unit.sum_s3"),
            ("unit.sum_12_TRELLIS_FF_Q_4", "sum_12"),
            ("unit.slot_2_pixels_3.0.1", "slot_2_pixels_3"),
        ] {
            assert_eq!(signal(cell).as_deref(), Some(name), "{cell}");
        }
    }

    #[test]
    fn a_cell_without_a_name_has_that_of_its_wire() {
        for cell in ["$auto$simplemap.cc:267:simplemap_lut$99", "unit.$auto$ff$3", "unit.search.$abc$1"] {
            assert_eq!(signal(cell), None, "{cell}");
            assert_eq!(end(cell, ["unit.$abc$7", "unit.search.radius[3]"].into_iter()), "search.radius");
            assert_eq!(end(cell, std::iter::empty()), cell, "better than nothing");
        }
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
