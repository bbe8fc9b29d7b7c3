//! The coordinates of the queries under way, by thread.

use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::Field;

use crate::units::records::{Pulse, Record, width};
use rtl::{Expr, Module};

/// The fields of a query's point.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

/// Remembers the coordinates of each query that starts; reads those of `thread` where `enable` is set.
pub(crate) fn coordinates(
    m: &mut Module,
    config: &Config,
    start: &Pulse,
    enable: impl Into<Expr>,
    thread: impl Into<Expr>,
) -> Record {
    let (enable, thread) = (enable.into(), thread.into());
    let is_axis = |(name, _): &Field| AXES.contains(&name.as_str());
    let fields: Vec<_> = records::start(config).into_iter().filter(is_axis).collect();
    let queries = m.memory("queries", 1 << config.thread_bits(), width(&fields));
    m.write(queries, start.valid, start.record.get("thread"), start.record.only(&fields).pack());
    let query = m.read_if(queries, "query", enable, thread);
    Record::unpack(&fields, query)
}
