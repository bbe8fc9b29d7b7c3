//! What the contract says of ports, which the Verilog says behind their declarations.

use pointcore_contract::unit::Group;
use pointcore_contract::{Record, fields};
use rtl::Module;

/// What stands before the names of a group's fields.
pub(in crate::units) fn prefix(name: &str) -> String {
    if name.is_empty() { String::new() } else { format!("{name}_") }
}

/// Says of the flag of declared ports what the group is for, and of each field what it holds.
pub(in crate::units) fn flagged<R: Record>(m: &mut Module, config: &R::Config, (name, flag): (&str, &str), doc: &str) {
    m.document(&format!("{}{flag}", prefix(name)), doc);
    of_fields::<R>(m, config, name);
}

/// Says of the field of each declared port what it holds.
pub(in crate::units) fn of_fields<R: Record>(m: &mut Module, config: &R::Config, name: &str) {
    for field in fields::<R>(config) {
        m.document(&format!("{}{}", prefix(name), field.name), field.doc);
    }
}

/// Says of the flag of a declared group, if it has one, what the group is for, and of each field what it holds.
pub(in crate::units) fn group(m: &mut Module, group: &Group) {
    if group.kind.has_flag() {
        m.document(&group.port_name(group.flag), group.doc);
    }
    group.fields.iter().for_each(|field| m.document(&group.port_name(&field.name), field.doc));
}
