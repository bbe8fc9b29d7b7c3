//! `pointcore vectors SCENE -o DIR` and `pointcore vectors --points FILE -o DIR`.

use super::search::SearchArguments;
use super::{Failure, Output, load, write_bytes};
use pointcore::configuration::Configuration;
use pointcore::scene::InvalidPoints;
use pointcore::search::{PointSource, Rounding, Tree};
use pointcore::splat::EncodedFrame;
use pointcore::vectors::{self, Vectors};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Where memory begins if the user does not say.
const DEFAULT_BASE: &str = "0x10000000";

/// What is said of a search alone.
const OF_SEARCHES: [&str; 12] =
    ["points", "k", "radius", "queries", "order", "limit", "tree", "config", "cache", "epsilon", "alpha", "seed"];

/// An address, in decimal or with `0x` in hexadecimal.
fn address(text: &str) -> Result<u64, String> {
    let parsed = text.strip_prefix("0x").map_or_else(|| text.parse(), |digits| u64::from_str_radix(digits, 16));
    parsed.map_err(|_| "expected an address such as 0x10000000".to_owned())
}

/// Arguments of `vectors`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A scene file: vectors for the renderer.
    #[arg(required_unless_present = "points", conflicts_with_all = OF_SEARCHES)]
    scene: Option<PathBuf>,
    /// Replaces a value of the scene file, e.g. `--set overrides.stream_bits=32`; paths are relative to the scene file.
    #[arg(long = "set", value_name = "KEY=VALUE", conflicts_with = "points")]
    settings: Vec<String>,
    /// Points to search in, a model file or `surface:COUNT`: vectors for the search core.
    #[arg(long, value_name = "FILE|surface:COUNT")]
    points: Option<PointSource>,
    #[command(flatten)]
    search: SearchArguments,
    /// Where the memory begins that the core is given, a multiple of 0x1000.
    #[arg(long, value_name = "ADDRESS", default_value = DEFAULT_BASE, value_parser = address)]
    base: u64,
    /// The folder to write into; made if missing.
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
}

impl Arguments {
    fn frame(&self, scene: &Path) -> Result<(Vectors, Value, String), Failure> {
        let (scene, plan) = load(scene, &self.settings)?;
        let vectors = vectors::frame(&plan.config, &EncodedFrame::new(&scene, &plan), self.base)?;
        let document = json!(vectors);
        Ok((vectors, document, Configuration::Splat(plan.config).text()))
    }

    fn neighbors(&self, source: &PointSource) -> Result<(Vectors, Value, String), Failure> {
        let search = &self.search;
        search.check()?;
        let reuse = search.reuse();
        if reuse.epsilon > 0.0 {
            let message =
                "--epsilon: how near a cached answer comes depends on what the memory's timing leaves in the cache";
            return Err(Failure::Usage(message.to_owned()));
        }
        let (config, points) = search.hardware(source, InvalidPoints::Refuse)?;
        let questions = search.questions(&config, &points, InvalidPoints::Refuse)?;
        let rounding = Rounding::of(&points, search.k).check()?;
        let tree = Tree::build(&config, &points, search.tree)?;
        let vectors = vectors::search(&config, tree, &questions.queries, reuse, self.base)?;
        let mut document = json!(vectors);
        document["origin"] = json!(rounding.origin);
        Ok((vectors, document, Configuration::Search(config).text()))
    }
}

/// Writes the vectors of a frame or a search.
pub fn run(arguments: &Arguments, output: Output) -> Result<(), Failure> {
    let (vectors, mut document, config) = match (&arguments.scene, &arguments.points) {
        (Some(scene), _) => arguments.frame(scene),
        (None, Some(points)) => arguments.neighbors(points),
        (None, None) => Err(Failure::Usage("expected a scene or --points".to_owned())),
    }?;
    document["generator"] = Value::from(concat!("pointcore ", env!("CARGO_PKG_VERSION")));
    let text = serde_json::to_string_pretty(&document).expect("vectors have string keys");
    let files = [("vectors.json", (text + "\n").into_bytes()), ("config.toml", config.into_bytes())];
    let files = files.iter().map(|(name, contents)| (*name, contents.as_slice())).chain(vectors.files());
    let mut names = Vec::new();
    for (name, contents) in files {
        let path = arguments.output.join(name);
        write_bytes(&path, contents)?;
        names.push(path.display().to_string());
    }
    output.print(&json!({ "top": vectors.top, "files": names }), &names.join("\n"))
}
