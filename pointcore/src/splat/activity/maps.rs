//! Where in the image a frame takes its cycles: counts by sample, and by tile.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::{TILE_PIXELS, TILE_SIZE};
use pointcore_contract::splat::records::{CompleteCopy, SamplePlace};
use pointcore_golden::splat::rasterizer::columns;
use std::collections::VecDeque;

/// Pixels of a tile.
const PIXELS: usize = TILE_PIXELS as usize;
/// Pixels along a tile's edge.
const SIZE: usize = TILE_SIZE as usize;

/// A count for each of an image's places, row by row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Map {
    /// Places in a row.
    pub width: usize,
    /// The counts.
    pub counts: Vec<u32>,
}

impl Map {
    /// All counts together.
    #[must_use]
    pub fn sum(&self) -> u64 {
        self.counts.iter().copied().map(u64::from).sum()
    }
}

/// How tiles lie in the image.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    columns: usize,
    rows: usize,
    column_bits: u32,
    /// Of the bin of the exposure, whose tiles lie side by side: counts are those of all.
    bin_bits: u32,
}

impl Layout {
    pub(super) fn new(config: &Config) -> Self {
        let [columns, rows] = [config.width, config.height].map(|edge| edge as usize);
        Self { columns, rows, column_bits: config.tile_column_bits(), bin_bits: config.bin_bits() }
    }

    /// Tiles that there may be: as many as their addresses reach.
    const fn tiles(&self) -> usize {
        self.rows.div_ceil(SIZE) << self.column_bits
    }

    /// Counts by tile, as an image of tiles.
    pub(super) fn by_tile(&self, counts: &[u32]) -> Map {
        let (width, height) = (self.columns.div_ceil(SIZE), self.rows.div_ceil(SIZE));
        let row = |row: usize| counts[row << self.column_bits..][..width << self.bin_bits].chunks(1 << self.bin_bits);
        Map { width, counts: (0..height).flat_map(row).map(|bins| bins.iter().sum()).collect() }
    }

    /// Counts by tile and the tile's pixel, as an image.
    fn by_pixel(&self, counts: &[u32]) -> Map {
        let count = |row: usize, column: usize| -> u32 {
            let tile = ((row / SIZE) << self.column_bits) + ((column / SIZE) << self.bin_bits);
            let bins = tile..tile + (1 << self.bin_bits);
            bins.map(|tile| counts[tile * PIXELS + row % SIZE * SIZE + column % SIZE]).sum()
        };
        let row = |row: usize| (0..self.columns).map(move |column| count(row, column));
        Map { width: self.columns, counts: (0..self.rows).flat_map(row).collect() }
    }

    pub(super) fn zeros_by_tile(&self) -> Vec<u32> {
        vec![0; self.tiles()]
    }
}

/// What is under way between a rasterizer and its accumulator.
#[derive(Clone, Debug)]
struct Lane {
    /// The tile in each slot of the tile cache, for the copies passed on last.
    tiles: Vec<u32>,
    /// Samples inside their splat that the accumulator has not taken yet, by tile and pixel.
    waiting: VecDeque<u32>,
}

/// What passes between rasterizers and accumulators, counted where it lies in the image.
#[derive(Clone, Debug)]
pub struct SampleMaps {
    layout: Layout,
    columns_a_pixel: u32,
    lanes: Vec<Lane>,
    evaluated: Vec<u32>,
    inside: Vec<u32>,
    hazards: Vec<u32>,
    /// Copies that the rasterizer took.
    pub copies: u64,
}

impl SampleMaps {
    pub(super) fn new(config: &Config) -> Self {
        let layout = Layout::new(config);
        let zeros = vec![0; layout.tiles() * PIXELS];
        let lane = Lane { tiles: vec![0; config.tile_slots as usize], waiting: VecDeque::new() };
        let lanes = vec![lane; config.rasterizers as usize];
        let (evaluated, inside) = (zeros.clone(), zeros.clone());
        let columns_a_pixel = config.sampling.columns();
        Self { layout, columns_a_pixel, lanes, evaluated, inside, hazards: zeros, copies: 0 }
    }

    /// A rasterizer takes a copy: it will evaluate each sample of its octagon.
    pub(super) fn copy(&mut self, lane: usize, copy: &CompleteCopy) {
        self.copies += 1;
        self.lanes[lane].tiles[usize::from(copy.slot)] = copy.tile;
        let tile = &mut self.evaluated[copy.tile as usize * PIXELS..][..PIXELS];
        for row in copy.bounds.top..=copy.bounds.bottom {
            let columns = columns(self.columns_a_pixel, &copy.bounds, &copy.diagonals, row).map(usize::from);
            columns.for_each(|column| tile[usize::from(row) * SIZE + column] += 1);
        }
    }

    /// An accumulator's queue takes a sample. A slot's tile is replaced only when none of its samples is on its way.
    pub(super) fn sample(&mut self, lane: usize, place: &SamplePlace) {
        if place.inside {
            let lane = &mut self.lanes[lane];
            let index = lane.tiles[usize::from(place.slot)] * TILE_PIXELS + u32::from(place.pixel);
            self.inside[index as usize] += 1;
            lane.waiting.push_back(index);
        }
    }

    /// An accumulator took the sample that waited longest.
    pub(super) fn accumulated(&mut self, lane: usize) {
        self.lanes[lane].waiting.pop_front();
    }

    /// The sample that waits longest waits for an earlier one of its pixel.
    pub(super) fn hazard(&mut self, lane: usize) {
        if let Some(index) = self.lanes[lane].waiting.front() {
            self.hazards[*index as usize] += 1;
        }
    }

    /// Samples that the rasterizer evaluated.
    #[must_use]
    pub fn evaluated(&self) -> Map {
        self.layout.by_pixel(&self.evaluated)
    }

    /// Samples inside their splat, which reach the pixel.
    #[must_use]
    pub fn inside(&self) -> Map {
        self.layout.by_pixel(&self.inside)
    }

    /// Cycles in which the accumulator waited for an earlier sample of the pixel.
    #[must_use]
    pub fn hazards(&self) -> Map {
        self.layout.by_pixel(&self.hazards)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::records::{TileDiagonals, TileRectangle};

    #[test]
    fn counts_lie_where_their_pixels_do() {
        let config = Config { width: 20, height: 16, ..Config::default() };
        let mut maps = SampleMaps::new(&config);
        let tile = 1 << config.tile_column_bits() | 2;
        let bounds = TileRectangle { left: 0, right: 1, top: 3, bottom: 4 };
        // In the upper row the first column alone, and both in the lower one.
        let diagonals = TileDiagonals { first_sum: 0, last_sum: 14, first_difference: 0, last_difference: 4 };
        maps.copy(0, &CompleteCopy { tile, bounds, diagonals, slot: 1, ..CompleteCopy::default() });
        let place = SamplePlace { inside: true, slot: 1, pixel: 3 * 8 + 1, ..SamplePlace::default() };
        maps.sample(0, &place);
        maps.sample(0, &SamplePlace { inside: false, ..place });
        maps.hazard(0);
        maps.accumulated(0);
        maps.hazard(0);
        let places = |map: Map| {
            let set = map.counts.iter().enumerate().filter(|(_, count)| **count > 0);
            let set: Vec<_> = set.map(|(index, count)| (index % map.width, index / map.width, *count)).collect();
            set
        };
        assert_eq!(places(maps.evaluated()), [(16, 11, 1), (16, 12, 1), (17, 12, 1)]);
        assert_eq!(places(maps.inside()), [(17, 11, 1)]);
        assert_eq!(places(maps.hazards()), [(17, 11, 1)], "nothing waits any more");
        assert_eq!(maps.evaluated().counts.len(), 20 * 16);
        let mut by_tile = maps.layout.zeros_by_tile();
        by_tile[tile as usize] = 7;
        assert_eq!(maps.layout.by_tile(&by_tile), Map { width: 3, counts: vec![0, 0, 0, 0, 0, 7] });
    }
}
