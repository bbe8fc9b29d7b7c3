//! What a stability run shows to people.

use super::campaign::{Cell, Example, Sums};
use super::check::Property;
use super::families::LEVELS;
use super::family::Family;
use super::figures::{failure_rate, samples_ratio};
use super::methods::Method;
use crate::chart::lines::{LineChart, Series};
use crate::{Figures, LabError, write};
use std::fmt::Write as _;
use std::path::Path;

/// Correct bits of a `ρ²` that was never seen to err.
const BITS_MAX: f64 = 32.0;

/// What a chart shows of a method in a cell.
type Value = fn(&Cell, usize) -> Option<f64>;

fn families() -> impl Iterator<Item = Family> {
    Family::ALL.into_iter().filter(|family| *family != Family::Ordinary)
}

/// A line of a method over the severities; none where too few cases compare.
fn series(cells: &[Cell; LEVELS as usize], method: usize, value: impl Fn(&Cell, usize) -> Option<f64>) -> Series {
    let values = cells.iter().map(|cell| value(cell, method)).collect();
    Series { name: Method::ALL[method].name().to_owned(), values }
}

fn share_failed(cell: &Cell, method: usize) -> Option<f64> {
    (cell.compared > 0).then(|| cell.methods[method].failures as f64 / cell.compared as f64)
}

/// `−log2` of the root mean square error of `ρ²`, over samples inside.
fn correct_bits(cell: &Cell, method: usize) -> Option<f64> {
    let sums = &cell.methods[method];
    (sums.inside > 0).then(|| (-0.5 * (sums.squared_error / sums.inside as f64).log2()).clamp(0.0, BITS_MAX))
}

fn charts(folder: &Path, sums: &Sums) -> Result<String, LabError> {
    let mut text = String::new();
    for (family, cells) in Family::ALL.into_iter().zip(&sums.cells) {
        if family == Family::Ordinary || cells.iter().all(|cell| cell.compared == 0) {
            continue;
        }
        let charts: [(&str, &str, Value); 2] =
            [("failures", "share of cases that fail", share_failed), ("bits", "correct bits of ρ²", correct_bits)];
        for (kind, y, value) in charts {
            let chart = LineChart {
                title: format!("{}, {}: {y}", family.name(), sums.format),
                x: "severity".to_owned(),
                y: y.to_owned(),
                categories: (0..LEVELS).map(|level| level.to_string()).collect(),
                series: (0..Method::ALL.len()).map(|method| series(cells, method, value)).collect(),
            };
            let file = format!("{}-{}-{kind}.svg", sums.format, family.name());
            chart.save_svg(&folder.join(&file))?;
            _ = writeln!(text, "![{}, {}: {y}]({file})", family.name(), sums.format);
        }
    }
    Ok(text)
}

fn violations(text: &mut String, all: &[Sums]) {
    _ = writeln!(
        text,
        "\n## What does not hold\n\nCases, by property (docs/stability.md) and family; “proved” must be 0.\n"
    );
    for sums in all {
        _ = writeln!(text, "\n| {} | proved | cases | worst | families |\n|---|---|---|---|---|", sums.format);
        for property in Property::ALL {
            let of_property = || sums.violations.iter().filter(|((other, _), _)| *other == property);
            let worst = of_property().map(|(_, count)| count.worst).fold(0.0, f64::max);
            let families: Vec<_> =
                of_property().map(|((_, family), count)| format!("{} {}", family.name(), count.cases)).collect();
            let proved = if property.is_proved() { "yes" } else { "no" };
            let (cases, families) = (sums.violated(property), families.join(", "));
            _ = writeln!(text, "| {} | {proved} | {cases} | {worst:.3} | {families} |", property.name());
        }
    }
}

fn example(text: &mut String, example: &Example) {
    let Example { format, violation, family, filter, numbers, attributes, lens, .. } = example;
    let [u, a1, a2] = [0, 3, 6].map(|first| numbers[first..first + 3].join(", "));
    let filter = if *filter { "on" } else { "off" };
    let at = violation.pixel.map_or(String::new(), |[column, row]| format!(", pixel ({column}, {row})"));
    _ = writeln!(
        text,
        "- **{}**, {format}, from {}, filter {filter}: u = ({u}), a1 = ({a1}), a2 = ({a2}){at}: {}. near {}, depth {} + {}/z{}",
        violation.property.name(),
        family.name(),
        violation.found,
        lens.near,
        lens.depth_a,
        lens.depth_b,
        if violation.property == Property::Finite { format!(", attributes {attributes:x?}") } else { String::new() }
    );
}

fn methods(text: &mut String, sums: &Sums) {
    _ = writeln!(
        text,
        "\n## Methods, {}\n\nShare of cases with a sample drawn well outside the splat or missing well inside it, all severities; visited samples in ordinary cases.\n",
        sums.format
    );
    let names: Vec<_> = Method::ALL.into_iter().map(Method::name).collect();
    _ = writeln!(text, "| family | cases | {} |\n|---|---|{}", names.join(" | "), "---|".repeat(names.len()));
    let row = |cell: &Cell| {
        let shares = (0..Method::ALL.len()).map(|method| share_failed(cell, method).unwrap_or_default());
        shares.map(|share| format!("{share:.5}")).collect::<Vec<_>>().join(" | ")
    };
    for family in Family::ALL {
        let cell = sums.family(family);
        if cell.compared > 0 {
            _ = writeln!(text, "| {} | {} | {} |", family.name(), cell.compared, row(&cell));
        }
    }
    let rates: Vec<_> = (0..Method::ALL.len()).map(|method| format!("{:.5}", failure_rate(sums, method))).collect();
    let compared: u64 = families().map(|family| sums.family(family).compared).sum();
    _ = writeln!(text, "| all hard ones | {compared} | {} |", rates.join(" | "));
    let ratios: Vec<_> = (0..Method::ALL.len()).map(|method| format!("{:.3}", samples_ratio(sums, method))).collect();
    _ = writeln!(text, "| visited samples, ordinary | | {} |", ratios.join(" | "));
}

fn bounds(text: &mut String, all: &[Sums]) {
    _ = writeln!(
        text,
        "\n## Errors of ρ² beside their bound\n\n| format | family | cases | samples | undetermined | largest error / bound |\n|---|---|---|---|---|---|"
    );
    for sums in all {
        for family in Family::ALL {
            let cell = sums.family(family);
            let share = cell.undetermined as f64 / cell.samples.max(1) as f64;
            let (format, name) = (sums.format, family.name());
            _ = writeln!(
                text,
                "| {format} | {name} | {} | {} | {share:.4} | {:.3} |",
                cell.cases, cell.samples, cell.used
            );
        }
    }
}

/// Writes tables and charts; returns the tables.
///
/// # Errors
/// A file cannot be written.
pub fn write_page(folder: &Path, all: &[Sums], figures: &Figures) -> Result<String, LabError> {
    let cases = &figures["stability.golden_cases"];
    let mut text = format!("# Numerical stability of the renderer's geometry, measured\n\nCases: {cases}\n");
    violations(&mut text, all);
    _ = writeln!(text, "\n## Smallest counterexamples found\n");
    all.iter().flat_map(|sums| &sums.examples).for_each(|smallest| example(&mut text, smallest));
    all.iter().for_each(|sums| methods(&mut text, sums));
    bounds(&mut text, all);
    let mut page = text.clone() + "\n## Charts\n\n";
    // The folder is there once the page is.
    write(&folder.join("README.md"), &page)?;
    for sums in all {
        page += &charts(folder, sums)?;
    }
    write(&folder.join("README.md"), &page)?;
    Ok(text)
}
