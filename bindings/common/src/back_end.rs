//! What computes.

use crate::BindingError;
use pointcore::search::SearchEngine;
use pointcore::splat::RenderEngine;

/// What computes a frame or answers a search. There will be more: a board behind AXI is another one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum BackEnd {
    /// The bit-exact, cycle-accurate golden model; needs no tools.
    #[default]
    Golden,
    /// The generated Verilog under Verilator.
    Verilog,
    /// The generated Verilog under Verilator, every output compared with the golden model in every cycle.
    VerilogInLockstep,
}

impl BackEnd {
    /// The back end of a name, compared with the golden model or not.
    ///
    /// # Errors
    /// There is none of this name, or nothing to compare.
    pub fn named(name: &str, in_lockstep: bool) -> Result<Self, BindingError> {
        match (name, in_lockstep) {
            ("golden", false) => Ok(Self::Golden),
            ("verilog", false) => Ok(Self::Verilog),
            ("verilog", true) => Ok(Self::VerilogInLockstep),
            ("golden", true) => Err(BindingError::input("lockstep goes with the back end \"verilog\"")),
            _ => Err(BindingError::input(format!("the back end is {name:?}: expected \"golden\" or \"verilog\""))),
        }
    }

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Golden => "golden",
            Self::Verilog | Self::VerilogInLockstep => "verilog",
        }
    }

    pub(crate) const fn search(self) -> SearchEngine {
        match self {
            Self::Golden => SearchEngine::Golden,
            Self::Verilog => SearchEngine::Hardware,
            Self::VerilogInLockstep => SearchEngine::Lockstep,
        }
    }

    pub(crate) const fn render(self) -> RenderEngine {
        match self {
            Self::Golden => RenderEngine::Golden,
            Self::Verilog => RenderEngine::Hardware,
            Self::VerilogInLockstep => RenderEngine::Lockstep,
        }
    }
}
