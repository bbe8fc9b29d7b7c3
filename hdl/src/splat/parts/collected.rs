//! Leads two sides' records, of which some close a frame, into one stream.

use pointcore_contract::Record;
use pointcore_contract::splat::Config;
use pointcore_contract::unit::{In, Out};

use super::turns::take;
use crate::units::ports::{StreamOutPorts, pipe};
use crate::units::wires::Wired;
use rtl::{Expr, Instance, Module};

/// A record that may close a frame, and the collector of such.
pub trait Closing: Record<Config = Config> {
    /// The collector's module, and what it does.
    const MODULE: [&'static str; 2];
    /// Its ports: the lower numbers, the higher ones, both.
    const PORTS: (In<Self>, In<Self>, Out<Self>);

    /// The place of the bit that closes a frame.
    fn end(record: &mut Wired<Self>) -> &mut Expr;
}

/// The unit for such records.
#[must_use]
pub fn module<R: Closing>(config: &Config) -> Module {
    let [name, does] = R::MODULE;
    let mut m = Module::new(name, does);
    let (low, high, out) = R::PORTS;
    let ended = ["low_ended", "high_ended"].map(|name| m.reg_reset(name, 1, 0));
    let [low_ended, high_ended] = ended;
    let out = out.queue(&mut m, config);
    let open = |turn: Expr| out.room & !turn.mux(high_ended, low_ended);
    let mut taken = take::<R>(&mut m, config, "side", [low, high], open);
    let end = R::end(&mut taken.record);
    let closing = m.reg_reset("closing", 1, 0);
    let closes = m.wire("closes", ((low_ended & high_ended) & !closing) & out.room);
    let has_closed = m.wire("has_closed", closing & !out.holds);
    m.next(closing, closes | (closing & !has_closed));
    let ends = m.wire("ends", taken.moves & *end);
    for (ended, is_side) in ended.into_iter().zip([!taken.is_high, taken.is_high]) {
        m.next(ended, !has_closed & (ended | (ends & is_side)));
    }
    let pushes = closes | (taken.moves & !*end);
    *end = closes;
    out.push(&mut m, config, pushes, taken.record);
    m
}

/// Whatever makes such records, and where it puts them out.
pub(crate) type Source<R> = (Instance, Out<R>);

/// Places a collector of that name behind two sides.
pub(crate) fn join<R: Closing>(m: &mut Module, config: &Config, name: &str, [low, high]: [Source<R>; 2]) -> Source<R> {
    let instance = m.instance(name, module::<R>(config));
    let (low_in, high_in, out) = R::PORTS;
    pipe(m, config, low, (instance, low_in));
    pipe(m, config, high, (instance, high_in));
    (instance, out)
}
