//! Records that are always taken, at a unit's border.

use pointcore_contract::Record;
use pointcore_contract::unit::{PulseIn, PulseOut};
use rtl::{Expr, Instance, Module, bit};

use crate::units::documents::{self, prefix};
use crate::units::wires::{Bundle, Wired, layout};

/// A record that is always taken: it comes with `valid` and without `ready`.
#[derive(Clone, Copy)]
pub(crate) struct Pulse<B> {
    /// The record is there.
    pub valid: Expr,
    /// The record.
    pub record: B,
}

/// Leads records that are always taken from one unit to another.
pub(crate) fn pulse<R: Record>(
    m: &mut Module,
    config: &R::Config,
    (from, out): (Instance, PulseOut<R>),
    (to, input): (Instance, PulseIn<R>),
) {
    let pulse = out.of(m, config, from);
    input.feed(m, config, to, pulse);
}

/// Records into a unit that are always taken.
pub(crate) trait PulseInPorts<R: Record>: Sized {
    /// Declares the ports on the unit.
    fn declare(self, m: &mut Module, config: &R::Config) -> Pulse<Wired<R>>;

    /// Feeds an instance of the unit.
    fn feed(self, m: &mut Module, config: &R::Config, instance: Instance, pulse: Pulse<Wired<R>>);
}

impl<R: Record> PulseInPorts<R> for PulseIn<R> {
    fn declare(self, m: &mut Module, config: &R::Config) -> Pulse<Wired<R>> {
        let (valid, values) = m.pulse_in(self.name, self.flag, &layout::<R>(config));
        documents::flagged::<R>(m, config, (self.name, self.flag), self.doc);
        let record: Wired<R> = Bundle::from_values(config, values);
        record.assert_range(m, config, self.name, valid);
        Pulse { valid, record }
    }

    fn feed(self, m: &mut Module, config: &R::Config, instance: Instance, pulse: Pulse<Wired<R>>) {
        m.connect(instance, &self.port(self.flag), pulse.valid);
        pulse.record.connect(m, config, instance, &prefix(self.name));
    }
}

/// Records out of a unit that are always taken.
pub(crate) trait PulseOutPorts<R: Record>: Sized {
    /// Drives the ports on the unit.
    fn drive(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>);

    /// Drives them in the cycle after `valid`. The record follows every cycle: who decides on `valid` need not reach it.
    fn registered(
        self,
        m: &mut Module,
        config: &R::Config,
        valid: impl Into<Expr>,
        record: Wired<R>,
    ) -> Pulse<Wired<R>>;

    /// What an instance of the unit puts out.
    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Pulse<Wired<R>>;
}

impl<R: Record> PulseOutPorts<R> for PulseOut<R> {
    fn drive(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>) {
        m.pulse_out(self.name, self.flag, valid, record.named(config));
        documents::flagged::<R>(m, config, (self.name, self.flag), self.doc);
    }

    fn registered(
        self,
        m: &mut Module,
        config: &R::Config,
        valid: impl Into<Expr>,
        record: Wired<R>,
    ) -> Pulse<Wired<R>> {
        let shown = m.reg_reset(&self.port(self.flag), 1, 0);
        m.next(shown, valid);
        let record = record.register(m, config, &prefix(self.name), bit(true));
        self.drive(m, config, shown, record);
        Pulse { valid: shown.expr(), record }
    }

    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Pulse<Wired<R>> {
        let valid = m.out(instance, &self.port(self.flag));
        Pulse { valid, record: Bundle::shown_by(m, config, instance, &prefix(self.name)) }
    }
}
