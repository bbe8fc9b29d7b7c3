//! The subcommands of `pointcore` and what they share.

pub mod accuracy;
pub mod area;
pub mod bench;
pub mod budget;
pub mod choices;
pub mod diagram;
pub mod generate;
pub mod inspect;
pub mod knn;
pub mod memory;
pub mod mutate;
pub mod numbers;
pub mod output;
pub mod plan;
pub mod process;
pub mod progress;
pub mod results;
pub mod reuse;
pub mod run;
pub mod search;
pub mod shard;
pub mod simulation;
pub mod soak;
pub mod stability;
pub mod translate;
pub mod vectors;
pub mod waveform;

pub use output::Output;

use pointcore::area::estimate::Estimator;
use pointcore::configuration::{self, Configuration, ConfigurationError};
use pointcore::cost::CostError;
use pointcore::cost::budget::BudgetError;
use pointcore::generated::GenerateError;
use pointcore::package::PackageError;
use pointcore::picture::PictureError;
use pointcore::plan::{DepthLoss, MovingPlan, Plan, PlanError};
use pointcore::process::ProcessError;
use pointcore::process::check::Uncompared;
use pointcore::scene::{Scene, SceneError};
use pointcore::search::{SearchError, WrongAnswer};
use pointcore::splat::{Fates, RenderError};
use pointcore::vectors::VectorsError;
use pointcore_contract::splat::Config;
use pointcore_lab::synthesis::SynthesisError;
use pointcore_lab::{Figures, LabError, note};
use pointcore_tb::cache::Cache;
use pointcore_tb::lockstep::LockstepError;
use pointcore_tb::verilated::VerilatedError;
use std::path::{Path, PathBuf};

/// Where the record of areas lies in the project; elsewhere the one counts that was there when this command was built.
const RECORD: &str = "docs/area.json";

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The scene or a model.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The hardware a scene asks for.
    #[error("{}: {source}", path.display())]
    Plan {
        /// The scene file.
        path: PathBuf,
        /// What is wrong with its overrides.
        source: Box<PlanError>,
    },
    /// A budget that holds no hardware for the scene.
    #[error("{}: {source}", path.display())]
    Budget {
        /// The scene file.
        path: PathBuf,
        /// What there is too little of.
        source: Box<BudgetError>,
    },
    /// A scene on the hardware of a configuration that excludes what it calls for.
    #[error("{} on {}: {source}", path.display(), config.display())]
    Excluded {
        /// The scene file.
        path: PathBuf,
        /// The configuration file.
        config: PathBuf,
        /// The effect.
        source: Box<PlanError>,
    },
    /// A configuration file.
    #[error(transparent)]
    Configuration(#[from] ConfigurationError),
    /// A record of figures that are not of the hardware as it is now.
    #[error("{} is stale; each line is followed by what brings it up to date:\n{}", path.display(), list.trim_end())]
    Stale {
        /// The record.
        path: PathBuf,
        /// What is stale, and what to do.
        list: String,
    },
    /// Arguments that do not go together.
    #[error("{0}")]
    Usage(String),
    /// A fault of the generator.
    #[error("the hardware could not be generated: {0}")]
    Generate(#[from] GenerateError),
    /// Verilator, the compiler, or an assertion in the hardware.
    #[error(transparent)]
    Verilated(#[from] VerilatedError),
    /// A core's files.
    #[error(transparent)]
    Package(#[from] PackageError),
    /// Hardware and model differ, or the run did not end.
    #[error(transparent)]
    Mismatch(#[from] LockstepError),
    /// A neighbor search.
    #[error(transparent)]
    Search(#[from] SearchError),
    /// An operator on neighborhoods.
    #[error(transparent)]
    Process(#[from] ProcessError),
    /// Outputs of an operator that are not those of f64.
    #[error("{0}")]
    Operator(Uncompared),
    /// Vectors for a driver.
    #[error(transparent)]
    Vectors(#[from] VectorsError),
    /// Neighbors that are not the nearest.
    #[error("{0}")]
    Neighbors(WrongAnswer),
    /// Runs in which hardware and model differ, or nothing moves any more.
    #[error("{0}")]
    Soak(String),
    /// What could not be measured.
    #[error(transparent)]
    Lab(#[from] LabError),
    /// A result that cannot be written.
    #[error("{}: cannot be written: {source}", path.display())]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// What cannot be printed.
    #[error("standard output cannot be written: {0}")]
    Print(std::io::Error),
    /// A picture that cannot be written.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// A scene of which nothing is to be seen.
    #[error("{}: nothing is drawn of its {} splats ({fates}): {}", path.display(), fates.total(), fates.remedy())]
    Blank {
        /// The scene file.
        path: PathBuf,
        /// What became of the splats.
        fates: Fates,
    },
    /// A frame beyond a sequence.
    #[error(transparent)]
    Render(RenderError),
}

impl From<RenderError> for Failure {
    fn from(error: RenderError) -> Self {
        match error {
            RenderError::Generate(error) => error.into(),
            RenderError::Verilated(error) => error.into(),
            RenderError::Lockstep(error) => error.into(),
            other => Self::Render(other),
        }
    }
}

impl From<SynthesisError> for Failure {
    fn from(error: SynthesisError) -> Self {
        Self::Lab(error.into())
    }
}

impl From<CostError> for Failure {
    fn from(error: CostError) -> Self {
        Self::Lab(error.into())
    }
}

/// Estimates areas by the project's record.
pub fn estimator() -> Result<Estimator, Failure> {
    let cache = Cache::new(Cache::default_folder("accuracy"));
    Ok(pointcore_lab::accuracy::estimator(Path::new(RECORD), &cache)?)
}

/// Loads a scene in which nothing moves while the shutter is open, and derives its hardware.
pub fn load(path: &Path, settings: &[String]) -> Result<(Scene, Plan), Failure> {
    let scene = Scene::load(path, settings)?;
    let plan = plan_on(path, &scene, None)?;
    Ok((scene, plan))
}

/// The renderer of a configuration file.
pub struct Renderer<'a> {
    path: &'a Path,
    config: Config,
}

impl<'a> Renderer<'a> {
    /// Reads the file.
    pub fn read(path: &'a Path) -> Result<Self, Failure> {
        match configuration::parse(path, &configuration::read_text(path)?)? {
            Configuration::Splat(config) => Ok(Self { path, config }),
            _ => Err(configuration::wrong(
                path,
                "is not for the renderer: rendering needs a file with the line `kind = \"splat\"`",
            )
            .into()),
        }
    }
}

/// The hardware that a loaded scene calls for, or that of a configuration if it is enough.
pub fn plan_on(path: &Path, scene: &Scene, renderer: Option<&Renderer>) -> Result<Plan, Failure> {
    let plan = planned(path, scene, renderer, Plan::of, Plan::on)?;
    warn(path, scene, &plan);
    Ok(plan)
}

/// The same for a scene that moves; a configuration is for what moves.
pub fn moving_plan_on(path: &Path, scene: &Scene, renderer: Option<&Renderer>) -> Result<MovingPlan, Failure> {
    let plan = planned(path, scene, renderer, MovingPlan::of, MovingPlan::on)?;
    warn(path, scene, &plan.moving);
    Ok(plan)
}

fn planned<P>(
    path: &Path,
    scene: &Scene,
    renderer: Option<&Renderer>,
    of: impl FnOnce(&Scene) -> Result<P, PlanError>,
    on: impl FnOnce(&Scene, &Config) -> Result<P, PlanError>,
) -> Result<P, Failure> {
    let Some(Renderer { path: config, config: given }) = renderer else {
        return of(scene).map_err(|source| Failure::Plan { path: path.to_owned(), source: Box::new(source) });
    };
    if !scene.overrides.is_empty() {
        let keys: Vec<_> = scene.overrides.keys().map(|key| format!("overrides.{key}")).collect();
        note!("ignored, for --config {} says the hardware: {}", config.display(), keys.join(", "));
    }
    let (path, config) = (path.to_owned(), (*config).to_owned());
    on(scene, given).map_err(|source| Failure::Excluded { path, config, source: Box::new(source) })
}

/// Says what will not look right.
fn warn(path: &Path, scene: &Scene, plan: &Plan) {
    if let Some(loss) = DepthLoss::of(scene, plan) {
        note!("{}: {loss}", path.display());
    }
}

/// Writes a text file, making its folder.
pub fn write(path: &Path, contents: &str) -> Result<(), Failure> {
    write_bytes(path, contents.as_bytes())
}

/// Writes a file, making its folder.
pub fn write_bytes(path: &Path, contents: &[u8]) -> Result<(), Failure> {
    let folder = path.parent().map_or(Ok(()), std::fs::create_dir_all);
    let written = folder.and_then(|()| std::fs::write(path, contents));
    written.map_err(|source| Failure::Write { path: path.to_owned(), source })
}

/// The figures that are already in the file; none if there is no such file.
fn existing(path: &Path) -> Result<Figures, Failure> {
    let wrong = |problem: String| Failure::from(configuration::wrong(path, problem));
    match std::fs::read_to_string(path) {
        Ok(text) => serde_json::from_str(&text).map_err(|error| wrong(format!("{error}; delete it to start anew"))),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Figures::new()),
        Err(error) => Err(wrong(format!("cannot be read: {error}"))),
    }
}

/// Adds figures to a file's, in the place of older ones of the same keys; returns all.
pub fn merge(path: &Path, figures: Figures) -> Result<Figures, Failure> {
    let mut merged = existing(path)?;
    merged.extend(figures);
    let text = serde_json::to_string_pretty(&merged).expect("figures have string keys");
    write(path, &(text + "\n"))?;
    Ok(merged)
}

/// A scene's or configuration's name: its file without folder and ending.
pub fn scene_name(path: &Path) -> String {
    path.file_stem().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}
