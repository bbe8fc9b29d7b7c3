//! What is kept of a neighbor.

use pointcore_contract::record;
use pointcore_contract::search::Config;

use crate::units::wires::Wires;
use rtl::Expr;

/// Which point it is and how far away.
#[record(config: Config)]
pub(crate) struct Neighbor {
    /// The point's place in the point memory.
    #[bits(config.index_bits)]
    pub index: u32,
    /// Its squared distance, but for the sign, which no square has.
    #[bits(config.geometry.width() - 1)]
    pub distance2: u32,
}

impl Neighbor<Wires> {
    /// A point at a squared distance.
    pub fn new(index: Expr, distance2: Expr) -> Self {
        Self { index, distance2: without_sign(distance2) }
    }

    /// Its squared distance.
    pub fn squared_distance(&self) -> Expr {
        with_sign(self.distance2)
    }
}

/// A square, but for its sign.
pub(crate) fn without_sign(square: Expr) -> Expr {
    square.trunc(square.width() - 1)
}

/// A square of which the sign was left out.
pub(crate) fn with_sign(square: Expr) -> Expr {
    square.zext(square.width() + 1)
}
