//! Splits a splat's octagon at tile boundaries into copies, one per tile, row by row (thesis 5.5.1);
//! golden twin: `pointcore_golden::splat::splitter`.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_SIZE;
use pointcore_contract::splat::records::{
    DIAGONAL_BITS, ImageRectangle, LOCAL_BITS, SetupSplat, SplatCopy, TileDiagonals, TileRectangle,
};
use pointcore_contract::splat::units::splitter::PORTS;

use crate::units::ports::{StreamInPorts, StreamOutPorts, held};
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Module, cat, lit};

/// The tile's row or column that a pixel's lies in.
fn tile_of(pixel: Expr) -> Expr {
    pixel.bits(pixel.width() - 1, LOCAL_BITS)
}

/// The first tile that a rectangle touches, row above column.
fn first_tile(bounds: &ImageRectangle<Wires>) -> Expr {
    cat([tile_of(bounds.top), tile_of(bounds.left)])
}

/// The last one.
fn last_tile(bounds: &ImageRectangle<Wires>) -> Expr {
    cat([tile_of(bounds.bottom), tile_of(bounds.right)])
}

/// `a − b`, at least 0.
fn less(a: Expr, b: Expr) -> Expr {
    a.lt(b).mux(lit(a.width(), 0), a - b)
}

fn larger(a: Expr, b: Expr) -> Expr {
    a.lt(b).mux(b, a)
}

fn smaller(a: Expr, b: Expr) -> Expr {
    a.lt(b).mux(a, b)
}

/// A tile's first sum or difference, or one past its last: counted from the tile's first pixel, in [`DIAGONAL_BITS`].
fn within_tile(limit: Expr, origin: Expr) -> Expr {
    let place = limit - origin;
    let beyond = place.bits(place.width() - 2, DIAGONAL_BITS).any();
    let none = lit(DIAGONAL_BITS, 0);
    place.msb().mux(none, beyond.mux(!none, place.trunc(DIAGONAL_BITS)))
}

/// What the octagon has of the current tile, from [`within_tile`].
struct Diagonals {
    first_sum: Expr,
    past_sum: Expr,
    first_difference: Expr,
    past_difference: Expr,
}

impl Diagonals {
    /// Found in a cycle of `locate`.
    fn new(m: &mut Module, config: &Config, splat: &SetupSplat<Wires>, [column, row]: [Expr; 2], locate: Expr) -> Self {
        // One past the last, and a sign.
        let width = config.diagonal_bits() + 2;
        let pixels = lit(LOCAL_BITS - config.sampling.columns().ilog2(), 0);
        let column = cat([column, pixels]).zext(width);
        let origin = |row: Expr| column + cat([row, lit(LOCAL_BITS, 0)]).zext(width);
        let origins = [origin(row), origin(!row)];
        let limits = splat.diagonals;
        let mut register = |name, limit: Expr, past: u128, diagonal: usize| {
            let place = within_tile(limit.zext(width).add_lit(past), origins[diagonal]);
            held(m, name, locate, place)
        };
        Self {
            first_sum: register("first_sum", limits.first_sum, 0, 0),
            past_sum: register("past_sum", limits.last_sum, 1, 0),
            first_difference: register("first_difference", limits.first_difference, 0, 1),
            past_difference: register("past_difference", limits.last_difference, 1, 1),
        }
    }

    /// First row and one past the last, of those that have a pixel between these columns: in others, one of what limits a row from the left
    /// lies behind one of what limits it from the right.
    fn rows(&self, [first, last]: [Expr; 2], [top, bottom]: [Expr; 2]) -> [Expr; 2] {
        let Self { first_sum, past_sum, first_difference, past_difference } = *self;
        let wide = |value: Expr| value.zext(DIAGONAL_BITS);
        let from_below = |column: Expr| cat([lit(1, 1), column]);
        let half = |sum: Expr, constant: u128, other: Expr| {
            let sum = sum.zext(DIAGONAL_BITS + 1).add_lit(constant);
            less(sum, other.zext(DIAGONAL_BITS + 1)).bits(DIAGONAL_BITS, 1)
        };
        let tops = [
            less(first_sum, wide(last)),
            less(from_below(first), past_difference),
            half(first_sum, TILE_SIZE as u128 + 1, past_difference),
        ];
        let pasts = [
            less(past_sum, wide(first)),
            less(from_below(last), first_difference),
            half(past_sum, TILE_SIZE as u128, first_difference),
        ];
        let ([a, b, c], [d, e, f]) = (tops, pasts);
        [larger(larger(wide(top), a), larger(b, c)), smaller(smaller(wide(bottom).add_lit(1), d), smaller(e, f))]
    }

    fn of_tile(&self) -> TileDiagonals<Wires> {
        TileDiagonals {
            first_sum: self.first_sum,
            last_sum: self.past_sum.sub_lit(1),
            first_difference: self.first_difference,
            last_difference: self.past_difference.sub_lit(1),
        }
    }
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_splitter", "Splits a splat's octagon into one copy per tile.");
    let input = PORTS.input.declare(&mut m, config);
    let out = PORTS.out.half(&mut m, config);

    // A splat of hundreds of bits hangs on whether one can be taken, so that is known before the cycle begins: there is none, or its
    // current tile is the last, and its diagonals are found.
    let busy = m.reg_reset("busy", 1, 0);
    let located = m.reg("located", 1);
    let idle = m.reg_reset("idle", 1, 1);
    let last = m.reg("last", 1);
    let ready = m.wire("ready", out.room & idle);
    m.drive(input.ready, ready);
    let take = m.wire("take", ready & input.valid);
    let locate = m.wire("locate", busy & !located);
    let step = m.wire("step", out.room & (busy & located));
    let arriving = input.record;
    let splat = arriving.register(&mut m, config, "splat_", ready);
    let bounds = splat.bounds;

    let column = m.reg("column", config.tile_column_bits());
    let row = m.reg("row", config.tile_row_bits());
    let left_most = column.eq(tile_of(bounds.left));
    let right_most = m.wire("right_most", column.eq(tile_of(bounds.right)));
    let top_most = row.eq(tile_of(bounds.top));
    let bottom_most = row.eq(tile_of(bounds.bottom));

    let moves = m.wire("moves", take | step);
    m.next(busy, take | (busy & !(step & last)));
    m.next(located, locate | (located & !moves));
    m.next(idle, locate.mux(last, idle & !take));
    let next_column = right_most.mux(tile_of(bounds.left), column.add_lit(1));
    m.next_if(column, moves, take.mux(tile_of(arriving.bounds.left), next_column));
    let next_row = right_most.mux(row.add_lit(1), row);
    m.next_if(row, moves, take.mux(tile_of(arriving.bounds.top), next_row));
    let single = arriving.end | first_tile(&arriving.bounds).eq(last_tile(&arriving.bounds));
    let reaches_last = cat([next_row, next_column]).eq(last_tile(&bounds));
    m.next_if(last, moves, take.mux(single, reaches_last));

    // The rectangle's edge where it lies in this tile, else the tile's own.
    let clip = |edge: Expr, here: Expr, of_tile: u32| here.mux(edge.trunc(LOCAL_BITS), lit(LOCAL_BITS, of_tile.into()));
    let [left, right] = [clip(bounds.left, left_most, 0), clip(bounds.right, right_most, TILE_SIZE - 1)];
    let diagonals = Diagonals::new(&mut m, config, &splat, [*column, *row], locate);
    let pixel = |column: Expr| column.bits(LOCAL_BITS - 1, config.sampling.columns().ilog2()).zext(LOCAL_BITS);
    let [top, past] = diagonals.rows(
        [pixel(left), pixel(right)],
        [clip(bounds.top, top_most, 0), clip(bounds.bottom, bottom_most, TILE_SIZE - 1)],
    );
    let occupied = m.wire("occupied", splat.end | top.lt(past));
    let push = m.wire("push", step & occupied);
    let first = m.reg("first", 1);
    m.next(first, take | (first & !push));
    let (top, bottom) = (top.trunc(LOCAL_BITS), past.sub_lit(1).trunc(LOCAL_BITS));
    let copy = SplatCopy {
        end: splat.end,
        first: *first,
        footprint: splat.footprint,
        attributes: splat.attributes,
        bounds: TileRectangle { left, right, top, bottom },
        diagonals: diagonals.of_tile(),
        tile: cat([row, column]),
    };
    out.push(&mut m, config, push, copy);
    m
}
