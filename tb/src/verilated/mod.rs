//! Verilog, run: verilated, compiled and loaded into this process.
//!
//! [`Builder::build`] turns a [`VerilogSource`] into a [`Library`], from a cache where it can; [`Library::instantiate`] makes
//! [`VerilatedModel`]s of it, as many as wanted. Inputs and outputs cross in two arrays, one foreign call a cycle.

mod build;
mod model;
mod shim;
pub mod substitute;

use std::path::PathBuf;

pub use build::Builder;
pub use model::{Library, RESET, VerilatedModel};
pub use rtl::{Direction, ModuleInterface, Port, StreamDeclaration};

use rtl::Design;

use crate::cache::FileError;
use crate::toolchain::ToolchainError;

/// Verilog text and what of it is to be run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct VerilogSource {
    /// The whole design.
    pub verilog: String,
    /// Name of the top module.
    pub top: String,
    /// All its ports in declaration order, 1 to 64 bits wide. `clk` is driven by the harness, `rst` is an input like any other.
    pub ports: Vec<Port>,
    /// Which of the ports form streams and pulses.
    pub streams: Vec<StreamDeclaration>,
    /// What the modules in it show to each other, as far as that is known.
    pub interfaces: Vec<ModuleInterface>,
}

impl From<&Design> for VerilogSource {
    fn from(design: &Design) -> Self {
        Self {
            verilog: design.verilog().to_owned(),
            top: design.top().to_owned(),
            ports: design.ports().to_vec(),
            streams: design.streams().to_vec(),
            interfaces: design.interfaces().to_vec(),
        }
    }
}

/// How hard the compiler works on a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Optimization {
    /// Builds soonest: for units, which run for thousands of cycles.
    #[default]
    Quick,
    /// Runs fastest: for whole cores, which run for millions.
    Full,
}

impl Optimization {
    /// That of whole cores. A program that is built for development runs them no longer than tests do.
    pub const OF_CORES: Self = if cfg!(debug_assertions) { Self::Quick } else { Self::Full };

    /// What g++ is told of it.
    #[must_use]
    pub const fn compiler_arguments(self) -> &'static [&'static str] {
        match self {
            // Simulates no slower than -O1 in units' tests, of which compiling takes the most, and compiles in half its time. Without the
            // four passes, which look at all that is stored, it takes three quarters of that, and simulates as fast.
            Self::Quick => &["-Og", "-fno-tree-fre", "-fno-tree-pta", "-fno-tree-dce", "-fno-tree-dominator-opts"],
            Self::Full => &["-O2"],
        }
    }
}

/// Whether a model can write waveforms.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Trace {
    /// It cannot, and is faster for it.
    #[default]
    Off,
    /// It can, see [`VerilatedModel::open_trace`].
    On,
}

/// Choices of a build.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BuildOptions {
    /// How hard the compiler works.
    pub optimization: Optimization,
    /// Whether waveforms can be written.
    pub trace: Trace,
}

/// Why a model could not be built, loaded or stepped.
#[derive(Debug, thiserror::Error)]
pub enum VerilatedError {
    /// A tool is missing or too old.
    #[error(transparent)]
    Toolchain(#[from] ToolchainError),
    /// The design has a port that cannot be exchanged.
    #[error("port `{name}` of `{top}` is {width} bits wide; ports have 1 to 64 bits, split it into several")]
    PortWidth {
        /// The top module.
        top: String,
        /// The port.
        name: String,
        /// Its width.
        width: u32,
    },
    /// The design has a port whose name Verilator would change.
    #[error("port `{name}` of `{top}`: use letters, digits and single underscores, beginning with a letter")]
    PortName {
        /// The top module.
        top: String,
        /// The port.
        name: String,
    },
    /// A tool refused its input.
    #[error("{tool} failed on `{top}`:\n{output}")]
    Tool {
        /// The program.
        tool: String,
        /// The top module, or what else was built.
        top: String,
        /// Everything it printed.
        output: String,
    },
    /// A file of the cache could not be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The compiled model could not be loaded.
    #[error("cannot load {}: {source}", path.display())]
    Load {
        /// The shared object.
        path: PathBuf,
        /// What the loader said.
        source: libloading::Error,
    },
    /// The hardware stopped itself: an assertion failed or the simulation cannot go on.
    #[error("the hardware stopped:\n{0}")]
    Stopped(String),
    /// Waveforms were asked of a model that was built without them, or of a path that cannot be written.
    #[error("cannot write the waveform {}: {reason}", path.display())]
    Waveform {
        /// The file.
        path: PathBuf,
        /// Why not.
        reason: &'static str,
    },
}
