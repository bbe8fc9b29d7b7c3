//! Measurements side by side.

use super::{DeviceArea, Measurement, Revision, Target};

/// How a table is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Columns aligned by blanks.
    Plain,
    /// Markdown.
    Markdown,
}

/// What a line of a table shows.
pub struct AreaLine {
    /// The figures.
    pub measurement: Measurement,
    /// The revision that they are of, where that is not the hardware as it is now.
    pub revision: Option<Revision>,
}

impl From<Measurement> for AreaLine {
    fn from(measurement: Measurement) -> Self {
        Self { measurement, revision: None }
    }
}

/// A figure of every row.
type Column = (&'static str, fn(&DeviceArea) -> u64);

/// The figures that a target has.
const fn columns(target: Target) -> &'static [Column] {
    match target {
        Target::Ecp5 => &[
            ("LUT4", |area| area.lut),
            ("carry", |area| area.carry),
            ("FF", |area| area.flip_flop),
            ("RAM 16×4", |area| area.distributed_ram),
            ("block RAM", |area| area.block_ram),
            ("MULT18", |area| area.dsp),
        ],
        Target::Ice40 => &[
            ("LUT4", |area| area.lut),
            ("carry", |area| area.carry),
            ("FF", |area| area.flip_flop),
            ("block RAM", |area| area.block_ram),
        ],
        Target::Xilinx7 => &[
            ("LUT", |area| area.lut),
            ("CARRY4", |area| area.carry),
            ("FF", |area| area.flip_flop),
            ("LUT RAM", |area| area.distributed_ram),
            ("RAMB18", |area| area.block_ram),
            ("DSP48", |area| area.dsp),
        ],
        Target::Gates => {
            &[("gates", |area| area.gate), ("FF", |area| area.flip_flop), ("memory bits", |area| area.memory_bits)]
        }
    }
}

/// Writes measurements as a table. Where one is of an earlier revision, a last column says of which.
#[must_use]
pub fn table(target: Target, lines: &[AreaLine], style: Style) -> String {
    let timed = target.device().is_some();
    let is_mixed = lines.iter().any(|line| line.revision.is_some());
    let mut header = vec!["unit".to_owned()];
    header.extend(columns(target).iter().map(|(name, _)| (*name).to_owned()));
    if timed {
        header.extend(["MHz", "range", "seeds", "critical path"].map(String::from));
    }
    if is_mixed {
        header.push("revision".to_owned());
    }
    let mut rows = vec![header];
    rows.extend(lines.iter().map(|line| {
        let mut row = row(target, &line.measurement, style);
        if is_mixed {
            row.push(line.revision.as_ref().map_or_else(|| "this".to_owned(), Revision::to_string));
        }
        row
    }));
    match style {
        Style::Plain => plain(&rows),
        Style::Markdown => markdown(&rows),
    }
}

fn row(target: Target, measurement: &Measurement, style: Style) -> Vec<String> {
    let code = |text: &str| if style == Style::Markdown { format!("`{text}`") } else { text.to_owned() };
    let mut row = vec![code(&measurement.unit)];
    row.extend(columns(target).iter().map(|(_, figure)| figure(&measurement.area).to_string()));
    if let Some(timing) = &measurement.timing {
        let low = measurement.fmax_mhz.iter().copied().fold(f64::INFINITY, f64::min);
        let high = measurement.fmax_mhz.iter().copied().fold(0.0, f64::max);
        row.push(format!("{:.0}", timing.fmax_mhz));
        row.push(format!("{low:.0}–{high:.0}"));
        row.push(match (measurement.fmax_mhz.len(), measurement.first_seed) {
            (runs, 1) => runs.to_string(),
            (runs, first) => format!("{runs}, from {first}"),
        });
        row.push(format!("{} → {}", code(&timing.from), code(&timing.to)));
    }
    row
}

/// Numbers right, names left.
fn plain(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or_default();
    let width = |column: usize| rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max();
    let widths: Vec<_> = (0..columns).map(|column| width(column).unwrap_or_default()).collect();
    let line = |row: &Vec<String>| {
        let cell = |(column, text): (usize, &String)| {
            let blanks = " ".repeat(widths[column] - text.chars().count());
            if column == 0 || text.contains(['→', ' ']) {
                format!("{text}{blanks}")
            } else {
                format!("{blanks}{text}")
            }
        };
        let cells: Vec<_> = row.iter().enumerate().map(cell).collect();
        format!("{}\n", cells.join("  ").trim_end())
    };
    rows.iter().map(line).collect()
}

/// A table in Markdown, its first row the header.
pub fn markdown(rows: &[Vec<String>]) -> String {
    let line = |row: &Vec<String>| format!("| {} |\n", row.join(" | "));
    let columns = rows.first().map_or(0, Vec::len);
    let mut text: String = rows.iter().take(1).map(line).collect();
    text += &format!("|{}\n", "---|".repeat(columns));
    text + &rows.iter().skip(1).map(line).collect::<String>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::Timing;

    fn measurement() -> Measurement {
        let area = DeviceArea { lut: 599, carry: 59, flip_flop: 344, ..DeviceArea::default() };
        let timing = Timing { fmax_mhz: 141.6, from: "sum_s3".into(), to: "zeros_s4".into() };
        Measurement {
            unit: "f32_add".into(),
            area,
            timing: Some(timing),
            fmax_mhz: vec![150.2, 139.9, 141.6],
            first_seed: 1,
        }
    }

    #[test]
    fn a_table_shows_the_median_and_the_range() {
        let text = table(Target::Ecp5, &[measurement().into()], Style::Plain);
        let [header, row] = text.lines().collect::<Vec<_>>()[..] else { panic!("two lines: {text}") };
        assert!(header.starts_with("unit") && header.ends_with("critical path"), "{header}");
        let cells: Vec<_> = row.split_whitespace().collect();
        let expected = ["f32_add", "599", "59", "344", "0", "0", "0", "142", "140–150", "3", "sum_s3", "→", "zeros_s4"];
        assert_eq!(cells, expected);
        let text = table(Target::Ecp5, &[Measurement { first_seed: 7, ..measurement() }.into()], Style::Plain);
        assert!(text.contains("  3, from 7  sum_s3"), "{text}");
    }

    #[test]
    fn markdown_has_as_many_cells_in_every_line() {
        for target in [Target::Ecp5, Target::Ice40, Target::Xilinx7, Target::Gates] {
            let timing = if target.device().is_some() { measurement().timing } else { None };
            let text = table(target, &[Measurement { timing, ..measurement() }.into()], Style::Markdown);
            let bars: Vec<_> = text.lines().map(|line| line.matches('|').count()).collect();
            assert_eq!(bars, [bars[0]; 3], "{text}");
        }
    }
}
