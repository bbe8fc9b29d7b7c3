//! `pointcore stability`: hard cases through the arithmetic of the renderer, beside an exact truth and other methods.

mod hardware;
mod page;

use super::{Failure, Output, merge, progress, write};
use pointcore_contract::Format;
use pointcore_lab::Figures;
use pointcore_lab::stability::campaign::{self, Settings, Sums};
use pointcore_lab::stability::check::Property;
use pointcore_lab::stability::family::Family;
use pointcore_lab::stability::methods::Method;
use serde_json::{Value, json};
use std::path::PathBuf;
use std::time::Duration;

/// Number formats that are checked: the default's and the one that saves multipliers.
const FORMATS: [Format; 2] = [Format::F32.flushed(), Format::F24.flushed()];

/// Arguments of `stability`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Cases of each number format.
    #[arg(long, default_value_t = 1_000_000)]
    cases: u64,
    /// Splats to send through the generated hardware, in lockstep with its model, besides.
    #[arg(long, value_name = "SPLATS", default_value_t = 0)]
    hardware: u64,
    /// Stop after so many minutes, shared by the formats, and report on what was done.
    #[arg(long)]
    minutes: Option<f64>,
    /// Seed of the cases.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The folder for tables, charts and JSON.
    #[arg(short, long, value_name = "DIR", default_value = "out/stability")]
    output: PathBuf,
    /// The file to merge the figures into.
    #[arg(long, value_name = "FILE", default_value = "out/bench.json")]
    merge: PathBuf,
}

/// Share of compared cases in which a method failed, over a format's hard families.
fn failure_rate(sums: &Sums, method: usize) -> f64 {
    let hard = Family::ALL.into_iter().filter(|family| *family != Family::Ordinary);
    let (failures, compared) = hard.map(|family| sums.family(family)).fold((0, 0), |(failures, compared), cell| {
        (failures + cell.methods[method].failures, compared + cell.compared)
    });
    failures as f64 / compared.max(1) as f64
}

/// Samples that a method visits in ordinary cases, as a multiple of the hardware's.
fn samples_ratio(sums: &Sums, method: usize) -> f64 {
    let methods = sums.family(Family::Ordinary).methods;
    methods[method].visited as f64 / methods[0].visited.max(1) as f64
}

fn figures(all: &[Sums]) -> Figures {
    let mut figures = Figures::new();
    let cases: u64 = all.iter().flat_map(|sums| sums.cells.iter().flatten()).map(|cell| cell.cases).sum();
    figures.insert("stability.golden_cases".to_owned(), cases.into());
    let violated = |property: Property| all.iter().map(|sums| sums.violated(property)).sum::<u64>();
    for property in Property::ALL {
        figures.insert(format!("stability.violations.{}", property.name()), violated(property).into());
    }
    let proved: u64 = Property::ALL.into_iter().filter(|property| property.is_proved()).map(violated).sum();
    let total: u64 = Property::ALL.into_iter().map(violated).sum();
    figures.insert("stability.proved_violations".to_owned(), proved.into());
    figures.insert("stability.violations".to_owned(), total.into());
    for sums in all {
        // The default format's figures have the short keys.
        let prefix =
            if sums.format == FORMATS[0] { "stability".to_owned() } else { format!("stability.{}", sums.format) };
        for (place, method) in Method::ALL.into_iter().enumerate() {
            let key = format!("{prefix}.{}", method.name());
            figures.insert(format!("{key}.failure_rate"), failure_rate(sums, place).into());
            if method != Method::Ours {
                figures.insert(format!("{key}.samples_ratio"), samples_ratio(sums, place).into());
            }
        }
    }
    figures
}

fn document(all: &[Sums]) -> Value {
    let formats = all.iter().map(|sums| {
        let families: serde_json::Map<_, _> = Family::ALL
            .into_iter()
            .zip(&sums.cells)
            .map(|(family, cells)| (family.name().to_owned(), json!(cells)))
            .collect();
        let violations: Vec<_> = sums
            .violations
            .iter()
            .map(|((property, family), count)| json!({ "property": property, "family": family, "count": count }))
            .collect();
        json!({
            "format": sums.format, "families": families, "violations": violations, "examples": sums.examples,
        })
    });
    json!({ "methods": Method::ALL, "formats": formats.collect::<Vec<_>>() })
}

/// Runs the cases and writes what they show.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    if arguments.cases == 0 {
        return Err(Failure::Usage("--cases 0: expected at least 1".to_owned()));
    }
    let budget = arguments.minutes.map(|minutes| 60.0 * minutes / FORMATS.len() as f64);
    let budget = budget
        .map(Duration::try_from_secs_f64)
        .transpose()
        .map_err(|error| Failure::Usage(format!("--minutes: {error}")))?;
    let settings = Settings { cases: arguments.cases, seed: arguments.seed, budget };
    let all: Vec<_> = FORMATS
        .into_iter()
        .map(|format| {
            progress::with_count("cases", settings.cases, |progress| campaign::run(format, settings, progress))
        })
        .collect();
    let mut figures = figures(&all);
    if arguments.hardware > 0 {
        hardware::figures(arguments.hardware, arguments.seed, &mut figures)?;
    }
    write(
        &arguments.output.join("stability.json"),
        &serde_json::to_string_pretty(&document(&all)).expect("results have string keys"),
    )?;
    let text = page::write_page(&arguments.output, &all, &figures)?;
    merge(&arguments.merge, figures.clone())?;
    output.print(&figures, &format!("{text}\nWritten to {}.", arguments.output.display()));
    Ok(())
}
