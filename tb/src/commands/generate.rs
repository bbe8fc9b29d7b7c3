//! `pointcore gen SCENE|CONFIG -o DIR`.

use super::{Failure, Output, load, write};
use pointcore::configuration::{self, Configuration};
use pointcore::core_a::{self, area};
use pointcore::core_b;
use pointcore_hdl::compiler::Manifest;
use pointcore_hdl::rtl::Design;
use pointcore_spec::core_a::Config as CoreAConfig;
use pointcore_spec::core_b::Config as CoreBConfig;
use serde_json::json;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Constraint files that go with the Verilog, by ending.
const CONSTRAINTS: [(&str, &str); 3] = [
    ("lpf", include_str!("../../../constraints/core_a_top.lpf")),
    ("xdc", include_str!("../../../constraints/core_a_top.xdc")),
    ("sdc", include_str!("../../../constraints/core_a_top.sdc")),
];

/// Arguments of `gen`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A scene file, or a hardware configuration such as configs/fpga.toml (core A, splatting) or configs/knn.toml (core B, neighbor search).
    source: PathBuf,
    /// The folder to write into; made if missing.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Replaces a value of the scene file, e.g. `--set object.0.path=/scans/face.ply`; paths are relative to the scene file.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    settings: Vec<String>,
}

/// Tables of which every scene has one and no configuration has any.
const SCENE_TABLES: [&str; 3] = ["camera", "image", "object"];

/// Reads a configuration, from its own file or derived from a scene.
fn configuration(arguments: &Arguments) -> Result<Configuration, Failure> {
    let path = &arguments.source;
    let text = configuration::read_text(path)?;
    let table: toml::Table =
        toml::from_str(&text).map_err(|error| configuration::wrong(path, error.to_string().trim_end()))?;
    if SCENE_TABLES.iter().any(|key| table.contains_key(*key)) {
        return Ok(Configuration::CoreA(load(path, &arguments.settings)?.1.config));
    }
    if !arguments.settings.is_empty() {
        return Err(Failure::Usage("--set changes scenes; edit the configuration file instead".to_owned()));
    }
    Ok(configuration::parse(path, &text)?)
}

/// Writes Verilog, manifest, configuration and constraints of core A; returns the files.
pub fn write_core_a(core: &core_a::Core, config: &CoreAConfig, folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let config = toml::to_string_pretty(config).expect("a configuration is a TOML table");
    write_files(&core.design, &core.manifests, config, folder)
}

/// Writes Verilog, manifest, configuration and constraints of core B; returns the files.
pub fn write_core_b(core: &core_b::Core, config: &CoreBConfig, folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    write_files(&core.design, &core.manifests, configuration::core_b_text(config), folder)
}

fn write_files(
    design: &Design,
    datapaths: &BTreeMap<String, Manifest>,
    config: String,
    folder: &Path,
) -> Result<Vec<PathBuf>, Failure> {
    let top = design.top();
    let manifest = json!({
        "generator": concat!("pointcore ", env!("CARGO_PKG_VERSION")),
        "top": top,
        "datapaths": datapaths,
        "modules": area::modules(design),
        "area": area::document(design),
    });
    let manifest = serde_json::to_string_pretty(&manifest).expect("manifests have string keys");
    let mut files = vec![
        (format!("{top}.v"), design.verilog().to_owned()),
        ("manifest.json".to_owned(), manifest + "\n"),
        ("config.toml".to_owned(), config),
    ];
    files.extend(CONSTRAINTS.map(|(ending, text)| (format!("{top}.{ending}"), text.to_owned())));
    files
        .into_iter()
        .map(|(name, text)| {
            let path = folder.join(name);
            write(&path, &text).map(|()| path)
        })
        .collect()
}

/// Generates a core into a folder.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let folder = &arguments.output;
    let (top, files) = match configuration(arguments)? {
        Configuration::CoreA(config) => {
            let core = core_a::Core::generate(&config)?;
            (core.design.top().to_owned(), write_core_a(&core, &config, folder)?)
        }
        Configuration::CoreB(config) => {
            let core = core_b::Core::generate(&config)?;
            (core.design.top().to_owned(), write_core_b(&core, &config, folder)?)
        }
    };
    let names: Vec<_> = files.iter().map(|path| path.display().to_string()).collect();
    output.print(&json!({ "top": top, "files": names }), &names.join("\n"));
    Ok(())
}
