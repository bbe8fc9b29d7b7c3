//! Which rasterizer a tile belongs to.

use pointcore_contract::splat::Config;
use rtl::{Expr, cat};

/// A tile's place among those of its rasterizer: its code without the lowest bits of its column.
pub fn place(config: &Config, tile: Expr) -> Expr {
    tile.bits(config.tile_bits() - 1, config.rasterizer_bits())
}

/// A bit of the number of the rasterizer that a tile belongs to: one of its column, and from the other end one of its row.
pub fn number_bit(config: &Config, tile: Expr, bit: u32) -> Expr {
    let row = config.tile_column_bits() + (config.rasterizer_bits() - 1 - bit);
    let column = tile.bit(bit);
    if row < config.tile_bits() { column ^ tile.bit(row) } else { column }
}

/// The tile in a place of the rasterizer of a number; there is no number where there is but one.
pub fn tile(config: &Config, number: Option<Expr>, place: Expr) -> Expr {
    let Some(number) = number else { return place };
    let column = config.tile_column_bits() - config.rasterizer_bits();
    let bit = |bit: u32| {
        let row = column + (config.rasterizer_bits() - 1 - bit);
        if row < place.width() { number.bit(bit) ^ place.bit(row) } else { number.bit(bit) }
    };
    cat([place, cat((0..config.rasterizer_bits()).rev().map(bit))])
}
