//! Finds the pixels of a mask, row by row: what it shows comes from the few bits of one row, and the next row is chosen meanwhile.

use pointcore_contract::splat::config::{TILE_PIXELS, TILE_SIZE};
use pointcore_contract::splat::records::{LOCAL_BITS, RUN_BITS};

use rtl::{Expr, Module, Reg, bit, cat, lit};

/// A mask of which pixels are found: its rows that have pixels and were not begun, and what is left of the one that was.
pub(super) struct Seeker {
    name: &'static str,
    mask: Reg,
    rows: Reg,
    row: Reg,
    left: Reg,
    /// Pixels are left.
    any: Reg,
}

/// The first pixels that are left.
pub(super) struct Found {
    /// There are some.
    pub any: Expr,
    /// The index of the first in its tile.
    pub pixel: Expr,
    /// A bit of the row for that one.
    pub first: Expr,
    /// A bit of the row for each that follows without a gap, the first included.
    pub run: Expr,
    /// How many these are.
    pub count: Expr,
}

/// Of the values, the one whose condition is set, or 0 where none is.
pub(super) fn pick(width: u32, choices: impl Iterator<Item = (Expr, Expr)>) -> Expr {
    choices.fold(lit(width, 0), |all, (condition, value)| all | (condition.repeat(width) & value))
}

/// Of the bits, the lowest that is set.
fn lowest(bits: &[Expr]) -> Vec<Expr> {
    let below = |place: usize| bits[..place].iter().copied().reduce(|any, bit| any | bit);
    (0..bits.len()).map(|place| below(place).map_or(bits[place], |below| bits[place] & !below)).collect()
}

/// The number of the bit that is set.
fn number(width: u32, bits: impl IntoIterator<Item = Expr>) -> Expr {
    pick(width, bits.into_iter().zip(0..).map(|(bit, number)| (bit, lit(width, number))))
}

impl Seeker {
    /// Declares the registers.
    pub fn new(m: &mut Module, name: &'static str) -> Self {
        let mask = m.reg(&format!("{name}_mask"), TILE_PIXELS);
        let rows = m.reg_reset(&format!("{name}_rows"), TILE_PIXELS / TILE_SIZE, 0);
        let row = m.reg(&format!("{name}_row"), LOCAL_BITS);
        let left = m.reg_reset(&format!("{name}_left"), TILE_SIZE, 0);
        let any = m.reg_reset(&format!("any_{name}"), 1, 0);
        Self { name, mask, rows, row, left, any }
    }

    /// No pixel is left.
    pub fn is_empty(&self) -> Expr {
        !self.any
    }

    /// Whether the row in which pixels are found comes behind another.
    pub fn is_behind(&self, row: Expr) -> Expr {
        self.left.any() & row.lt(self.row)
    }

    /// What it shows; to be called once.
    pub fn found(&self, m: &mut Module) -> Found {
        let name = self.name;
        let left: Vec<_> = (0..TILE_SIZE).map(|place| self.left.bit(place)).collect();
        let first = lowest(&left);
        let mut run = vec![first[0]];
        for place in 1..left.len() {
            run.push(left[place] & (first[place] | run[place - 1]));
        }
        // The place behind a run tells its length.
        let ends = (0..run.len()).map(|place| run.get(place + 1).map_or(run[place], |next| run[place] & !*next));
        let end = number(RUN_BITS, std::iter::once(bit(false)).chain(ends));
        let place = m.wire(&format!("{name}_place"), number(LOCAL_BITS, first.iter().copied()));
        let count = m.wire(&format!("{name}_count"), end - place.zext(RUN_BITS));
        let run = m.wire(&format!("{name}_run"), cat(run.into_iter().rev()));
        Found {
            any: self.left.any(),
            pixel: cat([self.row.expr(), place]),
            first: cat(first.into_iter().rev()),
            run,
            count,
        }
    }

    /// States how the registers change: it takes a mask, which holds `any_pixel`, in cycles where `begins` is set, or loses the pixels
    /// `taken` of its row.
    pub fn update(&self, m: &mut Module, begins: Expr, (mask, any_pixel): (Expr, Expr), taken: Expr) {
        let name = self.name;
        let rows_of = |mask: Expr| {
            let row = move |place: u32| mask.bits(TILE_SIZE * place + TILE_SIZE - 1, TILE_SIZE * place);
            (0..TILE_PIXELS / TILE_SIZE).map(row)
        };
        let having_pixels = |mask: Expr| cat(rows_of(mask).map(Expr::any).rev());
        let next = lowest(&(0..self.rows.width()).map(|place| self.rows.bit(place)).collect::<Vec<_>>());
        let next_left = pick(TILE_SIZE, next.iter().copied().zip(rows_of(*self.mask)));
        let left = self.left & !taken;
        let ends = m.wire(&format!("{name}_row_ends"), left.is_zero());
        m.next(self.left, ends.mux(next_left, left));
        m.next_if(self.row, ends, number(LOCAL_BITS, next.iter().copied()));
        // The mask stays as it is: which of its rows are left is enough, and does not move as many flip-flops.
        m.next_if(self.mask, begins, mask);
        let rows = self.rows & !cat(next.iter().copied().rev());
        m.next_if(self.rows, begins | ends, begins.mux(having_pixels(mask), rows));
        m.assert(&format!("{name}_rows_have_pixels"), (self.rows & !having_pixels(*self.mask)).is_zero());
        m.next(self.any, !ends | (self.rows.any() | (begins & any_pixel)));
    }
}
