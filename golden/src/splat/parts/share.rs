//! Which rasterizer a tile belongs to.

use pointcore_contract::splat::Config;

/// How tiles are dealt out: neighbors in a row to different rasterizers, and so that no two neighboring rows are dealt alike.
#[derive(Clone, Copy, Debug)]
pub struct Share {
    /// Bits of a rasterizer's number.
    bits: u32,
    tile_column_bits: u32,
    /// Bits of the column in a place.
    place_column_bits: u32,
    /// Column and row of the last place in the image.
    last: [u32; 2],
}

impl Share {
    /// Between the rasterizers of a configuration.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self {
            bits: config.rasterizer_bits(),
            tile_column_bits: config.tile_column_bits(),
            place_column_bits: config.place_column_bits(),
            last: config.last_place(),
        }
    }

    /// What a row adds to the number of its tiles: its lowest bits in reverse order.
    fn turn(self, row: u32) -> u32 {
        (0..self.bits).fold(0, |turn, bit| turn << 1 | row >> bit & 1)
    }

    /// The number of the rasterizer that a tile belongs to.
    #[must_use]
    pub fn rasterizer(self, tile: u32) -> u32 {
        (tile ^ self.turn(tile >> self.tile_column_bits)) & ((1 << self.bits) - 1)
    }

    /// A tile's place among those of its rasterizer.
    #[must_use]
    pub const fn place(self, tile: u32) -> u32 {
        tile >> self.bits
    }

    /// The place behind another in the image, row by row.
    #[must_use]
    pub const fn following(self, place: u32) -> Option<u32> {
        let [last_column, last_row] = self.last;
        let (row, column) = (place >> self.place_column_bits, place & ((1 << self.place_column_bits) - 1));
        if column < last_column {
            Some(place + 1)
        } else if row < last_row {
            Some((row + 1) << self.place_column_bits)
        } else {
            None
        }
    }

    /// The tile in a place of a rasterizer.
    #[must_use]
    pub fn tile(self, rasterizer: u32, place: u32) -> u32 {
        let tile = place << self.bits;
        tile | self.turn(tile >> self.tile_column_bits) ^ rasterizer
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_tile_has_a_place_of_its_own() {
        for (rasterizers, width, height) in [(1, 64, 64), (2, 8, 40), (2, 64, 8), (4, 32, 100), (8, 512, 64)] {
            let config = Config { rasterizers, width, height, ..Config::default() };
            let share = Share::new(&config);
            let mut counts = vec![0; rasterizers as usize];
            for tile in 0..1 << config.tile_bits() {
                let (rasterizer, place) = (share.rasterizer(tile), share.place(tile));
                assert!(place < 1 << config.place_bits());
                assert_eq!(share.tile(rasterizer, place), tile);
                counts[rasterizer as usize] += 1;
            }
            assert!(counts.iter().all(|count| *count == 1 << config.place_bits()), "{counts:?}");
        }
    }

    #[test]
    fn every_tile_of_the_image_is_in_one_of_the_places_that_follow_each_other() {
        for (rasterizers, width, height) in
            [(1, 64, 64), (1, 65, 8), (2, 8, 40), (2, 72, 24), (4, 100, 100), (8, 520, 72)]
        {
            let config = Config { rasterizers, width, height, ..Config::default() };
            let share = Share::new(&config);
            let places: Vec<u32> = std::iter::successors(Some(0), |place| share.following(*place)).collect();
            assert!(places.is_sorted_by(|a, b| a < b));
            let [columns, rows] = [width, height].map(|edge| edge.div_ceil(8));
            let row_bits = config.tile_column_bits();
            let tiles = (0..rows).flat_map(|row| (0..columns).map(move |column| row << row_bits | column));
            assert!(tiles.map(|tile| share.place(tile)).all(|place| places.contains(&place)));
            let most = columns.div_ceil(rasterizers) * rows;
            assert_eq!(places.len(), most as usize, "{width}×{height}");
        }
    }

    #[test]
    fn squares_of_four_tiles_belong_to_four_rasterizers() {
        let config = Config { rasterizers: 4, ..Config::default() };
        let (share, columns) = (Share::new(&config), 1 << config.tile_column_bits());
        for corner in [0, 2, 2 * columns, 6 * columns + 10] {
            let mut numbers = [0, 1, columns, columns + 1].map(|tile| share.rasterizer(corner + tile));
            numbers.sort_unstable();
            assert_eq!(numbers, [0, 1, 2, 3]);
        }
    }
}
