//! When a bin of the exposure sees something: from the first to the last time, but for the parts of the bin in which it never does.

use pointcore_contract::splat::motion::BIN_PARTS;
use pointcore_contract::splat::records::SPAN;

use rtl::{Expr, Module, cat};

/// When something is seen.
#[derive(Clone, Copy)]
pub(super) struct Cover {
    /// What is left of the bin at the first time, and what has passed of it at the last.
    pub span: [Expr; 2],
    /// A bit for each part of the bin in which it is seen.
    pub parts: Expr,
}

impl Cover {
    /// All of a sample's span. It touches a part unless it is over before that begins, or begins when that is over.
    pub fn of_sample(m: &mut Module, span: [Expr; 2]) -> Self {
        let [early, late] = span;
        let part_bits = early.width() - 1 - BIN_PARTS.ilog2();
        let exceeds = |time: Expr, parts: u32| time.ge_lit((u128::from(parts) << part_bits) + 1);
        let touched = |part: u32| exceeds(late, part) & exceeds(early, BIN_PARTS - 1 - part);
        Self { span, parts: m.wire("sample_parts", cat((0..BIN_PARTS).rev().map(touched))) }
    }

    /// When either is seen.
    pub fn with(self, other: Self) -> Self {
        let later = |end: usize| self.span[end].lt(other.span[end]).mux(other.span[end], self.span[end]);
        Self { span: [later(0), later(1)], parts: self.parts | other.parts }
    }

    /// Whether another one is seen for all of the time.
    pub fn is_within(self, other: Self) -> Expr {
        !(self.parts & !other.parts).any() & self.is_within_sample(other)
    }

    /// The same of one that is a sample's: it has all parts that its span touches.
    pub fn is_within_sample(self, sample: Self) -> Expr {
        let [early, late] = [0, 1].map(|end: usize| self.span[end].le(sample.span[end]));
        early & late
    }

    /// What is made of each of its numbers, which are given by name.
    pub fn map(self, mut made: impl FnMut(&str, Expr) -> Expr) -> Self {
        Self { span: [0, 1].map(|end: usize| made(SPAN[end], self.span[end])), parts: made("parts", self.parts) }
    }
}
