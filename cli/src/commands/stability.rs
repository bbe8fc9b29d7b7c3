//! `pointcore stability`: hard cases through the arithmetic of the renderer, beside an exact truth and other methods.

use super::{Failure, Output, existing, merge, numbers, progress, write};
use pointcore_lab::stability::campaign::{self, Settings};
use pointcore_lab::stability::figures::{FORMATS, document, figures};
use pointcore_lab::stability::lockstep::FrameCheck;
use pointcore_lab::stability::page::write_page;
use std::path::PathBuf;
use std::time::Duration;

/// Arguments of `stability`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Cases of each number format.
    #[arg(long, default_value_t = 1_000_000, value_parser = numbers::within(1_u64.., "at least 1"))]
    cases: u64,
    /// Splats to send through the generated hardware, in lockstep with its model, besides.
    #[arg(long, value_name = "SPLATS", default_value_t = 0, value_parser = numbers::whole())]
    hardware: u64,
    /// Stop after so many minutes, shared by the formats, and report on what was done.
    #[arg(long, value_parser = numbers::positive())]
    minutes: Option<f64>,
    /// Seed of the cases.
    #[arg(long, default_value_t = 1, value_parser = numbers::whole())]
    seed: u64,
    /// The folder for tables, charts and JSON.
    #[arg(short, long, value_name = "DIR", default_value = "out/stability")]
    output: PathBuf,
    /// The file to merge the figures into.
    #[arg(long, value_name = "FILE", default_value = "out/bench.json")]
    merge: PathBuf,
}

/// Runs the cases and writes what they show.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    existing(&arguments.merge)?;
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
        let message = "verilating and compiling (cached for the next time)";
        let check = progress::with_spinner(message, FrameCheck::build)?;
        check.figures(arguments.hardware, arguments.seed, &mut figures)?;
    }
    write(
        &arguments.output.join("stability.json"),
        &serde_json::to_string_pretty(&document(&all)).expect("results have string keys"),
    )?;
    let text = write_page(&arguments.output, &all, &figures)?;
    merge(&arguments.merge, figures.clone())?;
    output.print(&figures, &format!("{text}\nWritten to {}.", arguments.output.display()))
}
