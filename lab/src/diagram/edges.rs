//! What passes between units, group by group, found by following flags and constants from port to port.

use std::collections::{BTreeMap, BTreeSet};

use pointcore_contract::Unit;
use pointcore_contract::unit::Group;
use rtl::{Link, Terminal};

/// Records that pass from one unit to another; an end that is `None` lies outside the core.
pub(super) struct Edge {
    pub from: Option<usize>,
    pub to: Option<usize>,
    /// The records' names.
    pub label: String,
}

/// The port by which a group is followed: its flag, or its first field.
fn leading_port(group: &Group) -> String {
    if group.kind.has_flag() {
        return group.port_name(group.flag);
    }
    group.port_name(group.fields.first().map_or("", |field| &field.name))
}

/// A group's place: the unit that has it, and what it carries.
struct Place {
    unit: Option<usize>,
    label: String,
    has_flag: bool,
}

fn label(group: &Group) -> String {
    match group.record {
        "bool" | "u8" | "u16" | "u32" | "u64" => group.name.replace('_', " "),
        record => record.to_owned(),
    }
}

/// The leading ports of all groups, by terminal. What a core reports of its last cycle is left out.
fn places<C>(core: &Unit<C>, units: &[&Unit<C>], config: &C) -> BTreeMap<Terminal, Place> {
    let of = |unit: &Unit<C>, place: Option<usize>| -> Vec<(Terminal, Place)> {
        let groups = (unit.interface)(config).groups.into_iter();
        let shown = groups.filter(|group| !group.fields.first().is_some_and(|field| field.name.starts_with("event_")));
        let shown = shown.filter(|group| !group.name.starts_with("event_"));
        let entry = |group: Group| {
            let terminal = Terminal { unit: place.map(|_| unit.module.to_owned()), port: leading_port(&group) };
            (terminal, Place { unit: place, label: label(&group), has_flag: group.kind.has_flag() })
        };
        shown.map(entry).collect()
    };
    let inner = units.iter().enumerate().flat_map(|(index, unit)| of(unit, Some(index)));
    inner.chain(of(core, None)).collect()
}

/// The edges of a core's diagram, those between the same units merged.
pub(super) fn edges<C>(links: &BTreeSet<Link>, core: &Unit<C>, units: &[&Unit<C>], config: &C) -> Vec<Edge> {
    let places = places(core, units, config);
    let mut merged: BTreeMap<(Option<usize>, Option<usize>), BTreeSet<&str>> = BTreeMap::new();
    for link in links {
        let (Some(from), Some(to)) = (places.get(&link.from), places.get(&link.to)) else { continue };
        if from.has_flag == to.has_flag && from.unit != to.unit {
            // What a unit receives is called as the unit that sends it calls it, or the core's port.
            let label = if from.unit.is_some() { &from.label } else { &to.label };
            merged.entry((from.unit, to.unit)).or_default().insert(label);
        }
    }
    let edge = |((from, to), labels): (_, BTreeSet<&str>)| {
        let labels: Vec<_> = labels.into_iter().collect();
        Edge { from, to, label: labels.join(", ") }
    };
    merged.into_iter().map(edge).collect()
}
