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

/// The value of a number that the lowest bits of `place` say, of a power of two of them.
pub(crate) fn pick(place: Value, values: Vec<Value>) -> Value {
    let levels = values.len().ilog2();
    let halved = |values: Vec<Value>, level| {
        let odd = place.bits(level, level);
        values.chunks(2).map(|pair| odd.mux(pair[1], pair[0])).collect()
    };
    (0..levels).fold(values, halved)[0]
}

/// `⟨a, b⟩`, summed from left to right.
pub(crate) fn dot<const N: usize>(a: &[Value; N], b: &[Value; N]) -> Value {
    let products = a.iter().zip(b).map(|(a, b)| *a * *b);
    products.reduce(|sum, product| sum + product).expect("vectors have components")
}
