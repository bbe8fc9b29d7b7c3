//! The coordinates of the queries under way, by thread.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::{AXES, Start};
use pointcore_contract::{record, width};

use crate::units::ports::Pulse;
use crate::units::wires::{Bundle, Wires};
use rtl::{Expr, Module};

/// What is kept of a query.
#[record(config: Config)]
struct Coordinates {
    /// Where it is.
    #[name(AXES[i])]
    #[bits(config.geometry.width())]
    point: [u32; 3],
}

/// Remembers the coordinates of each query that starts; reads those of `thread` where `enable` is set.
pub(crate) fn coordinates(
    m: &mut Module,
    config: &Config,
    start: Pulse<Start<Wires>>,
    enable: impl Into<Expr>,
    thread: impl Into<Expr>,
) -> [Expr; 3] {
    let (enable, thread) = (enable.into(), thread.into());
    let Start { thread: starting, query } = start.record;
    let queries = m.memory("queries", 1 << config.thread_bits(), width::<Coordinates>(config));
    m.write(queries, start.valid, starting.thread, Coordinates { point: query.point }.pack(config));
    let query = m.read_if(queries, "query", enable, thread);
    Coordinates::unpack(config, query).point
}
