//! `pointcore diagram CONFIG -o FILE`.

use super::{Failure, Output, write};
use pointcore::configuration::{self, Configuration};
use pointcore_contract::{points, search, splat};
use pointcore_lab::diagram::diagram;
use serde_json::json;
use std::path::PathBuf;

/// Arguments of `diagram`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A hardware configuration such as configs/ecp5.toml.
    configuration: PathBuf,
    /// The SVG file to write.
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// Draws a core.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let path = &arguments.configuration;
    let configuration = configuration::parse(path, &configuration::read_text(path)?)?;
    let module = configuration.module()?;
    let svg = match &configuration {
        Configuration::Splat(config) => diagram(&module, &splat::units::UNITS, config),
        Configuration::Search(config) => diagram(&module, &search::units::UNITS, config),
        Configuration::Points(config) => diagram(&module, &points::units::UNITS, config),
    };
    write(&arguments.output, &svg)?;
    let file = arguments.output.display().to_string();
    output.print(&json!({ "file": file }), &file)
}
