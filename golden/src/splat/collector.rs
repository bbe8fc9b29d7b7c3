//! Collectors: two sides share one stream of finished pixels, or of fragments.
//!
//! They come from one side at a time: its turn lasts while something moves, and while its frame goes on. Once both sides have ended the
//! frame, its end leaves.

use super::parts::shared::Shared;
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{FinishedPixel, Fragment};
use pointcore_contract::splat::units::{collector, fragment_collector};

/// A record that may close a frame.
pub trait Closing: Copy + Default {
    /// Whether it does.
    fn is_end(&self) -> bool;

    /// The one that does, and has nothing else.
    fn end() -> Self;
}

impl Closing for FinishedPixel {
    fn is_end(&self) -> bool {
        self.end
    }

    fn end() -> Self {
        Self { end: true, ..Self::default() }
    }
}

impl Closing for Fragment {
    fn is_end(&self) -> bool {
        self.end
    }

    fn end() -> Self {
        Self { end: true, ..Self::default() }
    }
}

/// A collector of such records.
#[derive(Clone, Debug)]
pub struct Collected<R> {
    shared: Shared<R>,
    /// Sides whose frame has ended, until that of both has left.
    ended: [bool; 2],
    /// The end of both was pushed.
    closing: bool,
}

/// Collects finished pixels.
pub type Collector = Collected<FinishedPixel>;
/// Collects fragments.
pub type FragmentCollector = Collected<Fragment>;

impl<R> Default for Collected<R> {
    fn default() -> Self {
        Self { shared: Shared::default(), ended: [false; 2], closing: false }
    }
}

impl<R: Closing> Collected<R> {
    /// The frame of the side whose turn it is goes on.
    const fn goes_on(&self) -> bool {
        !self.ended[self.shared.turn]
    }

    fn step(&mut self, offers: [Option<R>; 2], ready: bool) {
        let has_closed = self.closing && self.shared.out.out().is_none();
        let closes = self.ended == [true; 2] && !self.closing && self.shared.out.in_ready();
        let taken = self.shared.take(self.goes_on(), offers);
        for (side, _) in taken.iter().filter(|(_, record)| record.is_end()) {
            self.ended[*side] = true;
        }
        let mut record = taken.map(|(_, record)| record).filter(|record| !record.is_end());
        self.closing = closes || (self.closing && !has_closed);
        if has_closed {
            self.ended = [false; 2];
        }
        if closes {
            record = Some(R::end());
        }
        self.shared.out.step(record, ready);
    }
}

macro_rules! collectors {
    ($($record:ty: $unit:ident),*) => {
        $(impl Model for Collected<$record> {
            type Config = Config;
            type In = $unit::In;
            type Out = $unit::Out;

            fn outputs(&self) -> $unit::Out {
                let [low_ready, high_ready] = self.shared.ready(self.goes_on());
                $unit::Out { low_ready, high_ready, out: self.shared.out.out().copied() }
            }

            fn clock(&mut self, inputs: &$unit::In) {
                self.step([inputs.low, inputs.high], inputs.out_ready);
            }
        })*
    };
}

collectors!(FinishedPixel: collector, Fragment: fragment_collector);

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
            unit.clock(&collector::In { low, high, out_ready: true });
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
