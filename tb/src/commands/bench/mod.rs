//! `pointcore bench`: the project's figures, merged into one flat JSON object.

mod splat;

use super::{Failure, Figures, Output, merge};
use pointcore::float_check::{Enable, Stages, check_format};
use pointcore_spec::Format;
use std::path::PathBuf;

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

/// Measures everything.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let mut figures = Figures::new();
    splat::figures(arguments.scan.as_deref(), &mut figures)?;
    operator_figures(&mut figures)?;

    let merged = merge(&arguments.output, figures)?;
    let text = serde_json::to_string_pretty(&merged).expect("figures have string keys");
    output.print(&merged, &text);
    Ok(())
}
