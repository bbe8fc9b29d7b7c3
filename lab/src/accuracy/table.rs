//! The points of a sweep as a table, and as JSON.

use super::choice::Rated;
use super::figures::PSNR_MAX_DB;
use pointcore::area::estimate::{Estimator, Origin};
use serde_json::{Value, json};
use std::fmt::Write as _;

/// Decibels; pictures that do not differ are said to be equal.
#[must_use]
pub fn decibels(psnr_db: f64) -> String {
    if psnr_db >= PSNR_MAX_DB { "equal".to_owned() } else { format!("{psnr_db:.1}") }
}

/// The columns of a point.
pub const COLUMNS: [&str; 11] = [
    "point",
    "front",
    "engine",
    "PSNR, dB",
    "FLIP",
    "worst pixel",
    "other surface",
    "rounding, dB",
    "cycles",
    "ms",
    "LUT4",
];

/// A point's figures, in the order of [`COLUMNS`].
#[must_use]
pub fn cells(rated: &Rated) -> [String; 11] {
    let figures = &rated.measured.figures;
    let or_dash = |text: Option<String>| text.unwrap_or_else(|| "–".to_owned());
    let recorded = |recorded: Option<Origin>| if recorded == Some(Origin::Recorded) { "*" } else { "" };
    let area_mark = recorded(rated.estimate.map(|estimate| estimate.lut4_origin));
    let time_mark = recorded(rated.estimate.map(|estimate| estimate.mhz_origin));
    [
        rated.measured.point.name.clone(),
        if rated.on_front { "●" } else { "" }.to_owned(),
        figures.engine.name().to_owned(),
        decibels(figures.psnr_db),
        format!("{:.4}", figures.flip),
        format!("{:.3}", figures.worst),
        figures.surface_differences.map_or_else(
            || "–".to_owned(),
            |count| format!("{:.3} %", 100.0 * count as f64 / figures.samples.max(1) as f64),
        ),
        decibels(figures.rounding_psnr_db),
        or_dash(figures.hardware.as_ref().map(|hardware| hardware.cycles.to_string())),
        or_dash(rated.time_ms.map(|time| format!("{time:.2}{time_mark}"))),
        or_dash(rated.lut4().map(|lut4| format!("{lut4:.0}{area_mark}"))),
    ]
}

/// What the figures are, in words.
#[must_use]
pub fn legend(estimator: &Estimator) -> String {
    let area = match &estimator.fit {
        Some(fit) => format!(
            "LUT4 are estimated from the core's operators by weights fitted to {} recorded units (median error of a unit left out: {:.0} %)",
            fit.units,
            100.0 * fit.median_error
        ),
        None => "LUT4 are left out, since too few units are recorded".to_owned(),
    };
    format!(
        "PSNR, FLIP (visible error, 0 to 1) and worst pixel are against 16 samples a pixel in f64; “other surface” and rounding are against f64 at the same samples. \
         {area}, times are those at 100 MHz; a figure with * was measured of that configuration. ● marks points that no other betters in \
         accuracy, time and area together."
    )
}

/// A Markdown table.
#[must_use]
pub fn markdown(rated: &[Rated]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let mut text = line(&COLUMNS.map(str::to_owned));
    _ = writeln!(text, "|---|---|---|{}", "---:|".repeat(COLUMNS.len() - 3));
    rated.iter().for_each(|point| text += &line(&cells(point)));
    text
}

/// A point as JSON.
#[must_use]
pub fn document(rated: &Rated) -> Value {
    json!({
        "name": rated.measured.point.name,
        "method": rated.measured.point.method,
        "settings": rated.measured.point.arguments(),
        "figures": rated.measured.figures,
        "estimate": rated.estimate,
        "time_ms": rated.time_ms,
        "on_front": rated.on_front,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::choice::tests::rated;

    #[test]
    fn every_point_has_its_row() {
        let points = rated(&[("base", 41.25, 100_000, 500), ("f64", PSNR_MAX_DB, 0, 0)]);
        let table = markdown(&points);
        assert_eq!(table.lines().count(), 4, "{table}");
        assert!(
            table.contains("| base | ● | golden | 41.2 | 0.9000 | 0.100 | 0.000 % | 51.2 | 100000 | 1.00 | 500 |"),
            "{table}"
        );
        assert!(table.contains("| f64 |  | golden | equal |") && table.contains("| – | – | – |"), "{table}");
    }

    #[test]
    fn json_keeps_what_a_point_was_measured_with() {
        let point = document(&rated(&[("base", 41.25, 100_000, 500)])[0]);
        assert_eq!((&point["figures"]["hardware"]["cycles"], &point["time_ms"]), (&json!(100_000), &json!(1.0)));
        assert_eq!(point["figures"]["hardware"]["config"]["features"]["geometry"], "f32-ftz");
    }
}
