//! What carries programs out: the interpreter, or a point processor.

use super::super::memory::MemoryArguments;
use super::super::reuse::ReuseArguments;
use super::super::{Failure, choices, numbers};
use pointcore::area::recorded::Clock;
use pointcore::configuration::{self, Configuration};
use pointcore::process::{Engine, Interpreted, Simulation, Timed};
use pointcore::search::{SearchEngine, SearchError, Splitting};
use pointcore_contract::Format;
use pointcore_contract::points::Config;
use pointcore_tb::lockstep::Stall;
use std::path::PathBuf;

/// What carries programs out.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Model {
    /// The golden interpreter: bit-exact, of the program alone, without time.
    Interpreter,
    /// The bit-exact, cycle-accurate golden model of search and program.
    Golden,
    /// The generated Verilog under Verilator, in lockstep with the golden model.
    Rtl,
}

/// What carries programs out, and how fast it is.
pub struct Carrier {
    /// The interpreter, or a point processor.
    pub engine: Box<dyn Engine>,
    /// Cycles a neighbor.
    pub rate: u32,
    /// The clock at which times are told, where they are counted.
    pub clock: Option<Clock>,
}

/// Arguments of the hardware.
#[derive(clap::Args)]
pub struct HardwareArguments {
    /// What carries the programs out.
    #[arg(long, value_enum, default_value = "interpreter")]
    model: Model,
    /// Do not compare the Verilog with the golden model: faster, but trusts it.
    #[arg(long)]
    no_lockstep: bool,
    /// Hold every stream back in this share of the cycles, at random.
    #[arg(long, value_name = "SHARE", default_value_t = 0.0, value_parser = numbers::within(0.0..1.0, "a share from 0 up to, but not, 1"))]
    stalls: f64,
    /// The hardware's configuration, such as configs/points.toml; its program is replaced by what is done.
    #[arg(long, value_name = "FILE", conflicts_with = "rate")]
    config: Option<PathBuf>,
    #[command(flatten)]
    reuse: ReuseArguments,
    #[command(flatten)]
    memory: MemoryArguments,
    /// How the tree divides points.
    #[arg(long, value_parser = choices::splittings(), default_value = "packed")]
    tree: Splitting,
    /// The clock for which queries per second are stated, in MHz; by default the recorded one of the configuration, else 100.
    #[arg(long, value_name = "MHZ", value_parser = numbers::positive())]
    clock_mhz: Option<f64>,
}

impl HardwareArguments {
    const fn engine(&self) -> Option<SearchEngine> {
        match (self.model, self.no_lockstep) {
            (Model::Interpreter, _) => None,
            (Model::Golden, _) => Some(SearchEngine::Golden),
            (Model::Rtl, true) => Some(SearchEngine::Hardware),
            (Model::Rtl, false) => Some(SearchEngine::Lockstep),
        }
    }

    /// Checks what goes together.
    fn check(&self) -> Result<(), Failure> {
        if self.no_lockstep && self.model != Model::Rtl {
            return Err(Failure::Usage("--no-lockstep goes with --model rtl".to_owned()));
        }
        let timed = [
            ("--stalls", self.stalls > 0.0),
            ("--config", self.config.is_some()),
            ("--cache, --epsilon and --alpha", self.reuse.is_said()),
        ];
        match timed.into_iter().find(|(_, is_said)| *is_said && self.model == Model::Interpreter) {
            Some((option, _)) => {
                let message = "the interpreter knows no hardware: add --model golden or --model rtl";
                Err(Failure::Usage(format!("{option}: {message}")))
            }
            None => self.reuse.check(),
        }
    }

    /// The configuration that is given.
    fn hardware(&self, format: Format) -> Result<Option<Config>, Failure> {
        let Some(path) = &self.config else { return Ok(None) };
        let Configuration::Points(config) = configuration::parse(path, &configuration::read_text(path)?)? else {
            let problem = "is not for the point processor: expected a file with the line `kind = \"points\"`";
            return Err(configuration::wrong(path, problem).into());
        };
        self.reuse.check_hardware(config.search.neighbor_cache, path)?;
        let geometry = config.search.geometry;
        if geometry != format {
            let problem =
                format!("has `geometry` = \"{geometry}\", but floats are in {format}: add --format {geometry}");
            return Err(configuration::wrong(path, problem).into());
        }
        Ok(Some(config))
    }

    /// What carries programs out.
    pub fn open(&self, format: Format, rate: u32, seed: u64) -> Result<Carrier, Failure> {
        self.check()?;
        let Some(engine) = self.engine() else {
            return Ok(Carrier { engine: Box::new(Interpreted), rate, clock: None });
        };
        let memory = self.memory.settings();
        memory.validate().map_err(SearchError::from)?;
        let hardware = self.hardware(format)?;
        let rate = hardware.as_ref().map_or(rate, |hardware| hardware.process.rate);
        let clock = Clock::of(&Configuration::Points(hardware.clone().unwrap_or_default()), self.clock_mhz);
        let simulation = Simulation {
            hardware,
            rate,
            splitting: self.tree,
            memory,
            reuse: self.reuse.factors(),
            neighbor_cache: self.reuse.neighborhoods(),
            stall: if self.stalls > 0.0 { Stall::Random(self.stalls) } else { Stall::Never },
            seed,
            reproduce: std::env::args().collect::<Vec<_>>().join(" "),
            ..Simulation::of(engine)
        };
        Ok(Carrier { engine: Box::new(Timed::new(simulation)), rate, clock: Some(clock) })
    }
}
