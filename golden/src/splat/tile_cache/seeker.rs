//! Finds the pixels of a mask, row by row.

use pointcore_contract::splat::config::TILE_SIZE;

const ROW_PIXELS: u32 = TILE_SIZE;
const ROW: u64 = (1 << ROW_PIXELS) - 1;

/// Pixels of a row that follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// The first one's index in the tile.
    pub pixel: u8,
    /// How many they are.
    pub count: u8,
}

/// A mask of which pixels are found: the rows that were not begun, and what is left of the one that was.
#[derive(Clone, Copy, Debug, Default)]
pub struct Seeker {
    rest: u64,
    row: u8,
    /// Pixels left in the row.
    left: u8,
}

impl Seeker {
    /// Whether no pixel is left.
    pub const fn is_empty(&self) -> bool {
        self.rest == 0 && self.left == 0
    }

    /// The row in which pixels are found in this cycle, if one was begun.
    pub fn row(&self) -> Option<u8> {
        (self.left != 0).then_some(self.row)
    }

    /// The first pixels that are left and follow each other.
    pub fn run(&self) -> Option<Run> {
        let first = self.left.trailing_zeros();
        self.row().map(|row| {
            let count = (self.left >> first).trailing_ones();
            Run { pixel: row * ROW_PIXELS as u8 + first as u8, count: count as u8 }
        })
    }

    /// The first pixel that is left.
    pub fn pixel(&self) -> Option<u8> {
        self.run().map(|run| run.pixel)
    }

    /// Takes a mask; it must be empty.
    pub const fn begin(&mut self, mask: u64) {
        self.rest = mask;
    }

    /// One clock edge, at which the first so many pixels that are left were taken. The next row follows the last pixel of one.
    pub fn clock(&mut self, taken: u8) {
        let first = self.left.trailing_zeros();
        self.left &= !(((1_u32 << taken) - 1) << first.min(ROW_PIXELS)) as u8;
        if self.left == 0 && self.rest != 0 {
            let row = self.rest.trailing_zeros() / ROW_PIXELS;
            (self.row, self.left) = (row as u8, (self.rest >> (row * ROW_PIXELS) & ROW) as u8);
            self.rest &= !(ROW << (row * ROW_PIXELS));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(mask: u64, take: impl Fn(&Run) -> u8) -> (Vec<Run>, usize) {
        let mut seeker = Seeker::default();
        seeker.begin(mask);
        let (mut runs, mut cycles) = (vec![], 0_usize);
        while !seeker.is_empty() {
            let run = seeker.run();
            runs.extend(run);
            seeker.clock(run.as_ref().map_or(0, &take));
            cycles += 1;
        }
        (runs, cycles)
    }

    #[test]
    fn every_pixel_is_found_once_and_in_order() {
        fastrand::seed(1);
        for mask in (0..1000).map(|_| fastrand::u64(..) & fastrand::u64(..)).chain([0, 1, u64::MAX, 1 << 63]) {
            let (runs, cycles) = found(mask, |run| run.count);
            let pixels = runs.iter().flat_map(|run| run.pixel..run.pixel + run.count);
            assert_eq!(pixels.fold(0, |all: u64, pixel| all | 1 << pixel), mask);
            assert!(runs.is_sorted_by_key(|run| run.pixel) && runs.iter().all(|run| run.pixel % 8 + run.count <= 8));
            assert_eq!(cycles, runs.len() + usize::from(mask != 0), "one a cycle behind the first row");
            let pixels = found(mask, |_| 1).0.iter().fold(0, |all: u64, run| all | 1 << run.pixel);
            assert_eq!(pixels, mask);
        }
    }
}
