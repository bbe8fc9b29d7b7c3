//! Splits a splat's octagon at tile boundaries into copies, one per tile, row by row (thesis 5.5.1);
//! golden twin: `pointcore_golden::splat::splitter`.

use pointcore_contract::record;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::TILE_SIZE;
use pointcore_contract::splat::records::{
    DIAGONAL_BITS, ImageRectangle, LOCAL_BITS, SetupSplat, SplatCopy, TileDiagonals, TileRectangle,
};
use pointcore_contract::splat::units::splitter::PORTS;

use super::parts::extreme::extreme;
use crate::stream::{half_buffer, skid};
use crate::units::ports::{Flow, StreamInPorts, StreamOutPorts, held};
use crate::units::queue::Pushed;
use crate::units::wires::{Bundle, Wires, layout};
use rtl::{Expr, Module, bit, cat, lit};

/// The tile's row or column that a pixel's lies in.
fn tile_of(pixel: Expr) -> Expr {
    pixel.bits(pixel.width() - 1, LOCAL_BITS)
}

/// What a tile has of the first sum or difference, from 0 to one past its last one; `place` counts from the tile's first pixel and has
/// a sign.
fn first_within(place: Expr) -> Expr {
    let [none, all] = [lit(DIAGONAL_BITS, 0), !lit(DIAGONAL_BITS, 0)];
    place.msb().mux(none, is_beyond(place).mux(all, place.trunc(DIAGONAL_BITS)))
}

/// What a tile has of the last one, from −1 to its own last, with a sign.
fn last_within(place: Expr) -> Expr {
    let low = place.trunc(DIAGONAL_BITS);
    let last = (is_beyond(place) | low.all()).mux(lit(DIAGONAL_BITS, 2 * (TILE_SIZE as u128 - 1)), low);
    cat([place.msb(), place.msb().repeat(DIAGONAL_BITS) | last])
}

/// A place that is not negative has more than [`DIAGONAL_BITS`].
fn is_beyond(place: Expr) -> Expr {
    place.bits(place.width() - 2, DIAGONAL_BITS).any()
}

/// When the splitter may go to a tile, and to the first one of a row; and what registers take then, which is known before: what arrives,
/// or the first tile of a row.
struct Steps {
    moves: Expr,
    turns: Expr,
    takes_arriving: Expr,
    takes_row: Expr,
}

/// Bits of a row that is counted from 16 above the tile, so that those which limits lead to have no sign.
const ROW_BITS: u32 = DIAGONAL_BITS + 1;

/// What the octagon has of the current tile, from [`first_within`] and [`last_within`]. Rows are sums of these, of those inverted and of
/// single bits, all of which come out of registers.
struct Diagonals {
    first_sum: Expr,
    last_sum: Expr,
    last_difference: Expr,
    not_first_difference: Expr,
    not_last_difference: Expr,
    /// Neither sum has the bit that a tile's size is.
    not_half: [Expr; 2],
    last_sum_not_negative: Expr,
    /// It has that bit, and no sign.
    last_sum_over_half: Expr,
}

impl Diagonals {
    /// Registers, found while the splitter comes to the tile: of a splat's first tile from what arrives, of others from what they were for
    /// the tile before, or at the beginning of its row.
    fn new(m: &mut Module, config: &Config, arriving: &SetupSplat<Wires>, steps: &Steps) -> Self {
        let Steps { moves, turns, takes_arriving, takes_row } = *steps;
        // One beyond, and a sign.
        let width = config.diagonal_bits() + 2;
        let tile_pixels = u128::from(TILE_SIZE / config.sampling.columns());
        let left = tile_of(arriving.bounds.left);
        // A tile has but one column of pixels where a pixel has as many samples as a tile is wide.
        let column = match LOCAL_BITS - config.sampling.columns().ilog2() {
            0 => left.zext(width),
            pixel_bits => cat([left, lit(pixel_bits, 0)]).zext(width),
        };
        let row = tile_of(arriving.bounds.top);
        // A limit less the origin of the tile's column and row: three numbers become two bit by bit, so that but one sum carries.
        let from_origin = |limit: Expr, row: Expr| {
            let [limit, column, row] = [limit.zext(width), !column, !cat([row, lit(LOCAL_BITS, 0)]).zext(width)];
            let carries = (limit & column) | (limit & row) | (column & row);
            (limit ^ column ^ row) - !cat([carries.trunc(width - 1), lit(1, 1)])
        };
        let sums = |place: Expr| place.sub_lit(TILE_SIZE.into());
        let differences = |place: Expr| place.add_lit(TILE_SIZE.into());
        let limits = arriving.diagonals;
        let mut limit = |name: &str, limit: Expr, row: Expr, below: fn(Expr) -> Expr, within: fn(Expr) -> Expr| {
            let [here, row_begins] = ["here", "row_begins"].map(|at| m.reg(&format!("{name}_{at}"), width));
            let first = m.wire(&format!("{name}_arrives"), from_origin(limit, row));
            let below = below(row_begins.expr());
            m.next_if(row_begins, turns, takes_arriving.mux(first, below));
            let moved = takes_row.mux(below, here.sub_lit(tile_pixels));
            let moved = m.wire(&format!("{name}_moved"), moved);
            m.next_if(here, moves, takes_arriving.mux(first, moved));
            // Of both before one is chosen: what arrives comes late.
            takes_arriving.mux(within(first), within(moved))
        };
        let first_sum = limit("first_sum", limits.first_sum, row, sums, first_within);
        let last_sum = limit("last_sum", limits.last_sum, row, sums, last_within);
        let first_difference = limit("first_difference", limits.first_difference, !row, differences, first_within);
        let last_difference = limit("last_difference", limits.last_difference, !row, differences, last_within);
        let mut register = |name: &str, value: Expr| held(m, name, moves, value);
        let half = LOCAL_BITS;
        Self {
            first_sum: register("first_sum", first_sum),
            last_sum: register("last_sum", last_sum),
            last_difference: register("last_difference", last_difference),
            not_first_difference: register("not_first_difference", !first_difference),
            not_last_difference: register("not_last_difference", !last_difference),
            not_half: [
                register("first_sum_not_half", !first_sum.bit(half)),
                register("last_sum_not_half", !last_sum.bit(half)),
            ],
            last_sum_not_negative: register("last_sum_not_negative", !last_sum.msb()),
            last_sum_over_half: register("last_sum_over_half", last_sum.bit(half) & !last_sum.msb()),
        }
    }

    /// What limits the rows that have a pixel between the edges' columns, from above and from below: in others, one of what limits a row
    /// from the left lies behind one of what limits it from the right. Each is a single sum, for −a is !a + 1, and a tile's size is a bit.
    fn rows(&self, edges: &TileRectangle<Wires>, config: &Config) -> [[Expr; 4]; 2] {
        let Self { first_sum, last_sum, last_difference, not_first_difference, not_last_difference, .. } = *self;
        let pixel = |column: Expr| match config.sampling.columns().ilog2() {
            LOCAL_BITS => lit(LOCAL_BITS, 0),
            sample_bits => column.bits(LOCAL_BITS - 1, sample_bits).zext(LOCAL_BITS),
        };
        let [first, last] = [pixel(edges.left), pixel(edges.right)];
        let one = lit(1, 1);
        let row = |place: Expr| cat([one, place.zext(DIAGONAL_BITS)]);
        // Of a place that has a sign, and of a column and a tile's size.
        let signed = cat([self.last_sum_not_negative, last_sum.trunc(DIAGONAL_BITS)]);
        let from_below = |column: Expr| cat([one, one, column]);
        let without_sign = |inverted: Expr, bits: u32| cat([one.repeat(bits - inverted.width()), inverted]);
        let wide = |place: Expr| place.zext(ROW_BITS);
        // A place and a tile's size, which carries.
        let larger = |carry: Expr, not_half: Expr, place: Expr| cat([one, carry, not_half, place.trunc(LOCAL_BITS)]);
        let [first_sum_not_half, last_sum_not_half] = self.not_half;
        let half = |sum: Expr| sum.bits(ROW_BITS, 1);
        let tops = [
            row(edges.top),
            row(first_sum) - wide(last),
            from_below(first) + not_last_difference,
            half(larger(first_sum.msb(), first_sum_not_half, first_sum) - last_difference.sext(ROW_BITS + 1)),
        ];
        let bottoms = [
            row(edges.bottom),
            signed - wide(first),
            from_below(last) + without_sign(not_first_difference, ROW_BITS),
            half(
                larger(self.last_sum_over_half, last_sum_not_half, last_sum)
                    + without_sign(not_first_difference, ROW_BITS + 1),
            ),
        ];
        [tops, bottoms]
    }

    fn of_tile(&self) -> TileDiagonals<Wires> {
        TileDiagonals {
            first_sum: self.first_sum,
            last_sum: self.last_sum.trunc(DIAGONAL_BITS),
            first_difference: !self.not_first_difference,
            last_difference: self.last_difference.trunc(DIAGONAL_BITS),
        }
    }
}

/// The current tile, and what is known of it before its cycle.
struct Walk {
    column: Expr,
    row: Expr,
    /// The rectangle's edges where they lie in this tile, else the tile's own.
    edges: TileRectangle<Wires>,
    /// The arriving splat touches one tile.
    single: Expr,
    /// The current tile is its row's last.
    right_most: Expr,
    /// The next tile begins a row.
    turns: Expr,
    /// The next tile is the last.
    reaches_last: Expr,
}

impl Walk {
    /// Row by row through the tiles of a rectangle, `[arriving, current]`.
    fn new(
        m: &mut Module,
        config: &Config,
        [arriving, bounds]: [&ImageRectangle<Wires>; 2],
        [moves, takes_arriving]: [Expr; 2],
    ) -> Self {
        let [right_most, bottom_most] = ["right_most", "bottom_most"].map(|name| m.reg(name, 1));
        let turns = m.wire("turns", moves & (takes_arriving | right_most));
        let column_bits = config.column_bits() - LOCAL_BITS;
        let [column, row] =
            [("column", column_bits), ("row", config.tile_row_bits())].map(|(name, bits)| m.reg(name, bits));

        let is_one = |first: Expr, last: Expr| tile_of(first).eq(tile_of(last));
        let one_column = m.wire("one_column", is_one(arriving.left, arriving.right));
        let one_row = m.wire("one_row", is_one(arriving.top, arriving.bottom));
        let [next_column, next_row] = [column.add_lit(1), row.add_lit(1)];
        let stays_one = is_one(bounds.left, bounds.right);
        let reaches_right = m.wire("reaches_right", right_most.mux(stays_one, next_column.eq(tile_of(bounds.right))));
        let reaches_bottom = m.wire("reaches_bottom", next_row.eq(tile_of(bounds.bottom)));
        m.next_if(
            column,
            moves,
            takes_arriving.mux(tile_of(arriving.left), right_most.mux(tile_of(bounds.left), next_column)),
        );
        m.next_if(row, turns, takes_arriving.mux(tile_of(arriving.top), next_row));
        m.next_if(right_most, moves, takes_arriving.mux(one_column, reaches_right));
        m.next_if(bottom_most, turns, takes_arriving.mux(one_row, reaches_bottom));

        let place = |edge: Expr| edge.trunc(LOCAL_BITS);
        let [own_first, own_last] = [0, TILE_SIZE - 1].map(|pixel| lit(LOCAL_BITS, pixel.into()));
        let last = |is_here: Expr, edge: Expr| is_here.mux(place(edge), own_last);
        let left = takes_arriving.mux(place(arriving.left), right_most.mux(place(bounds.left), own_first));
        let right = takes_arriving.mux(last(one_column, arriving.right), last(reaches_right, bounds.right));
        let top = takes_arriving.mux(place(arriving.top), own_first);
        let bottom = takes_arriving.mux(last(one_row, arriving.bottom), last(reaches_bottom, bounds.bottom));
        let edges = TileRectangle {
            left: held(m, "left", moves, left),
            right: held(m, "right", moves, right),
            top: held(m, "top", turns, top),
            bottom: held(m, "bottom", turns, bottom),
        };
        let reaches_last = reaches_right & right_most.mux(reaches_bottom, bottom_most.expr());
        Self {
            column: *column,
            row: *row,
            edges,
            single: one_column & one_row,
            right_most: *right_most,
            turns,
            reaches_last,
        }
    }
}

/// What leaves for a tile. That the octagon only seems to touch one is found out as it comes here, too late to hold it back: it leaves by
/// itself.
#[record(config: Config)]
struct TileCopy {
    /// There is a copy, say all of these.
    #[bits(4)]
    made: u8,
    /// The copy; `first` says that the tile is.
    copy: SplatCopy,
}

/// The way out.
struct Exit {
    tiles: Pushed<TileCopy>,
    /// One shows.
    shows: Expr,
    /// It leaves, if it does.
    leaves: Expr,
}

impl Exit {
    fn new(m: &mut Module, config: &Config) -> Self {
        // One lane takes a copy every second cycle at most.
        let buffer = match config.rasterizers {
            1 => half_buffer(&layout::<TileCopy>(config)),
            _ => skid(&layout::<TileCopy>(config)),
        };
        let (tiles, tile): (_, Flow<TileCopy<Wires>>) = Pushed::place(m, config, "out_queue", buffer);
        let Flow { valid: shows, record: TileCopy { made, copy }, ready } = tile;
        let made = m.wire("made", made.all());
        let none_made = m.reg("none_made", 1);
        let first = copy.first | none_made;
        let taken = PORTS.out.drive(m, config, shows & made, SplatCopy { first, ..copy });
        let leaves = taken | !made;
        m.drive(ready, leaves);
        m.next_if(none_made, shows & leaves, first & !made);
        Self { tiles, shows, leaves }
    }

    /// Whether there will be room, where a tile comes in this cycle if there is.
    fn next_room(&self, config: &Config, room: Expr, comes: Expr) -> Expr {
        match config.rasterizers {
            1 => room.mux(!comes, self.leaves),
            _ => (room & !comes) | (!self.shows | self.leaves),
        }
    }
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_splitter", "Splits a splat's octagon into one copy per tile.");
    let input = PORTS.input.declare(&mut m, config);
    let exit = Exit::new(&mut m, config);

    // A splat of hundreds of bits hangs on whether one can be taken, so that is known before the cycle begins: there is room, and no splat,
    // or its current tile is the last. Each of those who ask for that has a register of its own.
    let room = m.reg_reset("room", 1, 1);
    let busy = m.reg_reset("busy", 1, 0);
    let open = m.reg_reset("open", 1, 1);
    let ready = m.reg_reset("ready", 1, 1);
    let closed = m.reg_reset("closed", 1, 0);
    m.drive(input.ready, ready);
    let arriving = input.record;
    let splat = arriving.register(&mut m, config, "splat_", !closed);
    let bounds = splat.bounds;

    // While it is open and none is there, registers may take what they will: so what they take does not wait for who offers it.
    let moves = room.expr();
    m.next_if(busy, moves, open.mux(input.valid, *busy));
    let walk = Walk::new(&mut m, config, [&arriving.bounds, &bounds], [moves, *open]);
    let ends = arriving.end | walk.single;
    let opens = open.mux(!input.valid | ends, walk.reaches_last);
    m.next_if(open, moves, opens);
    let next_room = m.wire("next_room", exit.next_room(config, *room, *busy));
    let next_ready = m.wire("next_ready", next_room & moves.mux(opens, *open));
    m.next(room, next_room);
    m.next(ready, next_ready);
    m.next(closed, !next_ready);
    m.assert("room_is_that_of_the_way_out", room.eq(exit.tiles.room));
    m.assert("ready_while_open_and_room", ready.eq(room & open) & (ready ^ closed));

    let edges = walk.edges;
    let steps = Steps { moves, turns: walk.turns, takes_arriving: *open, takes_row: walk.right_most };
    let diagonals = Diagonals::new(&mut m, config, &arriving, &steps);
    let [tops, bottoms] = diagonals.rows(&edges, config);
    // Every pair on its own: a tree of larger and smaller ones would have to be waited for.
    let none_behind = tops.map(|top| splat.end | bottoms.iter().fold(bit(true), |all, bottom| all & bottom.ge(top)));
    let first = held(&mut m, "first", moves, open);
    let top = extreme(tops, |place, other| tops[place].ge(tops[other])).trunc(LOCAL_BITS);
    let bottom = extreme(bottoms, |place, other| bottoms[other].ge(bottoms[place])).trunc(LOCAL_BITS);
    let copy = SplatCopy {
        end: splat.end,
        first,
        footprint: splat.footprint,
        moving: splat.moving,
        attributes: splat.attributes,
        bounds: TileRectangle { top, bottom, ..edges },
        diagonals: diagonals.of_tile(),
        tile: if config.bin_bits() > 0 {
            cat([walk.row, walk.column, splat.bin])
        } else {
            cat([walk.row, walk.column])
        },
    };
    exit.tiles.push(&mut m, config, room & busy, TileCopy { made: cat(none_behind), copy });
    m
}
