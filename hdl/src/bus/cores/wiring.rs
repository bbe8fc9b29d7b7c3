//! What the tops share: a unit's bus becomes the top's, a unit's record the next one's.

use pointcore_contract::splat::{Direction, Field, Port};

use crate::bus::ADDRESS_BITS;
use crate::units::records::Record;
use rtl::{Expr, Instance, Module, Stream, cat, lit};

/// Leads the ports `<from>_…` of a unit out as `<to>_…`.
pub(super) fn export(m: &mut Module, unit: Instance, ports: &[Port], from: &str, to: &str) {
    for port in ports {
        let Some(rest) = port.name.strip_prefix(from).filter(|rest| rest.starts_with('_')) else { continue };
        let name = format!("{to}{rest}");
        match port.direction {
            Direction::Input => {
                let value = m.input(&name, port.width);
                m.connect(unit, &port.name, value);
            }
            Direction::Output => {
                let value = m.out(unit, &port.name);
                m.output(&name, value);
            }
        }
    }
}

/// Leads a stream into a unit, other than field by field; it moves only while `gate` is set.
pub(super) fn feed(m: &mut Module, stream: &Stream, (to, input): (Instance, &str), gate: Expr, fields: &Record) {
    m.connect(to, &format!("{input}_valid"), stream.valid & gate);
    fields.connect(m, to, &format!("{input}_"));
    let ready = m.out(to, &format!("{input}_ready"));
    m.ready(stream, ready & gate);
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

/// The fields of a request to a reader.
pub(super) fn request(address: Expr, records: Expr) -> Record {
    let fields: [Field; 2] = [("address".to_owned(), 0), ("records".to_owned(), 0)];
    Record::new(&fields, |name| if name == "address" { address } else { records })
}
