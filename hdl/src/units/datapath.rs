//! What the fixed-function datapaths share.

use super::documents;
use crate::compiler::{CompileError, Datapath, Options, Program, Value, compile};
use pointcore_contract::Unit;

/// Compiles the program of a unit, whose ports are then documented as the contract has them.
pub(crate) fn unit<C>(
    unit: &Unit<C>,
    config: &C,
    program: &Program,
    options: &Options,
) -> Result<Datapath, CompileError> {
    let mut datapath = compile(program, options)?;
    (unit.interface)(config).groups.iter().for_each(|group| documents::group(&mut datapath.module, group));
    Ok(datapath)
}

/// `⟨a, b⟩`, summed from left to right.
pub(crate) fn dot<const N: usize>(a: &[Value; N], b: &[Value; N]) -> Value {
    let products = a.iter().zip(b).map(|(a, b)| *a * *b);
    products.reduce(|sum, product| sum + product).expect("vectors have components")
}
