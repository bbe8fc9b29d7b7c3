//! Large memories, cut into slices of a few bits that a block RAM holds all words of: none is chosen among behind their slow
//! outputs, and each bit that is written goes to one of them.

use rtl::{Expr, Memory, Module, cat};

/// Bits that a block RAM holds: words of nine bits and more have the parity's, too.
const fn block_bits(words: u32) -> u32 {
    if words <= 1 << 11 { 9 << 11 } else { 1 << 14 }
}

/// A memory in slices, the lowest bits first.
pub(crate) struct Sliced {
    slices: Vec<Slice>,
}

struct Slice {
    memory: Memory,
    low: u32,
}

impl Sliced {
    /// A memory of a word for each address, written where `enable` is set; one that is read in that cycle reads as anything.
    pub fn new(m: &mut Module, name: &str, enable: Expr, address: Expr, word: Expr) -> Self {
        let (address_bits, width) = (address.width(), word.width());
        let bits = (block_bits(1 << address_bits) >> address_bits).clamp(1, width);
        let slice = |low: u32| {
            let high = width.min(low + bits) - 1;
            let memory = m.memory_unordered(&format!("{name}_{low}"), 1 << address_bits, high + 1 - low);
            m.write(memory, enable, address, word.bits(high, low));
            Slice { memory, low }
        };
        Self { slices: (0..width).step_by(bits as usize).map(slice).collect() }
    }

    /// A read port that keeps its word while `enable` is low.
    pub fn read_if(&self, m: &mut Module, name: &str, enable: Expr, address: Expr) -> Expr {
        let read = |slice: &Slice| m.read_if(slice.memory, &format!("{name}_{}", slice.low), enable, address);
        let word: Vec<_> = self.slices.iter().map(read).collect();
        cat(word.iter().rev().copied())
    }
}
