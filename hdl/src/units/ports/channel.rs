//! The channels of AMBA buses at a unit's border.

use pointcore_contract::bus::axi::Bus;
use pointcore_contract::bus::{ChannelIn, ChannelOut, VALID};
use pointcore_contract::unit::READY;
use pointcore_contract::{Direction, Record, fields};
use rtl::{Expr, Instance, Module};

use crate::units::documents;
use crate::units::wires::{Bundle, Wired};

/// A channel into a unit.
pub(crate) trait ChannelInPorts<R: Record>: Sized {
    /// Declares the ports on the unit, which takes what is there while `ready` is set; returns whether something is, and what.
    fn declare(self, m: &mut Module, config: &R::Config, ready: impl Into<Expr>) -> (Expr, Wired<R>);
}

impl<R: Record> ChannelInPorts<R> for ChannelIn<R> {
    fn declare(self, m: &mut Module, config: &R::Config, ready: impl Into<Expr>) -> (Expr, Wired<R>) {
        let valid = m.input(&self.port(VALID), 1);
        m.output(&self.port(READY), ready);
        let record = Bundle::from_fields(config, |field| m.input(&self.port(&field.name), field.width));
        documents::group(m, &self.group(config));
        (valid, record)
    }
}

/// A channel out of a unit.
pub(crate) trait ChannelOutPorts<R: Record>: Sized {
    /// Drives the ports on the unit; returns whether what is there is taken.
    fn drive(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>) -> Expr;

    /// As [`ChannelOutPorts::drive`] where what is shown depends on whether it is taken.
    fn drive_with(
        self,
        m: &mut Module,
        config: &R::Config,
        valid: impl Into<Expr>,
        record: impl FnOnce(&mut Module, Expr) -> Wired<R>,
    );
}

impl<R: Record> ChannelOutPorts<R> for ChannelOut<R> {
    fn drive(self, m: &mut Module, config: &R::Config, valid: impl Into<Expr>, record: Wired<R>) -> Expr {
        let mut taken = Expr::default();
        self.drive_with(m, config, valid, |_, ready| {
            taken = ready;
            record
        });
        taken
    }

    fn drive_with(
        self,
        m: &mut Module,
        config: &R::Config,
        valid: impl Into<Expr>,
        record: impl FnOnce(&mut Module, Expr) -> Wired<R>,
    ) {
        m.output(&self.port(VALID), valid);
        let ready = m.input(&self.port(READY), 1);
        let record = record(m, ready);
        let values = fields::<R>(config).into_iter().zip(record.values(config));
        values.for_each(|(field, value)| m.output(&self.port(&field.name), value));
        documents::group(m, &self.group(config));
    }
}

/// Leads the bus `own` of an instance out of the module that places it, as `outer`.
pub(crate) fn export<B: Bus>(m: &mut Module, config: &B::Config, (instance, own): (Instance, B), outer: B) {
    for (own, outer) in own.groups(config).into_iter().zip(outer.groups(config)) {
        for (own, outer) in own.ports().zip(outer.ports()) {
            match own.direction {
                Direction::Input => {
                    let value = m.input(&outer.name, outer.width);
                    m.connect(instance, &own.name, value);
                }
                Direction::Output => {
                    let value = m.out(instance, &own.name);
                    m.output(&outer.name, value);
                }
            }
        }
        documents::group(m, &outer);
    }
}
