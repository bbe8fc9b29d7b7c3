//! What can be wrong with a program.

/// A program that cannot become hardware.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CompileError {
    /// Operands do not suit an operation.
    #[error("{unit}: `{operation}` of {operands}: {expected}")]
    Operands {
        /// Name of the program.
        unit: String,
        /// Mnemonic of the operation.
        operation: &'static str,
        /// Names and types of the operands.
        operands: String,
        /// What the operation wants.
        expected: &'static str,
    },
    /// A value's type has no bits or too many.
    #[error("{unit}: `{value}` would be {width} bits wide; values have 1 to 64 bits")]
    Width {
        /// Name of the program.
        unit: String,
        /// Name of the value.
        value: String,
        /// Its width.
        width: u32,
    },
    /// A constant does not fit its type.
    #[error("{unit}: constant {value:#x} does not fit type {ty}")]
    Constant {
        /// Name of the program.
        unit: String,
        /// The constant.
        value: u64,
        /// The type it was given.
        ty: String,
    },
    /// A port's name is taken or no identifier.
    #[error("{unit}: `{name}` cannot name a port: {reason}")]
    PortName {
        /// Name of the program.
        unit: String,
        /// The name.
        name: String,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// A value belongs to another program.
    #[error("{unit}: `{operation}` takes a value of another program, `{other}`")]
    ForeignValue {
        /// Name of the program.
        unit: String,
        /// Mnemonic of the operation.
        operation: &'static str,
        /// Name of the program that owns the value.
        other: String,
    },
    /// A table has the wrong number of samples or samples that are too wide.
    #[error("interpolation table: {samples} samples of {value_bits} bits expected; {problem}")]
    Table {
        /// Samples that the shape asks for.
        samples: usize,
        /// Bits of a sample.
        value_bits: u32,
        /// What was found.
        problem: String,
    },
    /// Nothing leaves the datapath.
    #[error("{unit}: the program has no output; call `output`")]
    NoOutput {
        /// Name of the program.
        unit: String,
    },
    /// The initiation interval is out of range.
    #[error("{unit}: initiation interval {initiation_interval} is out of range; it must be 1 to {maximum}")]
    InitiationInterval {
        /// Name of the program.
        unit: String,
        /// What was asked for.
        initiation_interval: u32,
        /// The largest value.
        maximum: u32,
    },
}
