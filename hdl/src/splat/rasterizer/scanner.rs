//! Walks the samples of a copy's octagon, row by row.

use crate::compiler::Manifest;
use crate::splat::parts::extreme::extreme;
use crate::units::ports::{Flow, held};
use crate::units::wires::{Bundle, Wires};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{CompleteCopy, DIAGONAL_BITS, LOCAL_BITS, TileDiagonals, TileRectangle};
use pointcore_contract::splat::units::RasterizerEvents;
use rtl::{Expr, Module, Reg, bit, cat, lit};

/// The scanner's registers. A copy of hundreds of bits hangs on whether one can be taken, so that is known before the cycle begins; the
/// ends of a row are known before the row is reached.
pub(super) struct Scanner {
    /// Bits of a sample's column within its pixel.
    sample_bits: u32,
    pub busy: Reg,
    /// A copy can be taken: there is none, or its current pixel is the last.
    idle: Reg,
    /// None can: for those who stand far from where `idle` is wanted most, as who offers copies.
    walks: Reg,
    /// The current pixel is the copy's last.
    pub last: Reg,
    pub slot: Reg,
    tile: Reg,
    column: Reg,
    row: Reg,
    /// Last column of the current row.
    row_end: Reg,
    /// First and last column of the next one.
    next_ends: [Reg; 2],
    bottom: Reg,
}

/// Copies of which samples may be under way: each of them has one in the evaluation, or in the scanner.
pub(super) fn copies(evaluation: &Manifest) -> u32 {
    (evaluation.tokens() + 1).next_power_of_two()
}

/// What limits a row from one side: a place, less another.
type Limit = [Expr; 2];

/// Whether a limit is not before another: what is taken away from a place is added to the other.
fn reaches([place, less]: Limit, [other, other_less]: Limit) -> Expr {
    let wide = |place: Expr| place.zext(DIAGONAL_BITS + 1);
    (wide(place) + wide(other_less)).ge(wide(other) + wide(less))
}

/// What limits a row of pixels from the left and from the right: the sides of a rectangle, sums and differences.
fn limits(sample_bits: u32, sides: [Expr; 2], diagonals: &TileDiagonals<Wires>, row: Expr) -> [[Limit; 3]; 2] {
    let [left, right] = sides.map(|column| [column.bits(LOCAL_BITS - 1, sample_bits), lit(LOCAL_BITS, 0)]);
    let TileDiagonals { first_sum, last_sum, first_difference, last_difference } = *diagonals;
    [[left, [first_sum, row], [first_difference, !row]], [right, [last_sum, row], [last_difference, !row]]]
}

/// First and last column of a row that has pixels. No limit is chosen before all are compared.
fn ends([firsts, lasts]: [[Limit; 3]; 2]) -> [Expr; 2] {
    let column = |[place, less]: Limit| place.zext(DIAGONAL_BITS) - less.zext(DIAGONAL_BITS);
    [
        extreme(firsts.map(column), |place, other| reaches(firsts[place], firsts[other])),
        extreme(lasts.map(column), |place, other| reaches(lasts[other], lasts[place])),
    ]
}

/// Whether a row has pixels: no limit from the left is behind one from the right.
fn has_some([firsts, lasts]: [[Limit; 3]; 2]) -> Expr {
    let pairs = firsts.into_iter().flat_map(|first| lasts.map(|last| reaches(last, first)));
    pairs.fold(bit(true), |all, one| all & one)
}

/// Whether a row that has pixels has one: a limit from the left is not before one from the right.
fn has_one([firsts, lasts]: [[Limit; 3]; 2]) -> Expr {
    let pairs = firsts.into_iter().flat_map(|first| lasts.map(|last| reaches(first, last)));
    pairs.fold(bit(false), |any, one| any | one)
}

/// First and last column of samples in these pixels.
fn samples(sample_bits: u32, pixels: [Expr; 2]) -> [Expr; 2] {
    let [first, last] = pixels.map(|pixel| pixel.trunc(LOCAL_BITS - sample_bits));
    if sample_bits == 0 {
        return [first, last];
    }
    [cat([first, lit(sample_bits, 0)]), cat([last, lit(sample_bits, (1 << sample_bits) - 1)])]
}

impl Scanner {
    pub fn new(m: &mut Module, config: &Config) -> Self {
        Self {
            sample_bits: config.sampling.columns().ilog2(),
            busy: m.reg_reset("busy", 1, 0),
            idle: m.reg_reset("idle", 1, 1),
            walks: m.reg_reset("walks", 1, 0),
            last: m.reg("is_last", 1),
            slot: m.reg("slot", config.slot_bits()),
            tile: m.reg("tile", config.tile_bits()),
            column: m.reg("column", LOCAL_BITS),
            row: m.reg("row", LOCAL_BITS),
            row_end: m.reg("row_end", LOCAL_BITS),
            next_ends: ["next_begin", "next_end"].map(|name| m.reg(name, LOCAL_BITS)),
            bottom: m.reg("bottom", LOCAL_BITS),
        }
    }

    /// Takes copies in cycles in which what evaluates samples advances; returns when it would take one, and when it does.
    pub fn take(&self, m: &mut Module, config: &Config, copy: &Flow<CompleteCopy<Wires>>, advance: Expr) -> [Expr; 2] {
        let ready = m.wire("take", advance & self.idle);
        let is_ready = m.wire("is_ready", advance & !self.walks);
        m.drive(copy.ready, is_ready);
        let load = m.wire("load", is_ready & copy.valid);
        self.step(m, config, copy, advance, ready);
        [ready, load]
    }

    /// What happens in a cycle.
    pub fn events(&self, advance: Expr) -> RasterizerEvents<Wires> {
        let busy = self.busy.expr();
        RasterizerEvents { sample: advance & busy, starved: advance & !busy, blocked: busy & !advance }
    }

    /// On `advance`: takes `copy`, if there is one, on `ready`; else steps to the next pixel or falls idle. While it would take one and none
    /// is there, registers may take what they will: what they take does not wait for who offers it.
    fn step(&self, m: &mut Module, config: &Config, copy: &Flow<CompleteCopy<Wires>>, advance: Expr, ready: Expr) {
        let (arrives, idle) = (copy.valid, self.idle.expr());
        let row_done = m.wire("row_done", self.column.eq(self.row_end));
        m.next_if(self.busy, advance, idle.mux(arrives, *self.busy));
        let copy = copy.record;
        m.next_if(self.slot, ready, copy.slot);
        m.next_if(self.tile, ready, copy.tile);
        let diagonals = copy.diagonals;
        let TileRectangle { left, right, top, bottom } = copy.bounds;
        m.next_if(self.bottom, ready, bottom);
        let own_sides = [held(m, "left", ready, left), held(m, "right", ready, right)];
        let own_diagonals = diagonals.register(m, config, "", ready);

        let bits = self.sample_bits;
        let first = limits(bits, [left, right], &diagonals, top);
        let second = limits(bits, [left, right], &diagonals, top.add_lit(1));
        let following = limits(bits, own_sides, &own_diagonals, self.row.add_lit(2));
        // The splitter sends no other rows.
        let loaded = has_some(first) & (top.eq(bottom) | has_some(second));
        let is_there = self.row.add_carry(lit(LOCAL_BITS, 2)).le(self.bottom.zext(LOCAL_BITS + 1));
        let followed = !is_there | has_some(following);
        m.assert("rows_have_samples", (!(ready & arrives) | loaded) & (!self.busy | followed));
        let [first_ends, second_ends, following_ends] =
            [first, second, following].map(|limits| samples(bits, ends(limits)));
        let [next_begin, next_end] = self.next_ends;
        let next_column = row_done.mux(next_begin, self.column.add_lit(1));
        let next_row = row_done.mux(self.row.add_lit(1), self.row);
        let new_row = advance & (idle | row_done);
        m.next_if(self.column, advance, idle.mux(first_ends[0], next_column));
        m.next_if(self.row, advance, idle.mux(top, next_row));
        m.next_if(self.row_end, new_row, idle.mux(first_ends[1], next_end));
        for (end, (second, following)) in self.next_ends.iter().zip(second_ends.into_iter().zip(following_ends)) {
            m.next_if(*end, new_row, idle.mux(second, following));
        }
        // A pixel with several columns has several samples in each.
        let single = match bits {
            0 => top.eq(bottom) & has_one(first),
            _ => bit(false),
        };
        let next_row_end = row_done.mux(next_end, self.row_end);
        let reaches_last = cat([next_row, next_column]).eq(cat([*self.bottom, next_row_end]));
        m.next_if(self.last, advance, idle.mux(single, reaches_last));
        let is_idle = idle.mux(!arrives | single, reaches_last);
        m.next_if(self.idle, advance, is_idle);
        m.next_if(self.walks, advance, !is_idle);
        m.assert("walks_unless_idle", self.walks ^ self.idle);
    }

    /// The lowest bit of the copy's bin of the exposure, where there are several.
    pub fn odd_bin(&self, config: &Config) -> Expr {
        if config.bin_bits() > 0 { self.tile.bit(0) } else { bit(false) }
    }

    /// Column and row of the current sample in the image.
    pub fn place(&self, config: &Config) -> [Expr; 2] {
        let column_bits = config.tile_column_bits();
        let tile_column = self.tile.bits(column_bits - 1, config.bin_bits());
        let tile_row = self.tile.bits(config.tile_bits() - 1, column_bits);
        [cat([tile_column, *self.column]), cat([tile_row, *self.row])]
    }
}
