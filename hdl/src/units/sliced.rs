//! Large memories, cut into slices of a few bits that a block RAM holds all words of: none is chosen among behind their slow
//! outputs, and each bit that is written goes to one of them.

use rtl::{Expr, Memory, Module};

/// Bits that a block RAM holds: words of nine bits and more have the parity's, too.
const fn block_bits(words: u32) -> u32 {
    if words <= 1 << 11 { 9 << 11 } else { 1 << 14 }
}

/// A memory in slices, the lowest bits first.
pub(crate) struct Sliced(Memory);

impl Sliced {
    /// A memory of a word for each address, written where `enable` is set; one that is read in that cycle reads as anything.
    pub fn new(m: &mut Module, name: &str, enable: Expr, address: Expr, word: Expr) -> Self {
        let (address_bits, width) = (address.width(), word.width());
        let slice = (block_bits(1 << address_bits) >> address_bits).clamp(1, width);
        let memory = m.memory_sliced(name, 1 << address_bits, width, slice);
        m.write(memory, enable, address, word);
        Self(memory)
    }

    /// A read port that keeps its word while `enable` is low.
    pub fn read_if(&self, m: &mut Module, name: &str, enable: Expr, address: Expr) -> Expr {
        m.read_if(self.0, name, enable, address)
    }
}
