//! What is there in every cycle, at a unit's border.

use pointcore_contract::unit::{Input, Output};
use pointcore_contract::{Places, Record, fields, places};
use rtl::{Expr, Instance, Module};

use crate::units::documents::{self, prefix};
use crate::units::wires::{Bundle, Wired};

/// A record into a unit in every cycle.
pub(crate) trait InputPorts<R: Record>: Sized {
    /// Declares the ports on the unit.
    fn declare(self, m: &mut Module, config: &R::Config) -> Wired<R>;

    /// Feeds an instance of the unit.
    fn feed(self, m: &mut Module, config: &R::Config, instance: Instance, record: Wired<R>);
}

impl<R: Record> InputPorts<R> for Input<R> {
    fn declare(self, m: &mut Module, config: &R::Config) -> Wired<R> {
        let record = Bundle::input(m, config, &prefix(self.name));
        documents::of_fields::<R>(m, config, self.name);
        record
    }

    fn feed(self, m: &mut Module, config: &R::Config, instance: Instance, record: Wired<R>) {
        record.connect(m, config, instance, &prefix(self.name));
    }
}

/// A record out of a unit in every cycle.
pub(crate) trait OutputPorts<R: Record>: Sized {
    /// Drives the ports on the unit.
    fn drive(self, m: &mut Module, config: &R::Config, record: Wired<R>);

    /// Drives one of the record's bits in the cycle after `happens`.
    fn event(
        self,
        m: &mut Module,
        config: &R::Config,
        which: impl FnOnce(R::In<Places>) -> Option<usize>,
        happens: impl Into<Expr>,
    );

    /// Drives them in the cycle after; after reset they are zero.
    fn events(self, m: &mut Module, config: &R::Config, happens: Wired<R>);

    /// What an instance of the unit puts out.
    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Wired<R>;
}

impl<R: Record> OutputPorts<R> for Output<R> {
    fn event(
        self,
        m: &mut Module,
        config: &R::Config,
        which: impl FnOnce(R::In<Places>) -> Option<usize>,
        happens: impl Into<Expr>,
    ) {
        let place = which(places::<R>(config)).expect("a unit has the events that it tells of");
        let field = &fields::<R>(config)[place];
        let name = format!("{}{}", prefix(self.name), field.name);
        event_out(m, &name, happens);
        m.document(&name, field.doc);
    }

    fn drive(self, m: &mut Module, config: &R::Config, record: Wired<R>) {
        record.output(m, config, &prefix(self.name));
        documents::of_fields::<R>(m, config, self.name);
    }

    fn events(self, m: &mut Module, config: &R::Config, happens: Wired<R>) {
        let prefix = prefix(self.name);
        let registers: Vec<_> = happens
            .named(config)
            .map(|(name, value)| {
                let register = m.reg_reset(&format!("{prefix}{name}"), value.width(), 0);
                m.next(register, value);
                register.expr()
            })
            .collect();
        self.drive(m, config, Bundle::from_values(config, registers));
    }

    fn of(self, m: &mut Module, config: &R::Config, instance: Instance) -> Wired<R> {
        Bundle::shown_by(m, config, instance, &prefix(self.name))
    }
}

/// An integer into or out of a unit in every cycle.
pub(crate) trait WordPort: Copy {
    /// Its name.
    fn name(self) -> &'static str;

    /// What it is for.
    fn doc(self) -> &'static str;

    /// Declares it on the unit.
    fn declare_word(self, m: &mut Module, width: u32) -> Expr {
        let value = m.input(self.name(), width);
        m.document(self.name(), self.doc());
        value
    }

    /// Drives it on the unit.
    fn drive_word(self, m: &mut Module, value: impl Into<Expr>) {
        m.output(self.name(), value);
        m.document(self.name(), self.doc());
    }

    /// Drives it on the unit in the cycle after `happens`.
    fn event(self, m: &mut Module, happens: impl Into<Expr>) {
        event_out(m, self.name(), happens);
        m.document(self.name(), self.doc());
    }

    /// What an instance of the unit puts out.
    fn word_of(self, m: &mut Module, instance: Instance) -> Expr {
        m.out(instance, self.name())
    }

    /// Feeds an instance of the unit.
    fn feed_word(self, m: &mut Module, instance: Instance, value: impl Into<Expr>) {
        m.connect(instance, self.name(), value);
    }
}

impl<W> WordPort for Input<W> {
    fn name(self) -> &'static str {
        self.name
    }

    fn doc(self) -> &'static str {
        self.doc
    }
}

impl<W> WordPort for Output<W> {
    fn name(self) -> &'static str {
        self.name
    }

    fn doc(self) -> &'static str {
        self.doc
    }
}

/// An output that is set in the cycle after `happens`.
fn event_out(m: &mut Module, name: &str, happens: impl Into<Expr>) {
    let happened = m.reg_reset(name, 1, 0);
    m.next(happened, happens);
    m.output(name, happened);
}

/// A register that takes a value at clock edges where `enable` is set.
pub(crate) fn held(m: &mut Module, name: &str, enable: impl Into<Expr>, value: impl Into<Expr>) -> Expr {
    let value = value.into();
    let register = m.reg(name, value.width());
    m.next_if(register, enable, value);
    register.expr()
}
