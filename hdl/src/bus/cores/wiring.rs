//! What the tops share: a unit's bus becomes the top's, a unit's record the next one's.

use pointcore_contract::Direction;
use pointcore_contract::bus::Bus;

use crate::bus::ADDRESS_BITS;
use rtl::{Expr, Instance, Module, Wire, cat, lit};

/// Leads a bus, which a unit calls `from`, out as `to`.
pub(super) fn export(m: &mut Module, unit: Instance, bus: Bus, from: &str, to: &str) {
    for (own, outer) in bus.ports(from).into_iter().zip(bus.ports(to)) {
        match own.direction {
            Direction::Input => {
                let value = m.input(&outer.name, outer.width);
                m.connect(unit, &own.name, value);
            }
            Direction::Output => {
                let value = m.out(unit, &own.name);
                m.output(&outer.name, value);
            }
        }
    }
}

/// Leads a stream into a unit, other than field by field; it moves only while `gate` is set.
pub(super) fn feed(
    m: &mut Module,
    (valid, stream_ready): (Expr, Wire),
    (to, input): (Instance, &str),
    gate: Expr,
    fields: impl IntoIterator<Item = (impl AsRef<str>, Expr)>,
) {
    m.connect(to, &format!("{input}_valid"), valid & gate);
    for (name, value) in fields {
        m.connect(to, &format!("{input}_{}", name.as_ref()), value);
    }
    let ready = m.out(to, &format!("{input}_ready"));
    m.drive(stream_ready, ready & gate);
}

/// Leads outputs of a unit to inputs of another that have other names.
pub(super) fn join(m: &mut Module, to: Instance, signals: &[(Instance, &str, &str)]) {
    for (from, output, input) in signals {
        let value = m.out(*from, output);
        m.connect(to, input, value);
    }
}

/// Tells the registers what packets did and what happened in the core, and leads out their interrupt.
pub(super) fn report(
    m: &mut Module,
    control: Instance,
    core: Instance,
    [receiver, sender]: [Instance; 2],
    events: impl IntoIterator<Item = impl AsRef<str>>,
) {
    let packets =
        [(receiver, "refused", "packet_error"), (receiver, "taken", "packet_taken"), (sender, "sent", "packet_sent")];
    join(m, control, &packets);
    for event in events {
        join(m, control, &[(core, event.as_ref(), event.as_ref())]);
    }
    let irq = m.out(control, "irq");
    m.output("irq", irq);
}

/// An index times a stride, from a base.
pub(super) fn place(base: Expr, index: Expr, stride_bits: u32) -> Expr {
    base + cat([index, lit(stride_bits, 0)]).resize(ADDRESS_BITS)
}
