//! Distributor: copies go to one of two sides, by a bit of the number of the rasterizer whose tile it is.
//!
//! A copy is taken every second cycle at most; an end record leaves on both sides.

use super::parts::share::Share;
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::SplatCopy;
pub use pointcore_contract::splat::units::distributor::{In, Out};

/// The distributor.
#[derive(Clone, Debug)]
pub struct Distributor {
    share: Share,
    /// The bit of the number that it looks at.
    bit: u32,
    copy: SplatCopy,
    /// Whether it is still to leave for the lower numbers, and for the higher ones.
    leaves_for: [bool; 2],
    /// Sides for which a copy of its splat has left or is to leave.
    begun: [bool; 2],
}

impl Distributor {
    /// The unit after reset, so many distributors behind the splitter; the first looks at the highest bit.
    #[must_use]
    pub fn new(config: &Config, level: u32) -> Self {
        let bit = config.rasterizer_bits().saturating_sub(1 + level);
        Self { share: Share::new(config), bit, copy: SplatCopy::default(), leaves_for: [false; 2], begun: [false; 2] }
    }
}

impl Model for Distributor {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let [low, high] = self.leaves_for.map(|leaves| leaves.then_some(self.copy));
        Out { in_ready: self.leaves_for == [false; 2], low, high }
    }

    fn clock(&mut self, inputs: &In) {
        if self.leaves_for != [false; 2] {
            self.leaves_for[0] &= !inputs.low_ready;
            self.leaves_for[1] &= !inputs.high_ready;
        } else if let Some(copy) = inputs.input {
            let is_high = self.share.rasterizer(copy.tile) >> self.bit & 1 == 1;
            self.leaves_for = [copy.end || !is_high, copy.end || is_high];
            self.copy = copy;
            if !copy.end {
                self.begun = self.begun.map(|begun| begun && !copy.first);
                let begun = &mut self.begun[usize::from(is_high)];
                self.copy.first = !std::mem::replace(begun, true);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn copies_go_to_their_side_and_ends_to_both() {
        let config = Config { rasterizers: 4, ..Config::default() };
        let mut unit = Distributor::new(&config, 0);
        let copy = |tile| SplatCopy { tile, first: true, ..SplatCopy::default() };
        let end = SplatCopy { end: true, ..SplatCopy::default() };
        // The highest bit of a number is that of the column, and the lowest of the row.
        let columns = 1 << config.tile_column_bits();
        let left = [(copy(0), [1, 0]), (copy(1), [1, 0]), (copy(2), [0, 1]), (copy(columns), [0, 1]), (end, [1, 1])];
        for (copy, expected) in left {
            let mut counts = [0; 2];
            unit.clock(&In { input: Some(copy), ..In::default() });
            for ready in [[false; 2], [true, false], [false, true]] {
                let out = unit.outputs();
                assert!(!out.in_ready || counts == expected);
                let [low_ready, high_ready] = ready;
                for ((shown, ready), count) in [out.low, out.high].into_iter().zip(ready).zip(&mut counts) {
                    let is_sent = |shown: SplatCopy| (shown.end, shown.tile) == (copy.end, copy.tile);
                    *count += u32::from(ready && shown.is_some_and(is_sent));
                }
                let input = None;
                unit.clock(&In { input, low_ready, high_ready });
            }
            assert_eq!(counts, expected, "{copy:?}");
            assert!(unit.outputs().in_ready);
        }
    }

    #[test]
    fn each_side_has_a_first_copy_of_its_own() {
        let config = Config { rasterizers: 2, ..Config::default() };
        let mut unit = Distributor::new(&config, 0);
        // Of one splat and of another.
        let sent = [(1, true), (0, false), (1, false), (2, false), (0, true), (3, false)];
        let left = sent.map(|(tile, first)| {
            unit.clock(&In { input: Some(SplatCopy { tile, first, ..SplatCopy::default() }), ..In::default() });
            let Out { low, high, .. } = unit.outputs();
            unit.clock(&In { low_ready: true, high_ready: true, ..In::default() });
            low.or(high).map(|copy| copy.first)
        });
        assert_eq!(left.map(|first| first.expect("a copy leaves")), [true, true, false, false, true, true]);
    }
}
