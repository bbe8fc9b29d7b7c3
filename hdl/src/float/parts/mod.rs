//! What the operators share: operands, the pipeline, the rounder, and tables that no operator of the golden model stands beside.

pub(crate) mod delay;
pub(crate) mod newton;
pub(crate) mod operand;
pub(crate) mod pipe;
pub(crate) mod product;
pub(crate) mod round;
pub(crate) mod shift;
pub mod table;
