//! `pointcore gen SCENE|CONFIG -o DIR`.

use super::{Failure, Output, load, write};
use pointcore::core_a::{Core, area};
use pointcore_spec::core_a::Config;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Constraint files that go with the Verilog, by name.
const CONSTRAINTS: [(&str, &str); 3] = [
    ("core_a_top.lpf", include_str!("../../../constraints/core_a_top.lpf")),
    ("core_a_top.xdc", include_str!("../../../constraints/core_a_top.xdc")),
    ("core_a_top.sdc", include_str!("../../../constraints/core_a_top.sdc")),
];

/// Arguments of `gen`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A scene file, or a hardware configuration such as configs/fpga.toml.
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
fn configuration(arguments: &Arguments) -> Result<Config, Failure> {
    let path = &arguments.source;
    let wrong = |problem: String| Failure::Configuration { path: path.clone(), problem };
    let text = std::fs::read_to_string(path).map_err(|error| wrong(format!("cannot be read: {error}")))?;
    let table: toml::Table = toml::from_str(&text).map_err(|error| wrong(error.to_string().trim_end().to_owned()))?;
    if SCENE_TABLES.iter().any(|key| table.contains_key(*key)) {
        return Ok(load(path, &arguments.settings)?.1.config);
    }
    if !arguments.settings.is_empty() {
        return Err(Failure::Usage("--set changes scenes; edit the configuration file instead".to_owned()));
    }
    let config: Config = toml::from_str(&text).map_err(|error| wrong(error.to_string().trim_end().to_owned()))?;
    config.validate().map_err(|error| wrong(error.to_string()))?;
    Ok(config)
}

/// Writes Verilog, manifest, configuration and constraints; returns the files.
pub fn write_files(core: &Core, config: &Config, folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let manifest = json!({
        "generator": concat!("pointcore ", env!("CARGO_PKG_VERSION")),
        "top": core.design.top(),
        "datapaths": core.manifests,
        "modules": area::modules(&core.design),
        "area": area::document(&core.design),
    });
    let manifest = serde_json::to_string_pretty(&manifest).expect("manifests have string keys");
    let config = toml::to_string_pretty(config).expect("a configuration is a TOML table");
    let mut files = vec![
        ("core_a_top.v", core.design.verilog().to_owned()),
        ("manifest.json", manifest + "\n"),
        ("config.toml", config),
    ];
    files.extend(CONSTRAINTS.map(|(name, text)| (name, text.to_owned())));
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
    let config = configuration(arguments)?;
    let core = Core::generate(&config)?;
    let files = write_files(&core, &config, &arguments.output)?;
    let names: Vec<_> = files.iter().map(|path| path.display().to_string()).collect();
    output.print(&json!({ "top": core.design.top(), "files": names }), &names.join("\n"));
    Ok(())
}
