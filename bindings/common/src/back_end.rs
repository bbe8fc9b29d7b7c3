//! What computes.

use crate::BindingError;
use pointcore::search::SearchEngine;
use pointcore::splat::RenderEngine;

/// Where the interpreter has nothing to interpret.
const NO_PROGRAM: &str = "the interpreter carries out programs alone: expected another back end";

/// What computes a frame, carries a program out, or answers a search. There will be more: a board behind AXI is another.
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
    /// The golden interpreter of programs: bit-exact, without time.
    Interpreter,
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
            ("interpreter", false) => Ok(Self::Interpreter),
            ("golden" | "interpreter", true) => Err(BindingError::input("lockstep goes with the back end \"verilog\"")),
            _ => {
                let expected = "expected \"golden\" or \"verilog\", or \"interpreter\" for programs";
                Err(BindingError::input(format!("the back end is {name:?}: {expected}")))
            }
        }
    }

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Golden => "golden",
            Self::Verilog | Self::VerilogInLockstep => "verilog",
            Self::Interpreter => "interpreter",
        }
    }

    /// What runs the point processor; none for the interpreter.
    pub(crate) const fn process(self) -> Option<SearchEngine> {
        match self {
            Self::Golden => Some(SearchEngine::Golden),
            Self::Verilog => Some(SearchEngine::Hardware),
            Self::VerilogInLockstep => Some(SearchEngine::Lockstep),
            Self::Interpreter => None,
        }
    }

    pub(crate) fn search(self) -> Result<SearchEngine, BindingError> {
        self.process().ok_or_else(|| BindingError::input(NO_PROGRAM))
    }

    pub(crate) fn render(self) -> Result<RenderEngine, BindingError> {
        match self {
            Self::Golden => Ok(RenderEngine::Golden),
            Self::Verilog => Ok(RenderEngine::Hardware),
            Self::VerilogInLockstep => Ok(RenderEngine::Lockstep),
            Self::Interpreter => Err(BindingError::input(NO_PROGRAM)),
        }
    }
}
