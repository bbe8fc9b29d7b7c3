//! A core of a random configuration, generated and verilated, and its runs beside the model.

use super::{bound, extent};
use crate::LabError;
use fastrand::Rng;
use pointcore::configuration::Configuration;
use pointcore::search::SearchCore;
use pointcore::splat::SplatCore;
use pointcore::splat::mask::{end_records, outputs};
use pointcore::stimuli::surroundings::{Idle, Pending, Surroundings};
use pointcore::stimuli::{configuration, renderer, searcher};
use pointcore_contract::{search, splat};
use pointcore_golden::unit::{Ported, Unit};
use pointcore_golden::{search::Top as SearchModel, splat::Top as SplatModel};
use pointcore_tb::lockstep::{Golden, Lockstep, LockstepError};
use pointcore_tb::verilated::{BuildOptions, Builder, Library, VerilogSource};
use rtl::Design;
use serde::{Deserialize, Serialize};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

/// No run takes as many cycles, unless items move for ever and nothing comes of it.
const RUN_CYCLES: u64 = 50_000_000;

/// Which core.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Core {
    /// The renderer.
    Splat,
    /// The search core.
    Search,
}

impl Core {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Splat, Self::Search];

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Splat => "splat",
            Self::Search => "search",
        }
    }
}

/// A configuration of either core.
#[derive(Clone, Debug)]
pub enum AnyConfig {
    /// Of a renderer.
    Splat(splat::Config),
    /// Of a search core.
    Search(search::Config),
}

/// How a run went.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ran {
    /// Cycles compared.
    pub cycles: u64,
    /// What came out.
    pub pending: Pending,
}

/// Why a run was none, or not a clean one.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// Hardware and model differ, the core is stuck, an assertion failed; or it could not be run at all.
    #[error(transparent)]
    Lockstep(#[from] LockstepError),
    /// Something did not come out, though the run ended.
    #[error("{} of {} {} came out", .0.done, .0.expected, .0.what)]
    Incomplete(Pending),
    /// The model or the host cannot go on.
    #[error("the model stopped: {0}")]
    Panicked(String),
}

/// A generated core.
enum Generated {
    Splat(splat::Config, SplatCore),
    Search(search::Config, SearchCore),
}

/// A core that can be run.
pub struct Device {
    generated: Generated,
    library: Arc<Library>,
}

impl AnyConfig {
    /// The configuration, if it is one of these cores'.
    #[must_use]
    pub fn of(configuration: Configuration) -> Option<Self> {
        match configuration {
            Configuration::Splat(config) => Some(Self::Splat(config)),
            Configuration::Search(config) => Some(Self::Search(config)),
            Configuration::Points(_) => None,
        }
    }

    /// A random one.
    #[must_use]
    pub fn random(core: Core, random: &mut Rng) -> Self {
        match core {
            Core::Splat => Self::Splat(configuration::renderer(random)),
            Core::Search => Self::Search(configuration::search_core(random)),
        }
    }

    /// Its core.
    #[must_use]
    pub const fn core(&self) -> Core {
        match self {
            Self::Splat(_) => Core::Splat,
            Self::Search(_) => Core::Search,
        }
    }

    /// As a file.
    #[must_use]
    pub fn text(&self) -> String {
        let text = match self {
            Self::Splat(config) => toml::to_string(config),
            Self::Search(config) => toml::to_string(config),
        };
        text.expect("a configuration is a TOML table")
    }
}

impl Device {
    /// Generates and verilates a core.
    ///
    /// # Errors
    /// A fault of the generator, or a tool is missing or fails.
    pub fn build(config: &AnyConfig, builder: &Arc<Builder>, options: BuildOptions) -> Result<Self, LabError> {
        let build = |design: &Design| builder.build(&VerilogSource::from(design), options);
        let (generated, library) = match config {
            AnyConfig::Splat(config) => {
                let core = SplatCore::generate(config)?;
                let library = build(&core.design)?;
                (Generated::Splat(config.clone(), core), library)
            }
            AnyConfig::Search(config) => {
                let core = SearchCore::generate(config)?;
                let library = build(&core.design)?;
                (Generated::Search(config.clone(), core), library)
            }
        };
        Ok(Self { generated, library })
    }

    /// The compiled core.
    #[must_use]
    pub const fn library(&self) -> &Arc<Library> {
        &self.library
    }

    /// A run with random frames or searches, paces and memory, everything from one seed; `reproduce` is the command
    /// that makes it.
    ///
    /// # Errors
    /// It was no clean one.
    pub fn run(&self, seed: u64, reproduce: &str) -> Result<Ran, RunError> {
        let random = &mut Rng::with_seed(seed);
        match &self.generated {
            Generated::Splat(config, _) => {
                let script = extent::renderer(config, random);
                self.render(script, seed, reproduce)
            }
            Generated::Search(config, _) => {
                let script = searcher::Script::random(config, extent::SEARCH, random);
                self.search(script, seed, reproduce)
            }
        }
    }

    /// A run of a renderer.
    ///
    /// # Errors
    /// It was no clean one.
    ///
    /// # Panics
    /// When the device is a search core.
    pub fn render(&self, script: renderer::Script, seed: u64, reproduce: &str) -> Result<Ran, RunError> {
        let Generated::Splat(config, core) = &self.generated else { panic!("a search core renders nothing") };
        let latencies = core.latencies();
        let quiet = bound::renderer(config, &latencies);
        let idle = Idle::new(&self.library, Rng::with_seed(seed));
        let host = renderer::Renderer::new(config, script, Some(idle), quiet);
        let interface = (splat::units::top::UNIT.interface)(config);
        let lockstep = || {
            let mut model = Ported::new(config, SplatModel::new(config, &latencies));
            let step = move |inputs: &[u64], outputs: &mut [u64]| model.step(inputs, outputs);
            let lockstep = Lockstep::new(&self.library, step, seed).reproduced_by(reproduce.to_owned());
            lockstep.mask(end_records(&interface, &outputs(&interface)))
        };
        guarded(|| run(lockstep, host))
    }

    /// A run of a search core.
    ///
    /// # Errors
    /// It was no clean one.
    ///
    /// # Panics
    /// When the device is a renderer.
    pub fn search(&self, script: searcher::Script, seed: u64, reproduce: &str) -> Result<Ran, RunError> {
        let Generated::Search(config, core) = &self.generated else { panic!("a renderer searches nothing") };
        let latencies = core.latencies();
        let quiet = bound::search_core(config, &latencies, &script.tree);
        let mut random = Rng::with_seed(seed);
        let idle = Idle::new(&self.library, random.fork());
        let host = searcher::Searcher::new(config, script, Some(idle), quiet, random);
        let lockstep = || {
            let mut model = Ported::new(config, SearchModel::new(config, latencies));
            let step = move |inputs: &[u64], outputs: &mut [u64]| model.step(inputs, outputs);
            Lockstep::new(&self.library, step, seed).reproduced_by(reproduce.to_owned())
        };
        guarded(|| run(lockstep, host))
    }
}

/// A run in which everything comes out.
fn run<G: Golden>(lockstep: impl Fn() -> Lockstep<G>, host: impl Surroundings) -> Result<Ran, RunError> {
    let ended = lockstep().limit(RUN_CYCLES).run(host.clone())?;
    if let Some(cycle) = ended.stimulus.stuck() {
        // The same once more, cut off there: that tells inputs and waveform of the silence.
        lockstep().limit(cycle).run(host.without_watch())?;
    }
    let pending = ended.stimulus.pending();
    if pending.done != pending.expected {
        return Err(RunError::Incomplete(pending));
    }
    Ok(Ran { cycles: ended.report.cycles, pending })
}

/// What panics counts as a failure of the run: models state what they take for certain.
fn guarded(run: impl FnOnce() -> Result<Ran, RunError>) -> Result<Ran, RunError> {
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("it panicked");
        Err(RunError::Panicked(text.to_owned()))
    })
}
