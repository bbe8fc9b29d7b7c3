//! Arbiter: two sides share one port of the reconstruction buffer.
//!
//! Requests and writes come from one side at a time: its turn lasts while something moves. Data go to the side that asked for them, in
//! the order of the requests.

use super::parts::shared::Shared;
use crate::stream::{Fifo, Skid};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::COLLECTED_READS;
use pointcore_contract::splat::records::{Pixel, PixelRun, StoredPixel};
pub use pointcore_contract::splat::units::arbiter::{In, Out};

/// The arbiter.
#[derive(Clone, Debug)]
pub struct Arbiter {
    read: Shared<PixelRun>,
    write: Shared<StoredPixel>,
    /// The sides that data are for, in order, and how many each.
    order: Fifo<(usize, u8)>,
    data: Skid<Pixel>,
    /// Pixels of the first of them that came.
    came: u8,
}

impl Default for Arbiter {
    fn default() -> Self {
        Self {
            read: Shared::default(),
            write: Shared::default(),
            order: Fifo::new(COLLECTED_READS as usize),
            data: Skid::default(),
            came: 0,
        }
    }
}

impl Arbiter {
    /// A read must find in memory what was written before it.
    fn may_read(&self) -> bool {
        self.order.in_ready() && self.write.out.out().is_none()
    }
}

impl Model for Arbiter {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let [low_read_ready, high_read_ready] = self.read.ready(self.may_read());
        let [low_write_ready, high_write_ready] = self.write.ready(true);
        let data_for =
            |side| self.data.out().copied().filter(|_| self.order.out().is_some_and(|(first, _)| *first == side));
        Out {
            low_read_ready,
            low_data: data_for(0),
            low_write_ready,
            high_read_ready,
            high_data: data_for(1),
            high_write_ready,
            read: self.read.out.out().copied(),
            data_ready: self.data.in_ready(),
            write: self.write.out.out().copied(),
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
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_read_waits_for_writes_and_gets_its_own_data() {
        let mut unit = Arbiter::default();
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
