//! `pointcore process --op NAME --points FILE`.

mod arguments;
mod hardware;

pub use arguments::Arguments;

use super::progress::{with_count, with_spinner};
use super::results::Results;
use super::{Failure, Output, estimator, write, write_bytes};
use arguments::FileKind;
use hardware::Carrier;
use pointcore::area::proxy::Proxy;
use pointcore::process::check::{self, Comparison, Uncompared};
use pointcore::process::{
    Cost, Operation, Process, ProcessError, ProcessReport, Processed, Queries, csv, npy, ply, process,
};
use pointcore::search::SearchError;
use serde_json::json;
use std::path::Path;

/// What some runs leave and others do not.
const OWN_FILES: [&str; 3] = ["points.ply", "points.csv", "arrays"];

/// The error, with what leaves out points that are no numbers.
fn remedied(failure: Failure) -> Failure {
    match failure {
        Failure::Process(ProcessError::Model(error)) => {
            ProcessError::Model(error.remedied("; --drop-invalid leaves such points out")).into()
        }
        Failure::Process(ProcessError::Points(SearchError::Model(error))) => {
            ProcessError::Model(error.remedied("; --drop-invalid leaves such points out")).into()
        }
        other => other,
    }
}

fn write_files(processed: &Processed, kinds: &[FileKind], folder: &Path) -> Result<(), Failure> {
    let failed = |source| Failure::Write { path: folder.to_owned(), source };
    for kind in kinds {
        match kind {
            FileKind::Ply => write_bytes(&folder.join("points.ply"), &ply(processed).map_err(failed)?)?,
            FileKind::Csv => write(&folder.join("points.csv"), &csv(processed))?,
            FileKind::Npy => {
                for (name, array) in npy(processed).map_err(failed)? {
                    write_bytes(&folder.join("arrays").join(name + ".npy"), &array)?;
                }
            }
        }
    }
    Ok(())
}

/// What the programs take as hardware, and their look-up tables if they are asked for.
fn cost(arguments: &Arguments, operation: &Operation, rate: u32) -> Result<(Vec<Cost>, Option<f64>), Failure> {
    let of = |program: &std::sync::Arc<_>| Cost::of(program, arguments.format, rate);
    let cost = operation.stages().iter().map(of).collect::<Result<Vec<_>, _>>()?;
    if !arguments.luts {
        return Ok((cost, None));
    }
    let estimator = with_spinner("looking through the record of areas (cached for the next time)", estimator)?;
    let lut4 = |proxy: &Proxy| estimator.lut4(proxy);
    let blocks: Option<Vec<f64>> = cost.iter().flat_map(|cost| &cost.blocks).map(|block| lut4(&block.proxy)).collect();
    Ok((cost, blocks.map(|blocks| blocks.iter().sum())))
}

/// Compares outputs with those of f64.
fn compare(arguments: &Arguments, processed: &Processed) -> Result<Option<Vec<Comparison>>, Failure> {
    if !arguments.check {
        return Ok(None);
    }
    let compared = with_spinner("comparing with f64", || check::compare(&processed.stages));
    Ok(Some(compared.map_err(Failure::Operator)?))
}

fn number_of(queries: &Queries) -> u64 {
    match queries {
        Queries::Points(points) => points.len() as u64,
        Queries::Pattern { points, sides } => points.len() as u64 * u64::from(sides[0]) * u64::from(sides[1]),
        Queries::Cloud(cloud) => cloud.len() as u64,
        Queries::Places(places) => places.len() as u64,
    }
}

/// Carries out an operator on neighborhoods.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let operation = arguments.operation()?;
    if arguments.check {
        let names = operation.stages().iter().map(|program| program.name());
        check::known(names).map_err(|error| Failure::Usage(error.to_string()))?;
    }
    let cloud = arguments.cloud().map_err(remedied)?;
    let queries = arguments.queries(&operation, &cloud).map_err(remedied)?;
    let (settings, attributes) = (arguments.settings()?, arguments.attributes()?);
    let asked = Process {
        operation: &operation,
        k: arguments.k(),
        radius: arguments.radius(),
        iterations: arguments.iterations,
        passes: arguments.passes(),
        settings: &settings,
        attributes: &attributes,
    };
    let Carrier { engine, rate, clock } = arguments.hardware.open(arguments.format, arguments.rate, arguments.seed)?;
    let processed = with_count("processing", number_of(&queries), |progress| {
        process(&cloud, &queries, &asked, &*engine, progress)
    })?;
    let results = Results::begin(&arguments.output)?;
    write_files(&processed, &arguments.write, results.folder())?;
    let compared = compare(arguments, &processed)?;
    let (cost, lut4) = cost(arguments, &operation, rate)?;
    let report = ProcessReport {
        summary: processed.summary.clone(),
        k: asked.k,
        radius: asked.radius,
        iterations_limit: asked.iterations,
        format: arguments.format.to_string(),
        clock,
        cost,
        lut4,
        compared,
    };
    let markdown = report.markdown();
    write(&results.folder().join("report.md"), &markdown)?;
    let text = serde_json::to_string_pretty(&report).expect("reports have string keys");
    write(&results.folder().join("report.json"), &text)?;
    results.finish(&OWN_FILES)?;
    output.print(&json!(report), &format!("{markdown}\nWritten to {}.", arguments.output.display()))?;
    let violated: Result<(), Uncompared> = report.compared.as_deref().map_or(Ok(()), check::within_bounds);
    violated.map_err(Failure::Operator)
}
