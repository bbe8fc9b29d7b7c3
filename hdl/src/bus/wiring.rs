//! What the tops share: a unit's bus becomes the top's, a unit's record the next one's.

use pointcore_spec::core_a::{Direction, Field, Port};

use crate::rtl::{Expr, Instance, Module, Stream};
use crate::units::records::Record;

/// Leads the ports `<from>_…` of a unit out as `<to>_…`.
pub(super) fn export(m: &mut Module, unit: &Instance, ports: &[Port], from: &str, to: &str) {
    for port in ports {
        let Some(rest) = port.name.strip_prefix(from).filter(|rest| rest.starts_with('_')) else { continue };
        let name = format!("{to}{rest}");
        match port.direction {
            Direction::Input => {
                let value = m.input(&name, port.width as usize);
                m.connect(unit, &port.name, &value);
            }
            Direction::Output => {
                let value = m.out(unit, &port.name);
                m.output(&name, &value);
            }
        }
    }
}

/// Leads a stream from one unit to the next.
pub(super) fn pipe(m: &mut Module, (from, out): (&Instance, &str), (to, input): (&Instance, &str)) {
    let stream = m.stream_from(from, out);
    m.stream_into(to, input, &stream);
}

/// Leads a stream into a unit, other than field by field; it moves only while `gate` is set.
pub(super) fn feed(m: &mut Module, stream: &Stream, (to, input): (&Instance, &str), gate: &Expr, fields: &Record) {
    m.connect(to, &format!("{input}_valid"), &(&stream.valid & gate));
    fields.connect(m, to, &format!("{input}_"));
    let ready = m.out(to, &format!("{input}_ready"));
    m.ready(stream, &(ready & gate));
}

/// The fields of a request to a reader.
pub(super) fn request(address: Expr, records: Expr) -> Record {
    let fields: [Field; 2] = [("address".to_owned(), 0), ("records".to_owned(), 0)];
    Record::new(&fields, |name| if name == "address" { address.clone() } else { records.clone() })
}
