//! What the fixed-function datapaths share.

use crate::compiler::Value;

/// `⟨a, b⟩`, summed from left to right.
pub(crate) fn dot<const N: usize>(a: &[Value; N], b: &[Value; N]) -> Value {
    let products = a.iter().zip(b).map(|(a, b)| *a * *b);
    products.reduce(|sum, product| sum + product).expect("vectors have components")
}
