//! Which rasterizer a tile belongs to.

use pointcore_contract::splat::Config;
use rtl::{Expr, bit, cat, lit};

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

/// The place behind another in the image, row by row, and whether none is. Bits above the place count images.
pub fn following(config: &Config, place: Expr) -> (Expr, Expr) {
    let (bits, column_bits) = (config.place_bits(), config.place_column_bits());
    let [last_column, last_row] = config.last_place().map(u128::from);
    if last_row << column_bits | last_column == (1 << bits) - 1 {
        return (place.add_lit(1), place.all());
    }
    let top = place.width() - 1;
    let is_at_end = if column_bits == 0 { bit(true) } else { place.trunc(column_bits).eq_lit(last_column) };
    let is_at_bottom = place.bits(bits - 1, column_bits).eq_lit(last_row);
    let (below, is_in_last) = if bits > top {
        (place.bits(top, column_bits).add_lit(1), bit(true))
    } else {
        let image = place.bits(top, bits);
        let begun = cat([image.add_lit(1), lit(bits - column_bits, 0)]);
        (is_at_bottom.mux(begun, place.bits(top, column_bits).add_lit(1)), image.all())
    };
    let next_row = if column_bits == 0 { below } else { cat([below, lit(column_bits, 0)]) };
    (is_at_end.mux(next_row, place.add_lit(1)), (is_at_end & is_at_bottom) & is_in_last)
}
