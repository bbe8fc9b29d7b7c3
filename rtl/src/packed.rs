//! Streams whose fields share one port: modules that hold items without looking into them are one for all fields of a width.

use super::error::FaultKind;
use super::expression::{Expr, cat};
use super::handle::Wire;
use super::instance::Instance;
use super::module::Module;
use super::stream::Stream;

/// The port that holds all fields.
const DATA: &str = "data";

/// A stream whose fields come side by side.
#[derive(Clone, Copy)]
pub struct PackedStream {
    /// An item is there.
    pub valid: Expr,
    /// Its fields, the first on top.
    pub data: Expr,
    /// The consumer takes the item; to be driven once.
    pub ready: Wire,
}

impl PackedStream {
    /// The item moves in this cycle.
    #[must_use]
    #[track_caller]
    pub fn transfer(&self) -> Expr {
        self.valid & self.ready
    }
}

/// Fields that share a port.
pub(super) struct Packed {
    /// The port.
    port: String,
    /// What stands before the fields' names.
    prefix: String,
    /// Names and widths, the first on top.
    fields: Vec<(String, u32)>,
}

/// A field inside a port that several share.
struct Place {
    /// The port's place in its module.
    port: usize,
    /// The field's place, and the number of fields.
    position: usize,
    fields: usize,
    low: u32,
    width: u32,
}

impl Packed {
    fn width(&self) -> u32 {
        self.fields.iter().map(|(_, width)| width).sum()
    }
}

impl Module {
    /// Declares the ports of a stream that comes in with all fields in one port `<name>_data`, the first on top. Who places the module connects it field by field all the same.
    #[track_caller]
    pub fn packed_in(&mut self, name: &str, layout: &[(impl AsRef<str>, u32)]) -> PackedStream {
        let width = self.pack(name, layout);
        let Stream { valid, fields, ready } = self.stream_in(name, &[(DATA, width)]);
        PackedStream { valid, data: fields[0].1, ready }
    }

    /// Declares and drives the ports of a stream that goes out as [`Module::packed_in`] has it; returns the consumer's `ready`.
    #[track_caller]
    pub fn packed_out(
        &mut self,
        name: &str,
        valid: impl Into<Expr>,
        data: impl Into<Expr>,
        layout: &[(impl AsRef<str>, u32)],
    ) -> Expr {
        let data = data.into();
        let width = self.pack(name, layout);
        self.check_width(&format!("{name}_{DATA}"), width, data);
        self.stream_out(name, valid, [(DATA, data)])
    }

    #[track_caller]
    fn pack(&mut self, name: &str, layout: &[(impl AsRef<str>, u32)]) -> u32 {
        let fields = layout.iter().map(|(field, width)| (field.as_ref().to_string(), *width)).collect();
        self.packed.push(Packed { port: format!("{name}_{DATA}"), prefix: format!("{name}_"), fields });
        self.packed[self.packed.len() - 1].width()
    }

    /// Names of fields behind a prefix, of a stream that is packed.
    pub(super) fn packed_fields(&self, prefix: &str) -> Option<Vec<String>> {
        let packed = self.packed.iter().find(|packed| packed.prefix == prefix)?;
        Some(packed.fields.iter().map(|(field, _)| field.clone()).collect())
    }

    fn place(&self, name: &str) -> Option<Place> {
        self.packed.iter().find_map(|packed| {
            let field = name.strip_prefix(&packed.prefix)?;
            let position = packed.fields.iter().position(|(other, _)| other == field)?;
            let port = self.ports.iter().position(|port| port.shape(self).0 == packed.port)?;
            let low = packed.fields[position + 1..].iter().map(|(_, width)| width).sum();
            Some(Place { port, position, fields: packed.fields.len(), low, width: packed.fields[position].1 })
        })
    }

    fn place_in(&self, instance: Instance, name: &str) -> Option<Place> {
        self.child(instance)?.module.place(name)
    }

    /// Drives a field of a child's port; says whether there is one of that name.
    #[track_caller]
    pub(super) fn connect_field(&mut self, instance: Instance, name: &str, value: Expr) -> bool {
        let Some(place) = self.place_in(instance, name) else { return false };
        let full_name = format!("{}.{name}", instance.name());
        self.check_width(&full_name, place.width, value);
        let Some(child) = self.child_mut(instance) else { return false };
        let parts = child.parts.entry(place.port).or_insert_with(|| vec![None; place.fields]);
        if parts[place.position].replace(value).is_some() {
            self.fault(FaultKind::DoublyDriven(full_name));
            return true;
        }
        if let Some(parts) = parts.iter().copied().collect::<Option<Vec<Expr>>>() {
            child.inputs[place.port] = Some(cat(parts));
        }
        true
    }

    /// A field of a child's port, as a wire `<instance>_<name>`.
    #[track_caller]
    pub(super) fn field_of(&mut self, instance: Instance, name: &str) -> Option<Expr> {
        let place = self.place_in(instance, name)?;
        let child = self.child(instance)?;
        if let Some(&shown) = child.shown.get(name) {
            return Some(shown);
        }
        let signal = child.outputs[place.port]?;
        let data = self.signals[signal].reference;
        let field = data.bits(place.low + place.width - 1, place.low);
        let wire = format!("{}_{name}", instance.name());
        let shown =
            if field.width() == data.width() || self.names.contains(&wire) { field } else { self.wire(&wire, field) };
        self.child_mut(instance)?.shown.insert(name.into(), shown);
        Some(shown)
    }

    /// The name by which a child's input is missing: that of its first field without a driver, where it has fields.
    pub(super) fn missing_field(&self, port: &str, parts: Option<&Vec<Option<Expr>>>) -> String {
        let packed = self.packed.iter().find(|packed| packed.port == port);
        let missing = packed.and_then(|packed| {
            let first = parts.map_or(Some(0), |parts| parts.iter().position(Option::is_none))?;
            Some(format!("{}{}", packed.prefix, packed.fields.get(first)?.0))
        });
        missing.unwrap_or_else(|| port.to_string())
    }
}
