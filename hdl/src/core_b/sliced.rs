//! Large memories, cut into slices of a few bits that a block RAM holds all words of: none is chosen among behind their slow
//! outputs.

use crate::rtl::{Expr, Memory, Module, cat};

/// Bits that a block RAM holds.
const BLOCK_BITS: usize = 1 << 14;

/// A memory in slices, the lowest bits first.
pub(super) struct Sliced(Vec<Slice>);

struct Slice {
    memory: Memory,
    high: usize,
    low: usize,
}

impl Sliced {
    /// A memory of `2^address_bits` words.
    pub fn new(m: &mut Module, name: &str, address_bits: usize, width: usize) -> Self {
        let bits = (BLOCK_BITS >> address_bits).clamp(1, width);
        let slice = |low: usize| {
            let high = width.min(low + bits) - 1;
            Slice { memory: m.memory(&format!("{name}_{low}"), 1 << address_bits, high + 1 - low), high, low }
        };
        Self((0..width).step_by(bits).map(slice).collect())
    }

    /// Its write port.
    pub fn write(&self, m: &mut Module, enable: &Expr, address: &Expr, word: &Expr) {
        for Slice { memory, high, low } in &self.0 {
            m.write(memory, enable, address, &word.bits(*high, *low));
        }
    }

    /// A read port that keeps its word while `enable` is low.
    pub fn read_if(&self, m: &mut Module, name: &str, enable: &Expr, address: &Expr) -> Expr {
        let read = |slice: &Slice| m.read_if(&slice.memory, &format!("{name}_{}", slice.low), enable, address);
        let word: Vec<_> = self.0.iter().map(read).collect();
        cat(&word.iter().rev().collect::<Vec<_>>())
    }
}
