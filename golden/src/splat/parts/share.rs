//! Which rasterizer a tile belongs to.

use pointcore_contract::splat::Config;

/// How tiles are dealt out: neighbors in a row to different rasterizers, and so that no two neighboring rows are dealt alike.
#[derive(Clone, Copy, Debug)]
pub struct Share {
    /// Bits of a rasterizer's number.
    bits: u32,
    tile_column_bits: u32,
}

impl Share {
    /// Between the rasterizers of a configuration.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        Self { bits: config.rasterizer_bits(), tile_column_bits: config.tile_column_bits() }
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
