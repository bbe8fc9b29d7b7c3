//! `pointcore bench`: the project's figures, merged into one flat JSON object.

mod splat;

use super::{Failure, Output, write};
use pointcore::float_check::{Enable, Stages, check_format};
use pointcore_spec::Format;
use serde_json::{Map, Value};
use std::path::{Path, PathBuf};

/// Operand triples for each operator and format.
const OPERATOR_CASES: u64 = 1 << 20;
/// Seed of the operands.
const OPERATOR_SEED: u64 = 1;

/// Arguments of `bench`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The scan for scenes/igea.toml; without it that scene is measured only if its own path exists.
    #[arg(long, value_name = "FILE")]
    scan: Option<PathBuf>,
    /// The file to merge the figures into.
    #[arg(short, long, default_value = "out/bench.json")]
    output: PathBuf,
}

/// Figures by key.
type Figures = Map<String, Value>;

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Operators of every format, hardware against golden.
fn operator_figures(figures: &mut Figures) -> Result<(), Failure> {
    for (name, format) in Format::NAMED {
        eprintln!("operators: {name}");
        for report in check_format(format, Stages::Default, Enable::Always, OPERATOR_CASES, OPERATOR_SEED)? {
            let key = format!("fp.{}.{name}", report.operation);
            figures.insert(format!("{key}.cases"), report.cases.into());
            figures.insert(format!("{key}.mismatches"), report.mismatches.into());
        }
    }
    Ok(())
}

/// The figures that are already in the file; none if there is no such file.
fn existing(path: &Path) -> Result<Figures, Failure> {
    let wrong = |problem| Failure::Configuration { path: path.to_owned(), problem };
    match std::fs::read_to_string(path) {
        Ok(text) => serde_json::from_str(&text).map_err(|error| wrong(format!("{error}; delete it to start anew"))),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Figures::new()),
        Err(error) => Err(wrong(format!("cannot be read: {error}"))),
    }
}

/// Measures everything.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let mut figures = Figures::new();
    splat::figures(arguments.scan.as_deref(), &mut figures)?;
    operator_figures(&mut figures)?;

    let mut merged = existing(&arguments.output)?;
    merged.extend(figures);
    let text = serde_json::to_string_pretty(&merged).expect("figures have string keys");
    write(&arguments.output, &(text.clone() + "\n"))?;
    output.print(&merged, &text);
    Ok(())
}
