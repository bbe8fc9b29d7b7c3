//! What elaboration can find wrong with a design.

use std::fmt;
use std::panic::Location;

use thiserror::Error;

/// Everything that is wrong with a design, collected in one pass.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub struct ElaborationError {
    /// The faults, in the order of the hierarchy, children first.
    pub faults: Vec<Fault>,
}

impl fmt::Display for ElaborationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the design has {} fault(s)", self.faults.len())?;
        self.faults.iter().try_for_each(|fault| write!(f, "\n  {fault}"))
    }
}

/// A line of the program that describes the hardware.
pub(super) type Place = &'static Location<'static>;

/// One fault, the line that made it and the module it is in.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{}:{}: {path}: {kind}", place.file(), place.line())]
pub struct Fault {
    /// Where the description has what is wrong: the expression, or the declaration of what is not driven.
    pub place: &'static Location<'static>,
    /// Instance names from the top's unit name down, joined by `/`.
    pub path: String,
    /// What is wrong.
    pub kind: FaultKind,
}

/// The kinds of fault.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum FaultKind {
    /// An expression cannot be: widths that differ, bits that are not there.
    #[error("{user}: {message}")]
    Expression {
        /// The signal or port the expression was for.
        user: String,
        /// What is wrong with the expression.
        message: String,
    },
    /// A signal and its driver differ in width.
    #[error("width mismatch: `{signal}` has {width} bits, its driver `{driver}` has {driver_width}")]
    Width {
        /// The signal.
        signal: String,
        /// Its width.
        width: u32,
        /// The driver.
        driver: String,
        /// The driver's width.
        driver_width: u32,
    },
    /// Nothing drives a wire, a register or a memory.
    #[error("`{0}` is never driven")]
    Undriven(String),
    /// A signal has more than one driver.
    #[error("`{0}` is driven twice")]
    DoublyDriven(String),
    /// An input of an instance was left open.
    #[error("input `{port}` of instance `{instance}` is not connected")]
    Unconnected {
        /// The instance.
        instance: String,
        /// Its input.
        port: String,
    },
    /// An instance has no port of that name and direction.
    #[error("instance `{instance}` of `{unit}` has no {direction} `{port}`")]
    UnknownPort {
        /// The instance.
        instance: String,
        /// Its unit.
        unit: String,
        /// `input` or `output`.
        direction: &'static str,
        /// The name that was asked for.
        port: String,
    },
    /// Something is said of a port that the module has not declared.
    #[error("`{unit}` has no port `{port}` to say anything of")]
    UndeclaredPort {
        /// The module's unit.
        unit: String,
        /// The name that was asked for.
        port: String,
    },
    /// Two things in a module have one name.
    #[error("the name `{0}` is used twice")]
    NameClash(String),
    /// A name that Verilog or its tools do not take.
    #[error("`{name}` cannot be a name: {reason}")]
    BadName {
        /// The name.
        name: String,
        /// Why not.
        reason: &'static str,
    },
    /// An expression of one module was used in another.
    #[error("{user}: `{signal}` belongs to another module")]
    ForeignSignal {
        /// The signal or port the expression was for.
        user: String,
        /// The signal from elsewhere.
        signal: String,
    },
    /// Something of another module was passed to this one.
    #[error("`{0}` was declared in another module")]
    ForeignHandle(String),
    /// A rust-hdl block that cannot be a module.
    #[error("rust-hdl block: {0}")]
    Block(String),
    /// A signal depends on itself without a register between.
    #[error("combinational loop: {0}")]
    Loop(String),
}
