//! Splitter: a splat's octagon, cut at tile boundaries into one copy a tile, row by row (thesis 5.5.1).
//!
//! A tile a cycle while the output has room, or every second cycle for one lane: its copy is made if any of the octagon lies in the tile. An
//! end record makes one end copy.

use crate::stream::{HalfBuffer, Skid};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_SIZE;
use pointcore_contract::splat::records::{ImageDiagonals, SetupSplat, SplatCopy, TileDiagonals, TileRectangle};
pub use pointcore_contract::splat::units::splitter::{In, Out};

const SIZE: u16 = TILE_SIZE as u16;
/// The last row of a tile, and its last column of pixels at most.
const LAST: i32 = TILE_SIZE as i32 - 1;

/// How the image is cut.
#[derive(Clone, Copy, Debug)]
struct Grid {
    tile_column_bits: u32,
    /// Bits of a bin of the exposure, the lowest of a tile's column.
    bin_bits: u32,
    row_bits: u32,
    /// Samples in a row of a pixel.
    columns: u16,
}

/// First and last of a tile's sums and differences, from one beyond either end.
#[derive(Clone, Copy, Debug)]
struct Diagonals {
    sum: [i32; 2],
    difference: [i32; 2],
}

/// The splat that is being cut and the tile that comes next.
#[derive(Clone, Copy, Debug)]
struct Work {
    splat: SetupSplat,
    tile_column: u16,
    tile_row: u16,
    /// No copy has been made of it.
    first: bool,
}

impl Work {
    fn new(splat: SetupSplat) -> Self {
        let (tile_column, tile_row) = (splat.bounds.left / SIZE, splat.bounds.top / SIZE);
        Self { splat, tile_column, tile_row, first: true }
    }

    fn is_last(&self) -> bool {
        let bounds = &self.splat.bounds;
        self.splat.end || (self.tile_column == bounds.right / SIZE && self.tile_row == bounds.bottom / SIZE)
    }

    fn next(self) -> Self {
        let bounds = &self.splat.bounds;
        let (tile_column, tile_row) = if self.tile_column == bounds.right / SIZE {
            (bounds.left / SIZE, self.tile_row + 1)
        } else {
            (self.tile_column + 1, self.tile_row)
        };
        Self { tile_column, tile_row, ..self }
    }

    /// The splat's diagonals, counted from the current tile's first pixel.
    fn diagonals(&self, grid: Grid) -> Diagonals {
        let ImageDiagonals { first_sum, last_sum, first_difference, last_difference } = self.splat.diagonals;
        let column = i32::from(self.tile_column * (SIZE / grid.columns));
        let [above, below] = [self.tile_row * SIZE, (1 << grid.row_bits) - (self.tile_row + 1) * SIZE].map(i32::from);
        let from = |origin: i32, first: u16, last: u16| {
            [(i32::from(first) - origin).clamp(0, 2 * LAST + 1), (i32::from(last) - origin).clamp(-1, 2 * LAST)]
        };
        Diagonals {
            sum: from(column + above, first_sum, last_sum),
            difference: from(column + below, first_difference, last_difference),
        }
    }

    /// The copy for the current tile; `None` if none of the octagon lies in it.
    fn copy(&self, grid: Grid) -> Option<SplatCopy> {
        let SetupSplat { end, footprint, moving, bin, attributes, bounds, .. } = self.splat;
        if end {
            return Some(SplatCopy { end, ..SplatCopy::default() });
        }
        let (left, right) = intersection(bounds.left, bounds.right, self.tile_column);
        let (top, bottom) = intersection(bounds.top, bounds.bottom, self.tile_row);
        let tile_column = u32::from(self.tile_column) << grid.bin_bits | u32::from(bin);
        let tile = u32::from(self.tile_row) << grid.tile_column_bits | tile_column;
        let Diagonals { sum: [first_sum, last_sum], difference: [first_difference, last_difference] } =
            self.diagonals(grid);
        let [first, last] = [left, right].map(|column| i32::from(column / grid.columns));
        // In a row without a pixel one of what limits it from the left lies behind one of what limits it from the right.
        let tops = [first_sum - last, LAST - last_difference + first, (first_sum + LAST - last_difference + 1) >> 1];
        let bottoms = [last_sum - first, LAST - first_difference + last, (last_sum + LAST - first_difference) >> 1];
        let top = tops.into_iter().fold(top.into(), i32::max);
        let bottom = bottoms.into_iter().fold(bottom.into(), i32::min);
        if top > bottom {
            return None;
        }
        let [first_sum, last_sum, first_difference, last_difference, top, bottom] =
            [first_sum, last_sum, first_difference, last_difference, top, bottom].map(|place| place as u16);
        let bounds = TileRectangle { left, right, top, bottom };
        let diagonals = TileDiagonals { first_sum, last_sum, first_difference, last_difference };
        Some(SplatCopy { end, first: self.first, footprint, moving, attributes, bounds, diagonals, tile })
    }
}

/// What `first..=last` has in common with a tile, counted from the tile's first pixel.
fn intersection(first: u16, last: u16, tile: u16) -> (u16, u16) {
    let origin = tile * SIZE;
    (first.max(origin) - origin, last.min(origin + (SIZE - 1)) - origin)
}

/// What tiles' copies leave through: one lane takes a copy every second cycle at most, several take one a cycle. A tile without one takes
/// its place for a cycle, and leaves by itself.
#[derive(Clone, Debug)]
enum Exit {
    ToOne(Box<HalfBuffer<Option<SplatCopy>>>),
    ToSeveral(Skid<Option<SplatCopy>>),
}

impl Exit {
    fn new(config: &Config) -> Self {
        match config.rasterizers {
            1 => Self::ToOne(Box::default()),
            _ => Self::ToSeveral(Skid::default()),
        }
    }

    fn has_room(&self) -> bool {
        match self {
            Self::ToOne(buffer) => buffer.in_ready(),
            Self::ToSeveral(buffer) => buffer.in_ready(),
        }
    }

    fn tile(&self) -> Option<&Option<SplatCopy>> {
        match self {
            Self::ToOne(buffer) => buffer.out(),
            Self::ToSeveral(buffer) => buffer.out(),
        }
    }

    fn shown(&self) -> Option<&SplatCopy> {
        self.tile()?.as_ref()
    }

    fn step(&mut self, tile: Option<Option<SplatCopy>>, is_taken: bool) {
        let leaves = is_taken || self.tile() == Some(&None);
        match self {
            Self::ToOne(buffer) => buffer.step(tile, leaves),
            Self::ToSeveral(buffer) => buffer.step(tile, leaves),
        }
    }
}

/// The splitter.
#[derive(Clone, Debug)]
pub struct Splitter {
    grid: Grid,
    work: Option<Work>,
    out: Exit,
}

impl Splitter {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let columns = config.sampling.columns() as u16;
        let (tile_column_bits, bin_bits) = (config.tile_column_bits(), config.bin_bits());
        let grid = Grid { tile_column_bits, bin_bits, row_bits: config.row_bits(), columns };
        Self { grid, work: None, out: Exit::new(config) }
    }

    /// The copies of a splat.
    pub fn copies(&self, splat: &SetupSplat) -> impl Iterator<Item = SplatCopy> {
        let grid = self.grid;
        let works = std::iter::successors(Some(Work::new(*splat)), |work| (!work.is_last()).then(|| work.next()));
        let copies = works.filter_map(move |work| work.copy(grid));
        copies.enumerate().map(|(index, copy)| SplatCopy { first: index == 0, ..copy })
    }

    fn in_ready(&self) -> bool {
        self.out.has_room() && self.work.as_ref().is_none_or(Work::is_last)
    }
}

impl Model for Splitter {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.in_ready(), out: self.out.shown().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let mut tile = None;
        if self.out.has_room() {
            tile = self.work.map(|work| work.copy(self.grid));
            let made_none = tile.is_none_or(|copy| copy.is_none());
            let next = self.work.map(|work| Work { first: work.first && made_none, ..work.next() });
            self.work = if self.in_ready() { inputs.input.map(Work::new) } else { next };
        }
        self.out.step(tile, inputs.out_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::rasterizer::columns;
    use pointcore_contract::Sampling;
    use pointcore_contract::splat::records::ImageRectangle;

    const OPEN: ImageDiagonals =
        ImageDiagonals { first_sum: 0, last_sum: 0x1ff, first_difference: 0, last_difference: 0x1ff };

    #[test]
    fn copies_cover_exactly_the_octagon() {
        let random = &mut fastrand::Rng::with_seed(1);
        for sampling in [Sampling::Center, Sampling::Flipquad] {
            let config = Config { width: 64, height: 40, sampling, ..Config::default() };
            let samples = sampling.columns() as u16;
            let splitter = Splitter::new(&config);
            let mut empty = 0;
            for _ in 0..2000 {
                let mut range = |edge: u16| {
                    let first = random.u16(..edge);
                    [first, random.u16(first..edge)]
                };
                let ([left, right], [top, bottom]) = (range(64 / samples), range(40));
                // Limits from any two pixels around the rectangle.
                let sums = [(); 2].map(|()| range(70)[0] + range(40)[0]);
                let differences = [(); 2].map(|()| range(70)[0] + range(64)[0]);
                let [first_sum, last_sum] = [sums[0].min(sums[1]), sums[0].max(sums[1])];
                let [first_difference, last_difference] =
                    [differences[0].min(differences[1]), differences[0].max(differences[1])];
                let bounds = ImageRectangle { left: left * samples, right: right * samples + samples - 1, top, bottom };
                let diagonals = ImageDiagonals { first_sum, last_sum, first_difference, last_difference };
                let splat = SetupSplat { bounds, diagonals, ..SetupSplat::default() };
                let mut covered = vec![0; 64 * 40];
                for copy in splitter.copies(&splat) {
                    let (origin_x, origin_y) = ((copy.tile & 7) as u16 * 8, (copy.tile >> 3) as u16 * 8);
                    assert!(copy.bounds.top <= copy.bounds.bottom);
                    for y in copy.bounds.top..=copy.bounds.bottom {
                        let columns = columns(samples.into(), &copy.bounds, &copy.diagonals, y);
                        assert!(!columns.is_empty(), "row {y} of {copy:?}");
                        columns.for_each(|x| covered[usize::from(origin_y + y) * 64 + usize::from(origin_x + x)] += 1);
                    }
                }
                empty += u32::from(covered.iter().all(|count| *count == 0));
                for (index, count) in covered.into_iter().enumerate() {
                    let (x, y) = ((index % 64) as u16 / samples, (index / 64) as u16);
                    let [sum, difference] = [x + y, x + 63 - y];
                    let inside = (left..=right).contains(&x)
                        && (top..=bottom).contains(&y)
                        && (first_sum..=last_sum).contains(&sum)
                        && (first_difference..=last_difference).contains(&difference);
                    assert_eq!(count, u32::from(inside), "({x}, {y}) of {bounds:?}, {diagonals:?}");
                }
            }
            assert!((100..1500).contains(&empty), "{empty} octagons without a pixel");
        }
    }

    #[test]
    fn copies_cover_exactly_the_rectangle() {
        let config = Config { width: 64, height: 40, ..Config::default() };
        for (left, right, top, bottom) in [(0, 0, 0, 0), (7, 8, 7, 8), (3, 60, 5, 38), (8, 15, 16, 23), (0, 63, 0, 39)]
        {
            let bounds = ImageRectangle { left, right, top, bottom };
            let splat = SetupSplat { bounds, diagonals: OPEN, ..SetupSplat::default() };
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
        for (rasterizers, interval) in [(1, 2), (2, 1)] {
            let mut splitter = Splitter::new(&Config { rasterizers, ..Config::default() });
            let bounds = ImageRectangle { left: 4, right: 11, top: 0, bottom: 0 };
            let splat = SetupSplat { bounds, diagonals: OPEN, ..SetupSplat::default() };
            let (mut accepted, mut copies) = (0, 0);
            for cycle in 0..42 {
                let out = splitter.outputs();
                assert!(
                    out.out.is_none_or(|copy| copy.first == (copies % 2 == 0)),
                    "the first copy of a splat in cycle {cycle}"
                );
                accepted += u32::from(out.in_ready);
                copies += u32::from(out.out.is_some());
                assert_eq!(out.out.is_some(), cycle >= 2 && cycle % interval == 0, "a copy in cycle {cycle}");
                splitter.clock(&In { input: Some(splat), out_ready: true });
            }
            assert_eq!((accepted, copies), (40 / interval / 2 + 1, 40 / interval), "two copies a splat");
        }
    }
}
