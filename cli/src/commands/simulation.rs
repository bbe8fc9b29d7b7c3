//! How a run is simulated: the arguments that `run` and `knn` share, and which of them go together.

use super::{Failure, numbers};
use pointcore::search::SearchEngine;
use pointcore::splat::RenderEngine;
use pointcore::waveform::{Waveform, Window};
use pointcore_tb::lockstep::Stall;
use std::path::PathBuf;

/// What is simulated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Simulated {
    /// The generated Verilog.
    Verilog,
    /// A model alone.
    Model,
}

/// How it is simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// The golden model alone.
    Golden,
    /// The Verilog alone.
    Hardware,
    /// Both, compared in every cycle.
    Lockstep,
}

/// Arguments of a simulation.
#[derive(clap::Args)]
pub struct SimulationArguments {
    /// Do not compare the Verilog with the golden model: faster, but trusts it.
    #[arg(long)]
    no_lockstep: bool,
    /// Write a waveform of the whole run (.fst, and .gtkw for GTKWave); implies --no-lockstep, slow and large.
    #[arg(long)]
    trace: bool,
    /// Write a waveform of these cycles of the run alone, A up to, but not, B; implies --trace.
    #[arg(long, value_name = "A..B")]
    pub trace_window: Option<Window>,
    /// Hold every stream back in this share of the cycles, at random.
    #[arg(long, value_name = "SHARE", default_value_t = 0.0, value_parser = numbers::within(0.0..1.0, "a share from 0 up to, but not, 1"))]
    stalls: f64,
}

impl SimulationArguments {
    /// Checks what goes together.
    pub fn check(&self, simulated: Simulated) -> Result<(), Failure> {
        if simulated == Simulated::Model && (self.no_lockstep || self.is_traced()) {
            return Err(Failure::Usage("--no-lockstep, --trace and --trace-window go with --model rtl".to_owned()));
        }
        Ok(())
    }

    /// Whether a waveform is written.
    pub const fn is_traced(&self) -> bool {
        self.trace || self.trace_window.is_some()
    }

    /// Whether streams are held back.
    pub fn is_stalled(&self) -> bool {
        self.stalls > 0.0
    }

    /// What steps, and whether it is compared.
    pub const fn engine(&self, simulated: Simulated) -> Engine {
        match (simulated, self.no_lockstep || self.is_traced()) {
            (Simulated::Model, _) => Engine::Golden,
            (Simulated::Verilog, true) => Engine::Hardware,
            (Simulated::Verilog, false) => Engine::Lockstep,
        }
    }

    /// How streams are held back.
    pub fn stall(&self) -> Stall {
        if self.is_stalled() { Stall::Random(self.stalls) } else { Stall::Never }
    }

    /// The waveform to be written, if one is wanted.
    pub fn waveform(&self, path: PathBuf) -> Option<Waveform> {
        self.is_traced().then(|| Waveform { path, window: self.trace_window.clone() })
    }
}

impl Engine {
    /// What reports call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Golden => "golden",
            Self::Hardware => "rtl",
            Self::Lockstep => "rtl in lockstep with golden",
        }
    }

    /// How many outputs differed where they are compared: a difference ends the run.
    pub const fn mismatches(self) -> Option<u64> {
        match self {
            Self::Lockstep => Some(0),
            Self::Golden | Self::Hardware => None,
        }
    }
}

impl From<Engine> for RenderEngine {
    fn from(engine: Engine) -> Self {
        match engine {
            Engine::Golden => Self::Golden,
            Engine::Hardware => Self::Hardware,
            Engine::Lockstep => Self::Lockstep,
        }
    }
}

impl From<Engine> for SearchEngine {
    fn from(engine: Engine) -> Self {
        match engine {
            Engine::Golden => Self::Golden,
            Engine::Hardware => Self::Hardware,
            Engine::Lockstep => Self::Lockstep,
        }
    }
}
