//! Distributor: copies go to one of two sides, by a bit of the number of the rasterizer whose tile it is.
//!
//! A copy a cycle, through a queue for each side; an end record leaves on both.

use super::parts::share::Share;
use crate::stream::Fifo;
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::DISTRIBUTED_COPIES;
use pointcore_contract::splat::records::SplatCopy;
pub use pointcore_contract::splat::units::distributor::{In, Out};

/// The distributor.
#[derive(Clone, Debug)]
pub struct Distributor {
    share: Share,
    /// The bit of the number that it looks at.
    bit: u32,
    /// What is to leave for the lower numbers, and for the higher ones.
    queues: [Fifo<SplatCopy>; 2],
    /// Sides for which a copy of the last splat was taken.
    begun: [bool; 2],
}

impl Distributor {
    /// The unit after reset, so many distributors behind the splitter; the first looks at the highest bit.
    #[must_use]
    pub fn new(config: &Config, level: u32) -> Self {
        let bit = config.rasterizer_bits().saturating_sub(1 + level);
        let queues = [(); 2].map(|()| Fifo::new(DISTRIBUTED_COPIES as usize));
        Self { share: Share::new(config), bit, queues, begun: [false; 2] }
    }
}

impl Model for Distributor {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let [low, high] = self.queues.each_ref().map(|queue| queue.out().copied());
        Out { in_ready: self.queues.iter().all(Fifo::in_ready), low, high }
    }

    fn clock(&mut self, inputs: &In) {
        let mut pushed = [None; 2];
        if let Some(mut copy) = inputs.input.filter(|_| self.outputs().in_ready) {
            let is_high = self.share.rasterizer(copy.tile) >> self.bit & 1 == 1;
            if copy.end {
                pushed = [Some(copy); 2];
            } else {
                self.begun = self.begun.map(|begun| begun && !copy.first);
                let begun = &mut self.begun[usize::from(is_high)];
                copy.first = !std::mem::replace(begun, true);
                pushed[usize::from(is_high)] = Some(copy);
            }
        }
        let [low, high] = pushed;
        self.queues[0].step(low, inputs.low_ready);
        self.queues[1].step(high, inputs.high_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sends copies, one a cycle, and returns what leaves on each side.
    fn sent(unit: &mut Distributor, copies: &[SplatCopy]) -> [Vec<SplatCopy>; 2] {
        let mut sides = [const { Vec::new() }; 2];
        for cycle in 0..copies.len() + 2 {
            let Out { in_ready, low, high } = unit.outputs();
            assert!(in_ready, "a copy a cycle, also in cycle {cycle}");
            sides.iter_mut().zip([low, high]).for_each(|(side, copy)| side.extend(copy));
            unit.clock(&In { input: copies.get(cycle).copied(), low_ready: true, high_ready: true });
        }
        sides
    }

    #[test]
    fn copies_go_to_their_side_and_ends_to_both() {
        let config = Config { rasterizers: 4, ..Config::default() };
        let copy = |tile| SplatCopy { tile, first: true, ..SplatCopy::default() };
        let end = SplatCopy { end: true, ..SplatCopy::default() };
        // The highest bit of a number is that of the column, and the lowest of the row.
        let below = 1 << config.tile_column_bits();
        let sides = sent(&mut Distributor::new(&config, 0), &[copy(0), copy(1), copy(2), copy(below), end]);
        let tiles = sides.map(|side| side.into_iter().map(|copy| (copy.end, copy.tile)).collect::<Vec<_>>());
        assert_eq!(tiles, [[(false, 0), (false, 1), (true, 0)], [(false, 2), (false, below), (true, 0)]]);
    }

    #[test]
    fn each_side_has_a_first_copy_of_its_own() {
        let config = Config { rasterizers: 2, ..Config::default() };
        // Of one splat and of another.
        let copies = [(1, true), (0, false), (1, false), (2, false), (0, true), (3, false)];
        let copies = copies.map(|(tile, first)| SplatCopy { tile, first, ..SplatCopy::default() });
        let firsts = sent(&mut Distributor::new(&config, 0), &copies)
            .map(|side| side.into_iter().map(|copy| (copy.tile, copy.first)).collect::<Vec<_>>());
        assert_eq!(firsts, [[(0, true), (2, false), (0, true)], [(1, true), (1, false), (3, true)]]);
    }

    #[test]
    fn a_full_side_holds_up_both() {
        let config = Config { rasterizers: 2, ..Config::default() };
        let mut unit = Distributor::new(&config, 0);
        let copy = SplatCopy { tile: 0, ..SplatCopy::default() };
        let taken = (0..100).filter(|_| {
            let Out { in_ready, high, .. } = unit.outputs();
            assert!(high.is_none());
            unit.clock(&In { input: Some(copy), low_ready: false, high_ready: true });
            in_ready
        });
        assert_eq!(taken.count(), DISTRIBUTED_COPIES as usize);
    }
}
