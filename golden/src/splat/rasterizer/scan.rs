//! Walks the samples of a copy's octagon, row by row.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_SIZE;
use pointcore_contract::splat::records::{CompleteCopy, TileDiagonals, TileRectangle};
use pointcore_contract::splat::units::RasterizerEvents;
use std::ops::RangeInclusive;

const SIZE: u16 = TILE_SIZE as u16;

/// Columns of samples in a row of a copy, between the edges of its octagon; a pixel has so many. None where a limit lies before the row's
/// first pixel.
#[must_use]
pub fn columns(per_pixel: u32, bounds: &TileRectangle, diagonals: &TileDiagonals, row: u16) -> RangeInclusive<u16> {
    let samples = per_pixel as u16;
    let below = SIZE - 1 - row;
    let first = diagonals.first_sum.saturating_sub(row).max(diagonals.first_difference.saturating_sub(below));
    let lasts = diagonals.last_sum.checked_sub(row).zip(diagonals.last_difference.checked_sub(below));
    let Some(last) = lasts.map(|(sum, difference)| sum.min(difference)) else { return RangeInclusive::new(1, 0) };
    bounds.left.max(first * samples)..=bounds.right.min(last * samples + (samples - 1))
}

/// The copy under rasterization and its next pixel, in tile coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scan {
    pub copy: CompleteCopy,
    per_pixel: u32,
    pub column: u16,
    pub row: u16,
}

impl Scan {
    pub fn new(config: &Config, copy: CompleteCopy) -> Self {
        let (per_pixel, row) = (config.sampling.columns(), copy.bounds.top);
        Self { copy, per_pixel, column: *columns(per_pixel, &copy.bounds, &copy.diagonals, row).start(), row }
    }

    /// The copy's bin of the exposure.
    pub const fn bin(&self, config: &Config) -> u32 {
        self.copy.tile & ((1 << config.bin_bits()) - 1)
    }

    /// Column and row of the current sample in the image.
    pub fn place(&self, config: &Config) -> [u32; 2] {
        let tile_column_bits = config.tile_column_bits();
        let column = (self.copy.tile & ((1 << tile_column_bits) - 1)) >> config.bin_bits();
        let tile = [column, self.copy.tile >> tile_column_bits];
        let place = |tile: u32, local: u16| tile * TILE_SIZE + u32::from(local);
        [place(tile[0], self.column), place(tile[1], self.row)]
    }

    /// The current sample's pixel of the tile.
    pub const fn pixel(&self) -> u8 {
        (self.row * SIZE + self.column) as u8
    }

    fn columns(&self, row: u16) -> RangeInclusive<u16> {
        columns(self.per_pixel, &self.copy.bounds, &self.copy.diagonals, row)
    }

    fn is_row_done(&self) -> bool {
        self.column == *self.columns(self.row).end()
    }

    pub fn is_last(&self) -> bool {
        let copy = &self.copy;
        self.row == copy.bounds.bottom && self.is_row_done()
    }

    pub fn step(&mut self) {
        if self.is_row_done() {
            self.row += 1;
            self.column = *self.columns(self.row).start();
        } else {
            self.column += 1;
        }
    }
}

/// The copy that is scanned, or none.
#[derive(Clone, Debug)]
pub(super) struct Scanner {
    config: Config,
    current: Option<Scan>,
}

impl Scanner {
    pub fn new(config: &Config) -> Self {
        Self { config: config.clone(), current: None }
    }

    pub const fn current(&self) -> Option<&Scan> {
        self.current.as_ref()
    }

    /// Whether another copy can come: there is none, or its last sample is the current one.
    pub fn is_idle(&self) -> bool {
        self.current.as_ref().is_none_or(Scan::is_last)
    }

    /// A cycle, in which what evaluates samples advances or not, and a copy may come; returns what happened.
    pub fn clock(&mut self, advances: bool, taken: Option<CompleteCopy>) -> RasterizerEvents {
        let busy = self.current.is_some();
        if advances {
            match &mut self.current {
                Some(scan) if !scan.is_last() => scan.step(),
                current => *current = taken.map(|copy| Scan::new(&self.config, copy)),
            }
        }
        RasterizerEvents { sample: advances && busy, starved: advances && !busy, blocked: busy && !advances }
    }
}
