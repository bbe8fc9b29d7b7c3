//! `pointcore gen SCENE|CONFIG -o DIR`.

use super::budget::{BudgetArguments, Planned};
use super::{Failure, Output, estimator, scene_name, write};
use pointcore::configuration::{self, Configuration};
use pointcore::package::{File, Package};
use pointcore::plan::MovingPlan;
use pointcore::scene::Model;
use pointcore::wording::plain;
use pointcore::{points, search, splat};
use pointcore_contract::splat::Config as SplatConfig;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Arguments of `gen`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A scene file, or a model as `run` draws it, or a hardware configuration such as configs/fpga.toml (the renderer), configs/knn.toml (the search core) or configs/points.toml (the point processor).
    source: PathBuf,
    /// The folder to write into; made if missing.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Also writes the core as a block for designs in rust-hdl, a Rust file that includes the Verilog beside it.
    #[arg(long)]
    rust_hdl: bool,
    /// Also writes the core as one file a module, `modules/MODULE.v`, and the list of them, `modules/TOP.f`.
    #[arg(long)]
    split: bool,
    #[command(flatten)]
    budget: BudgetArguments,
    /// Replaces a value of the scene file, e.g. `--set object.0.path=/scans/face.ply`; paths are relative to the scene file.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    settings: Vec<String>,
}

/// Tables of which every scene has one and no configuration has any.
const SCENE_TABLES: [&str; 2] = ["camera", "object"];

/// What stands still beside what moves: where its core goes, and what its name ends in.
pub const STILL: &str = "still";

/// The hardware for a scene, and for what stands still of one that moves.
fn planned(arguments: &Arguments) -> Result<(Configuration, Option<SplatConfig>), Failure> {
    let (_, planned) = arguments.budget.load(&arguments.source, &arguments.settings, estimator)?;
    Ok(match planned {
        Planned::Still(plan, _) => (Configuration::Splat(plan.config), None),
        Planned::Moving(plan) => {
            let MovingPlan { moving, still } = *plan;
            (Configuration::Splat(moving.config), still.map(|plan| plan.config))
        }
    })
}

/// Reads a configuration, from its own file or derived from a scene.
fn configuration(arguments: &Arguments) -> Result<(Configuration, Option<SplatConfig>), Failure> {
    let path = &arguments.source;
    if Model::is_model(path) {
        return planned(arguments);
    }
    let text = configuration::read_text(path)?;
    let table: toml::Table = toml::from_str(&text).map_err(|error| configuration::wrong(path, plain(&error)))?;
    if SCENE_TABLES.iter().any(|key| table.contains_key(*key)) {
        return planned(arguments);
    }
    if !arguments.settings.is_empty() || arguments.budget.is_limited() {
        let message = "--set, --device and --luts choose hardware for scenes; edit the configuration file instead";
        return Err(Failure::Usage(message.to_owned()));
    }
    Ok((configuration::parse(path, &text)?, None))
}

/// Writes a package's files into a folder; returns them.
pub fn write_package(package: &Package, folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let write = |File { name, text, .. }: File| {
        let path = folder.join(name);
        write(&path, &text).map(|()| path)
    };
    package.files().into_iter().map(write).collect()
}

/// Writes a core's files into a folder; returns its top, and them.
fn write_core(
    arguments: &Arguments,
    name: &str,
    configuration: Configuration,
    folder: &Path,
) -> Result<(String, Vec<PathBuf>), Failure> {
    let (mut package, design) = match configuration {
        Configuration::Splat(config) => {
            let core = splat::SplatCore::generate(&config)?;
            (Package::splat(name, &core, &config)?, core.design)
        }
        Configuration::Search(config) => {
            let core = search::SearchCore::generate(&config)?;
            (Package::search(name, &core, &config)?, core.design)
        }
        Configuration::Points(config) => {
            let core = points::PointsCore::generate(&config)?;
            (Package::points(name, &core, &config)?, core.design)
        }
    };
    if arguments.rust_hdl {
        package.add_rust_hdl(&design);
    }
    if arguments.split {
        package.add_modules(&design);
    }
    let files = write_package(&package, folder)?;
    Ok((package.top, files))
}

/// Generates a core into a folder, or the two of a scene in which some of it moves.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let name = scene_name(&arguments.source);
    let (configuration, still) = configuration(arguments)?;
    let (top, mut files) = write_core(arguments, &name, configuration, &arguments.output)?;
    if let Some(config) = still {
        let (name, folder) = (format!("{name}_{STILL}"), arguments.output.join(STILL));
        files.extend(write_core(arguments, &name, Configuration::Splat(config), &folder)?.1);
    }
    let names: Vec<_> = files.iter().map(|path| path.display().to_string()).collect();
    output.print(&json!({ "top": top, "files": names }), &names.join("\n"))
}
