//! What is kept of a neighbor.

use pointcore_contract::record;
use pointcore_contract::search::Config;

use rtl::Expr;

/// Which point it is and how far away.
#[record(config: Config)]
pub(crate) struct Neighbor {
    /// The point's place in the point memory.
    #[bits(config.index_bits)]
    pub index: u32,
    /// Its squared distance.
    #[bits(config.square_bits())]
    pub distance2: u32,
}

/// A square, but for its sign.
pub(crate) fn without_sign(square: Expr) -> Expr {
    square.trunc(square.width() - 1)
}

/// A square of which the sign was left out.
pub(crate) fn with_sign(square: Expr) -> Expr {
    square.zext(square.width() + 1)
}
