//! Splitter: a splat's rectangle, cut at tile boundaries into one copy a tile, row by row (thesis 5.5.1).
//!
//! A copy every second cycle while the output has room. An end record makes one end copy.

use crate::stream::HalfBuffer;
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_SIZE;
use pointcore_contract::splat::records::{SetupSplat, SplatCopy, TileRectangle};
pub use pointcore_contract::splat::units::splitter::{In, Out};

const SIZE: u16 = TILE_SIZE as u16;

/// The splat that is being cut and the tile that comes next.
#[derive(Clone, Copy, Debug)]
struct Work {
    splat: SetupSplat,
    tile_column: u16,
    tile_row: u16,
}

impl Work {
    fn new(splat: SetupSplat) -> Self {
        Self { splat, tile_column: splat.bounds.left / SIZE, tile_row: splat.bounds.top / SIZE }
    }

    fn is_last(&self) -> bool {
        let bounds = &self.splat.bounds;
        self.splat.end || (self.tile_column == bounds.right / SIZE && self.tile_row == bounds.bottom / SIZE)
    }

    fn next(self) -> Self {
        let bounds = &self.splat.bounds;
        if self.tile_column == bounds.right / SIZE {
            Self { tile_column: bounds.left / SIZE, tile_row: self.tile_row + 1, ..self }
        } else {
            Self { tile_column: self.tile_column + 1, ..self }
        }
    }

    fn copy(&self, tile_column_bits: u32) -> SplatCopy {
        let SetupSplat { end, footprint, attributes, bounds } = self.splat;
        if end {
            return SplatCopy { end, ..SplatCopy::default() };
        }
        let (left, right) = intersection(bounds.left, bounds.right, self.tile_column);
        let (top, bottom) = intersection(bounds.top, bounds.bottom, self.tile_row);
        let tile = u32::from(self.tile_row) << tile_column_bits | u32::from(self.tile_column);
        SplatCopy { end, footprint, attributes, bounds: TileRectangle { left, right, top, bottom }, tile }
    }
}

/// What `first..=last` has in common with a tile, counted from the tile's first pixel.
fn intersection(first: u16, last: u16, tile: u16) -> (u16, u16) {
    let origin = tile * SIZE;
    (first.max(origin) - origin, last.min(origin + (SIZE - 1)) - origin)
}

/// The splitter.
#[derive(Clone, Debug)]
pub struct Splitter {
    tile_column_bits: u32,
    work: Option<Work>,
    out: HalfBuffer<SplatCopy>,
}

impl Splitter {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self { tile_column_bits: config.tile_column_bits(), work: None, out: HalfBuffer::default() }
    }

    fn in_ready(&self) -> bool {
        self.out.in_ready() && self.work.as_ref().is_none_or(Work::is_last)
    }
}

impl Model for Splitter {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.in_ready(), out: self.out.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let mut copy = None;
        if self.out.in_ready() {
            copy = self.work.map(|work| work.copy(self.tile_column_bits));
            self.work = if self.in_ready() { inputs.input.map(Work::new) } else { self.work.map(Work::next) };
        }
        self.out.step(copy, inputs.out_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::records::ImageRectangle;

    #[test]
    fn copies_cover_exactly_the_rectangle() {
        let config = Config { width: 64, height: 40, ..Config::default() };
        for (left, right, top, bottom) in [(0, 0, 0, 0), (7, 8, 7, 8), (3, 60, 5, 38), (8, 15, 16, 23), (0, 63, 0, 39)]
        {
            let splat = SetupSplat { bounds: ImageRectangle { left, right, top, bottom }, ..SetupSplat::default() };
            let mut splitter = Splitter::new(&config);
            let mut covered = vec![0; 64 * 40];
            let mut input = Some(splat);
            let mut tiles = Vec::new();
            for _ in 0..100 {
                let out = splitter.outputs();
                if let Some(SplatCopy { bounds, tile, .. }) = out.out {
                    tiles.push(tile);
                    let (origin_x, origin_y) = ((tile & 7) as u16 * 8, (tile >> 3) as u16 * 8);
                    for y in bounds.top..=bounds.bottom {
                        for x in bounds.left..=bounds.right {
                            covered[usize::from(origin_y + y) * 64 + usize::from(origin_x + x)] += 1;
                        }
                    }
                }
                splitter.clock(&In { input, out_ready: true });
                input = input.filter(|_| !out.in_ready);
            }
            assert!(tiles.is_sorted_by(|a, b| a < b), "scan-line order: {tiles:?}");
            for (index, count) in covered.into_iter().enumerate() {
                let (x, y) = ((index % 64) as u16, (index / 64) as u16);
                let inside = (left..=right).contains(&x) && (top..=bottom).contains(&y);
                assert_eq!(count, u32::from(inside), "({x}, {y}) of {left}..={right} × {top}..={bottom}");
            }
        }
    }

    #[test]
    fn splats_follow_each_other_without_a_gap() {
        let mut splitter = Splitter::new(&Config::default());
        let bounds = ImageRectangle { left: 4, right: 11, top: 0, bottom: 0 };
        let (mut accepted, mut copies) = (0, 0);
        for cycle in 0..42 {
            let out = splitter.outputs();
            accepted += u32::from(out.in_ready);
            copies += u32::from(out.out.is_some());
            assert!(
                cycle < 2 || out.out.is_some() == (cycle % 2 == 0),
                "a copy every second cycle, also in cycle {cycle}"
            );
            splitter.clock(&In { input: Some(SetupSplat { bounds, ..SetupSplat::default() }), out_ready: true });
        }
        assert_eq!((accepted, copies), (11, 20), "two copies a splat");
    }
}
