//! Two sides take turns at one stream.

use pointcore_contract::Record;
use pointcore_contract::splat::Config;
use pointcore_contract::unit::In;

use crate::units::ports::StreamInPorts;
use crate::units::wires::{Bundle, Wired};
use rtl::{Expr, Module};

/// What moves from one of the sides.
pub struct Taken<B> {
    pub moves: Expr,
    pub is_high: Expr,
    pub record: B,
}

/// Takes from the side whose turn it is, if `open`; the turn passes on where nothing moves.
pub fn take<R: Record<Config = Config>>(
    m: &mut Module,
    config: &Config,
    what: &str,
    sides: [In<R>; 2],
    open: impl FnOnce(Expr) -> Expr,
) -> Taken<Wired<R>> {
    let turn = m.reg_reset(&format!("{what}_turn"), 1, 0);
    let open = m.wire(&format!("{what}_open"), open(turn.expr()));
    let [low, high] = sides.map(|side| side.declare(m, config));
    m.drive(low.ready, open & !turn);
    m.drive(high.ready, open & turn);
    let moves = m.wire(&format!("{what}_moves"), open & turn.mux(high.valid, low.valid));
    m.next(turn, turn ^ !moves);
    Taken { moves, is_high: turn.expr(), record: Bundle::choose(config, turn.expr(), high.record, low.record) }
}
