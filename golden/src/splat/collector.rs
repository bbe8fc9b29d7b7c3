//! Collector: two sides share one stream of finished pixels.

use super::parts::collected::Collected;
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::FinishedPixel;
pub use pointcore_contract::splat::units::collector::{In, Out};

/// The collector.
pub type Collector = Collected<FinishedPixel>;

impl Model for Collected<FinishedPixel> {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let [low_ready, high_ready] = self.shared.ready(self.goes_on());
        Out { low_ready, high_ready, out: self.shared.out.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        self.step([inputs.low, inputs.high], inputs.out_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::records::PlacedPixel;

    #[test]
    fn a_frame_ends_when_both_sides_have() {
        let mut unit = Collector::default();
        let pixel = |end, tile| FinishedPixel { end, placed: PlacedPixel { tile, ..PlacedPixel::default() } };
        let mut sides = [
            vec![pixel(false, 1), pixel(true, 0), pixel(false, 2), pixel(true, 0)],
            vec![pixel(false, 5), pixel(true, 0)],
        ];
        let mut left = vec![];
        for cycle in 0..60 {
            // The second frame of the higher numbers is empty, and comes late.
            if cycle == 40 {
                sides[1].push(pixel(true, 0));
            }
            let [low, high] = [0, 1].map(|side: usize| sides[side].first().copied());
            let out = unit.outputs();
            left.extend(out.out.map(|pixel| (pixel.end, pixel.placed.tile)));
            unit.clock(&In { low, high, out_ready: true });
            for (ready, side) in [out.low_ready, out.high_ready].into_iter().zip(&mut sides) {
                if ready && !side.is_empty() {
                    side.remove(0);
                }
            }
        }
        left[..2].sort_unstable();
        assert_eq!(left, [(false, 1), (false, 5), (true, 0), (false, 2), (true, 0)]);
    }
}
