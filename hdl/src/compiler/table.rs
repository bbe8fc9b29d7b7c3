//! The samples of a function.

use super::error::CompileError;
use pointcore_contract::TableShape;

/// A table of unsigned samples; see [`Operation::Interpolate`](super::Operation::Interpolate).
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Table {
    shape: TableShape,
    values: Vec<u64>,
}

impl Table {
    /// A table from its samples.
    ///
    /// # Errors
    /// When there are too few or too many samples, or one is too wide.
    pub fn new(shape: TableShape, values: Vec<u64>) -> Result<Self, CompileError> {
        let samples = shape.samples();
        let error = |problem| CompileError::Table { samples, value_bits: shape.value_bits, problem };
        if values.len() != samples {
            return Err(error(format!("there are {}", values.len())));
        }
        match values.iter().find(|&&value| value >> shape.value_bits != 0) {
            Some(value) => Err(error(format!("{value} does not fit"))),
            None => Ok(Self { shape, values }),
        }
    }

    /// Field widths.
    #[must_use]
    pub const fn shape(&self) -> TableShape {
        self.shape
    }

    /// The samples.
    #[must_use]
    pub fn values(&self) -> &[u64] {
        &self.values
    }
}
