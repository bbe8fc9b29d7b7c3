//! Collector: two sides share one memory, and one stream of finished pixels.
//!
//! Requests, writes and finished pixels come from one side at a time: its turn lasts while something moves. Data go to the side that
//! asked for them, in the order of the requests.

use crate::stream::{Fifo, Skid};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::COLLECTED_READS;
use pointcore_contract::splat::records::{FinishedPixel, Pixel, PixelRun, StoredPixel};
pub use pointcore_contract::splat::units::collector::{In, Out};

/// What two sides take turns at.
#[derive(Clone, Debug)]
struct Shared<T> {
    /// The side whose turn it is.
    turn: usize,
    out: Skid<T>,
}

impl<T> Default for Shared<T> {
    fn default() -> Self {
        Self { turn: 0, out: Skid::default() }
    }
}

impl<T> Shared<T> {
    /// Which side something is taken from, if `open`.
    fn ready(&self, open: bool) -> [bool; 2] {
        [0, 1].map(|side| side == self.turn && open && self.out.in_ready())
    }

    /// What moves from the sides, of what they offer; the turn passes on where nothing does.
    fn take(&mut self, open: bool, offers: [Option<T>; 2]) -> Option<(usize, T)> {
        let ready = self.ready(open);
        let [low, high] = offers;
        let offer = if self.turn == 0 { low } else { high };
        let taken = offer.filter(|_| ready[self.turn]).map(|item| (self.turn, item));
        if taken.is_none() {
            self.turn = 1 - self.turn;
        }
        taken
    }
}

/// The collector.
#[derive(Clone, Debug)]
pub struct Collector {
    read: Shared<PixelRun>,
    write: Shared<StoredPixel>,
    pixel: Shared<FinishedPixel>,
    /// The sides that data are for, in order, and how many each.
    order: Fifo<(usize, u8)>,
    data: Skid<Pixel>,
    /// Pixels of the first of them that came.
    came: u8,
    /// Sides whose frame has ended, until that of both has left.
    ended: [bool; 2],
    /// The end of both was pushed.
    closing: bool,
}

impl Default for Collector {
    fn default() -> Self {
        Self {
            read: Shared::default(),
            write: Shared::default(),
            pixel: Shared::default(),
            order: Fifo::new(COLLECTED_READS as usize),
            data: Skid::default(),
            came: 0,
            ended: [false; 2],
            closing: false,
        }
    }
}

impl Collector {
    /// A read must find in memory what was written before it.
    fn may_read(&self) -> bool {
        self.order.in_ready() && self.write.out.out().is_none()
    }

    /// The frame of the side whose turn it is goes on.
    const fn has_pixels(&self) -> bool {
        !self.ended[self.pixel.turn]
    }
}

impl Model for Collector {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let [low_read_ready, high_read_ready] = self.read.ready(self.may_read());
        let [low_write_ready, high_write_ready] = self.write.ready(true);
        let [low_pixel_ready, high_pixel_ready] = self.pixel.ready(self.has_pixels());
        let data_for =
            |side| self.data.out().copied().filter(|_| self.order.out().is_some_and(|(first, _)| *first == side));
        Out {
            low_read_ready,
            low_data: data_for(0),
            low_write_ready,
            low_pixel_ready,
            high_read_ready,
            high_data: data_for(1),
            high_write_ready,
            high_pixel_ready,
            read: self.read.out.out().copied(),
            data_ready: self.data.in_ready(),
            write: self.write.out.out().copied(),
            pixel: self.pixel.out.out().copied(),
        }
    }

    fn clock(&mut self, inputs: &In) {
        let Out { low_data, high_data, .. } = self.outputs();
        let goes_on = low_data.is_some() && inputs.low_data_ready || high_data.is_some() && inputs.high_data_ready;
        self.came += u8::from(goes_on);
        let is_last = self.order.out().is_some_and(|(_, count)| *count == self.came);
        if is_last {
            self.came = 0;
        }
        self.data.step(inputs.data, goes_on);

        let read = self.read.take(self.may_read(), [inputs.low_read, inputs.high_read]);
        self.order.step(read.map(|(side, run)| (side, run.count)), is_last);
        self.read.out.step(read.map(|(_, run)| run), inputs.read_ready);
        let written = self.write.take(true, [inputs.low_write, inputs.high_write]);
        self.write.out.step(written.map(|(_, pixel)| pixel), inputs.write_ready);

        let has_closed = self.closing && self.pixel.out.out().is_none();
        let closes = self.ended == [true; 2] && !self.closing && self.pixel.out.in_ready();
        let finished = self.pixel.take(self.has_pixels(), [inputs.low_pixel, inputs.high_pixel]);
        for (side, _) in finished.iter().filter(|(_, pixel)| pixel.end) {
            self.ended[*side] = true;
        }
        let mut pixel = finished.map(|(_, pixel)| pixel).filter(|pixel| !pixel.end);
        self.closing = closes || (self.closing && !has_closed);
        if has_closed {
            self.ended = [false; 2];
        }
        if closes {
            pixel = Some(FinishedPixel { end: true, ..FinishedPixel::default() });
        }
        self.pixel.out.step(pixel, inputs.pixel_ready);
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
            let [low_pixel, high_pixel] = [0, 1].map(|side: usize| sides[side].first().copied());
            let out = unit.outputs();
            left.extend(out.pixel.map(|pixel| (pixel.end, pixel.placed.tile)));
            unit.clock(&In { low_pixel, high_pixel, pixel_ready: true, ..In::default() });
            for (ready, side) in [out.low_pixel_ready, out.high_pixel_ready].into_iter().zip(&mut sides) {
                if ready && !side.is_empty() {
                    side.remove(0);
                }
            }
        }
        left[..2].sort_unstable();
        assert_eq!(left, [(false, 1), (false, 5), (true, 0), (false, 2), (true, 0)]);
    }

    #[test]
    fn a_read_waits_for_writes_and_gets_its_own_data() {
        let mut unit = Collector::default();
        let write = StoredPixel::default();
        let mut came = [0; 2];
        let mut asked = [false; 2];
        let mut seen = vec![];
        for cycle in 0..400 {
            let out = unit.outputs();
            let offers = |side: usize| {
                (cycle > 2 && !asked[side]).then_some(PixelRun {
                    tile: side as u32,
                    count: 3 + side as u8,
                    ..PixelRun::default()
                })
            };
            let inputs = In {
                low_write: (cycle < 2).then_some(write),
                write_ready: cycle > 20,
                low_read: offers(0),
                high_read: offers(1),
                read_ready: true,
                data: (seen.len() == 2 && came != [3, 4]).then_some(Pixel { weight: cycle, ..Pixel::default() }),
                low_data_ready: true,
                high_data_ready: cycle % 3 == 0,
                ..In::default()
            };
            if let Some(read) = out.read {
                assert!(cycle > 20, "the write has left by then");
                seen.push(read.tile as usize);
            }
            asked[0] |= inputs.low_read.is_some() && out.low_read_ready;
            asked[1] |= inputs.high_read.is_some() && out.high_read_ready;
            came[0] += usize::from(out.low_data.is_some());
            came[1] += usize::from(out.high_data.is_some() && inputs.high_data_ready);
            if let [first, _] = seen[..] {
                assert!(came[1 - first] == 0 || came[first] == 3 + first);
            }
            unit.clock(&inputs);
        }
        assert_eq!(came, [3, 4]);
    }
}
