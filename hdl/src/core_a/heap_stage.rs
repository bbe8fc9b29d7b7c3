//! A stage of the pipelined heap: two neighboring levels, which take turns at one set of memories, comparators and registers.
//!
//! Two memories hold the left and the right child of every parent. A step meets the children of one parent in three cycles:
//! *look* (the memories show the children; the one it goes on with is *chosen*, the other its *rival*), *compare* (from
//! registers, while the level below looks), and *settle* (the chosen child's place is rewritten, with what rises from below
//! where there is a hole). Steps begin every second cycle, so one looks while its predecessor settles at the same level and
//! finds, past the memory, all that the memory does not hold yet.
//!
//! Which child is first is stored with the children: the parity of their marks. So a removal knows its way as soon as the
//! memories show them, and the comparison that decides it anew has a cycle of its own.

use pointcore_spec::core_a::{Config, Field};

use super::heap_order::{EntryFormat, Order};
use crate::rtl::{Expr, Module, Reg, bit, cat, lit};
use crate::units::records::{Record, width};

/// Where a stage stands in the heap.
#[derive(Clone, Copy)]
pub(super) struct Place {
    format: EntryFormat,
    levels: usize,
    /// The upper one of its levels.
    upper: usize,
}

impl Place {
    pub fn new(config: &Config, upper: usize) -> Self {
        Self { format: EntryFormat::new(config), levels: config.heap_levels as usize, upper }
    }

    /// Nodes of the lower level have children.
    fn continues(self) -> bool {
        self.upper + 2 < self.levels
    }

    /// The lower level is one of the heap's.
    fn has_lower(self) -> bool {
        self.upper + 1 < self.levels
    }

    /// Bits of the number of entries on a node's left; none at the last level.
    fn count_bits(self) -> usize {
        self.levels - 1 - self.upper
    }

    /// A stored node: an entry, its mark, and what lies below it.
    fn node(self) -> Vec<Field> {
        let widths =
            [("entry", self.format.width()), ("mark", 1), ("right_below", 1), ("left_count", self.count_bits())];
        fields(&widths[..if self.has_lower() { 4 } else { 2 }])
    }
}

fn fields(widths: &[(&str, usize)]) -> Vec<Field> {
    widths.iter().map(|(name, width)| ((*name).to_owned(), *width as u32)).collect()
}

/// What a step brings to a level, where it meets the two children of a parent.
pub(super) fn step_fields(format: EntryFormat) -> Vec<Field> {
    fields(&[
        ("valid", 1),
        // The parent's entry is gone: the first of the children and the carried entry takes its place.
        // Otherwise the carried entry is inserted below the parent.
        ("hole", 1),
        // An entry is carried, as by every insertion.
        ("carry", 1),
        // Where an insertion goes on.
        ("right", 1),
        ("left_exists", 1),
        ("right_exists", 1),
        // The step before this one came by here if it came that deep.
        ("follows", 1),
        ("entry", format.width()),
        // The key of the parent's rival.
        ("rival", format.key_width()),
    ])
}

/// What a level says of the step it compares, to the level that settles it.
pub(super) const RISE: [&str; 6] = ["entry", "exists", "ahead", "right", "childless", "node"];

/// Registers that take new values in every cycle.
struct Registers(Vec<(String, Reg)>);

impl Registers {
    /// Registers `<prefix><field>`; the field `valid` is reset.
    fn new(m: &mut Module, prefix: &str, fields: &[Field]) -> Self {
        let mut register = |name: &str, width: u32| {
            let full = format!("{prefix}{name}");
            if name == "valid" { m.reg_reset(&full, 1, 0) } else { m.reg(&full, width as usize) }
        };
        Self(fields.iter().map(|(name, width)| (name.clone(), register(name, *width))).collect())
    }

    fn get(&self, name: &str) -> Expr {
        let field = self.0.iter().find(|(field, _)| field == name);
        field.map(|(_, register)| register.expr()).expect("stages ask for registers of their own")
    }

    fn next(&self, m: &mut Module, mut value: impl FnMut(&str) -> Expr) {
        for (name, register) in &self.0 {
            m.next(register, &value(name));
        }
    }
}

/// The stage whose upper level is `upper`; `lower` is set in cycles where its lower level looks.
pub(super) fn module(config: &Config, upper: usize) -> Module {
    let place = Place::new(config, upper);
    let Place { format, levels, .. } = place;
    let mut m = Module::new("core_a_heap_stage", "Two neighboring levels of the pipelined heap.");
    m.parameter("level", upper);
    m.parameter("levels", levels);
    let order = Order { format, sweep: m.input("sweep", 1), last_epoch: m.input("last_epoch", 1) };
    let lower = m.input("lower", 1);
    let above = Record::input(&mut m, "step_", &step_fields(format));
    let row_bits = upper + 1;
    let above_row = if upper > 0 { m.input("step_row", upper).zext(row_bits) } else { lit(row_bits, 0) };
    let node_fields = place.node();

    let mut compared_fields = fields(&[
        ("valid", 1),
        ("hole", 1),
        ("carry", 1),
        ("follows", 1),
        ("carried", format.width()),
        ("exists", 1),
        ("right", 1),
        ("was_first", 1),
        ("parent_rival", format.key_width()),
        ("chosen_stored", 1),
        ("rival_stored", 1),
        ("rival", format.key_width()),
        ("rival_exists", 1),
        ("rival_mark", 1),
        ("entry", format.width()),
    ]);
    let mut settled_fields = fields(&[
        ("valid", 1),
        ("hole", 1),
        ("carry", 1),
        ("existed", 1),
        ("ahead", 1),
        ("rival_exists", 1),
        ("rival_mark", 1),
        ("entry", format.width()),
    ]);
    compared_fields.extend(node_fields[2..].to_vec());
    settled_fields.extend(node_fields[2..].to_vec());
    let compared = Registers::new(&mut m, "compared_", &compared_fields);
    let settled = Registers::new(&mut m, "settled_", &settled_fields);
    let row = m.reg("row", row_bits);
    let row_before = m.reg("row_before", row_bits);
    m.next(&row_before, &row);

    // Compare.
    let has_below = place.has_lower();
    let exists = compared.get("exists");
    let stored = m.reg("stored", width(&node_fields));
    let stored_node = Record::unpack(&node_fields, &stored);
    let (chosen_stored, rival_stored) = (compared.get("chosen_stored"), compared.get("rival_stored"));
    let current = |m: &mut Module, name: &str| {
        let value = chosen_stored.mux(&stored_node.get(name), &compared.get(name));
        m.wire(&format!("chosen_{name}"), &value)
    };
    let chosen = current(&mut m, "entry");
    let rival = m.wire("rival", &rival_stored.mux(&format.key(&stored_node.get("entry")), &compared.get("rival")));
    let rival_mark = m.wire("rival_mark", &rival_stored.mux(&stored_node.get("mark"), &compared.get("rival_mark")));
    let carried = if upper > 0 {
        compared.get("carried")
    } else {
        // The sweep of a newcomer is known only now.
        let newcomer_sweep = m.input("newcomer_sweep", 1);
        let carried = compared.get("carried");
        cat(&[&lower.mux(&newcomer_sweep, &carried.msb()), &carried.trunc(format.width() - 1)])
    };
    let carried_key = format.key(&carried);
    let before_chosen = m.wire("before_chosen", &order.before(&carried_key, &format.key(&chosen)));
    let before_rival = m.wire("before_rival", &order.before(&carried_key, &rival));
    let carried_first = m.wire("carried_first", &(compared.get("carry") & (!&exists | &before_chosen)));
    let first = m.wire("first", &carried_first.mux(&carried, &chosen));
    let last = carried_first.mux(&chosen, &carried);
    let below = has_below.then(|| [current(&mut m, "right_below"), current(&mut m, "left_count")]);
    let (left_below, right_below, left_full) = match &below {
        Some([right_below, count]) => {
            let low_full = if count.width() > 1 { count.trunc(count.width() - 1).all() } else { bit(true) };
            (count.any(), right_below.clone(), low_full & (count.msb() | !&lower))
        }
        None => (bit(false), bit(false), bit(false)),
    };
    let any_below = &left_below | &right_below;
    let own = Record::new(&step_fields(format), |name| match name {
        "valid" => compared.get("valid") & &exists,
        "hole" | "carry" | "follows" => compared.get(name),
        "right" => left_full.clone(),
        "left_exists" => left_below.clone(),
        "right_exists" => right_below.clone(),
        "entry" => last.clone(),
        _ => rival.clone(),
    });

    // Settle.
    let rise = fields(&[("entry", format.width()), ("exists", 1), ("ahead", 1), ("right", 1), ("childless", 1)]);
    let ahead_of_rival = {
        let rival_first = order.before(&compared.get("parent_rival"), &format.key(&chosen));
        m.wire("ahead_of_rival", &(&exists & !rival_first))
    };
    let own_rise = Record::new(&rise, |name| match name {
        "entry" => first.clone(),
        "exists" => exists.clone(),
        "ahead" => ahead_of_rival.clone(),
        "right" => compared.get("right"),
        _ => !&any_below,
    });
    let hole = settled.get("hole");
    let next_row = m.forward("next_row", row_bits + 1);
    let (risen, entry, node) = if place.continues() {
        let below = Record::input(&mut m, "below_rise_", &rise);
        let below_node = m.input("below_rise_node", row_bits + 1);
        let risen = below.mux(&lower, &own_rise);
        let entry = hole.mux(&risen.get("entry"), &settled.get("entry"));
        (risen, entry, lower.mux(&below_node, &row_before.zext(row_bits + 1)))
    } else {
        let risen = Record::zeros(&rise).mux(&lower, &own_rise);
        let entry = (&hole & !&lower).mux(&first, &settled.get("entry"));
        let node = if has_below {
            let below = m.reg("below_row", row_bits + 1);
            let below_before = m.reg("below_row_before", row_bits + 1);
            m.next(&below, &next_row);
            m.next(&below_before, &below);
            lower.mux(&below_before, &row_before.zext(row_bits + 1))
        } else {
            row_before.zext(row_bits + 1)
        };
        (risen, entry, node)
    };
    let side = m.wire("side", &node.bit(0));
    let settled_entry = m.wire("entry_to_store", &entry);
    let (rival_exists, ahead, carry) = (settled.get("rival_exists"), settled.get("ahead"), settled.get("carry"));
    let risen_exists = risen.get("exists");
    let hole_first = (&carry | &risen_exists) & ((!&rival_exists | &ahead) | risen.get("ahead"));
    let is_first = m.wire("settled_first", &hole.mux(&hole_first, &ahead));
    let first_side = m.wire("first_side", &(&side ^ !&is_first));
    let mark = &first_side ^ (&rival_exists & settled.get("rival_mark"));
    let existed = settled.get("existed");
    let leaves = (&hole & !&carry) & &risen_exists;
    let settled_node = Record::new(&node_fields, |name| match name {
        "entry" => settled_entry.clone(),
        "mark" => mark.clone(),
        "right_below" => {
            let gone = &leaves & (risen.get("right") & risen.get("childless"));
            let come = !&hole & (&existed & risen.get("right"));
            (settled.get(name) & !gone) | come
        }
        _ => {
            let count = settled.get(name);
            let down = &leaves & !risen.get("right");
            let up = !&hole & (&existed & !risen.get("right"));
            let one = &down | &up;
            let step = match count.width() {
                1 => one,
                width => cat(&[&down.repeat(width - 1), &one]),
            };
            &count + step
        }
    });
    let settled_node = m.wire("node_to_store", &settled_node.pack());
    m.next(&stored, &settled_node);

    // Look.
    let step = own.mux(&lower, &above);
    let address_bits = row_bits.min(levels - 1);
    let presented = lower.mux(&above_row, &next_row.trunc(row_bits));
    m.next(&row, &presented);
    let bypass = m.wire("bypass", &(step.get("follows") & settled.get("valid")));
    let mut child = |name: &str, side: Expr| {
        let memory = m.memory(&format!("{name}_nodes"), 1 << address_bits, settled_node.width());
        let address = node.bits(row_bits, 1).trunc(address_bits);
        m.write(&memory, &(settled.get("valid") & side), &address, &settled_node);
        let stored = m.read(&memory, &format!("{name}_stored"), &presented.trunc(address_bits));
        Record::unpack(&node_fields, &stored)
    };
    let (left, right) = (child("left", !&side), child("right", side.clone()));
    let (left_exists, right_exists) = (step.get("left_exists"), step.get("right_exists"));
    let both = m.wire("both_exist", &(&left_exists & &right_exists));
    let stored_first = left.get("mark") ^ right.get("mark");
    let goes_first = bypass.mux(&first_side, &stored_first);
    let goes_right =
        m.wire("goes_right", &step.get("hole").mux(&both.mux(&goes_first, &right_exists), &step.get("right")));
    m.drive(&next_row, &cat(&[&row, &goes_right]));
    let to_settled = m.wire("to_settled", &(&goes_right ^ !&side));
    let pick = |name: &str, right_one: &Expr| right_one.mux(&right.get(name), &left.get(name));
    let stays_left = !&goes_right;
    let follows = step.get("follows") & &to_settled;
    compared.next(&mut m, |name| match name {
        "valid" | "hole" | "carry" => step.get(name),
        "follows" => follows.clone(),
        "carried" => step.get("entry"),
        "exists" => goes_right.mux(&right_exists, &left_exists),
        "rival_exists" => goes_right.mux(&left_exists, &right_exists),
        "right" => goes_right.clone(),
        "was_first" => goes_right.eq(&both.mux(&goes_first, &right_exists)),
        "parent_rival" => step.get("rival"),
        "chosen_stored" => &bypass & &to_settled,
        "rival_stored" => &bypass & !&to_settled,
        "rival" => format.key(&pick("entry", &stays_left)),
        "rival_mark" => pick("mark", &stays_left),
        _ => pick(name, &goes_right),
    });
    // Where nothing lies below, a hole is filled with the carried entry.
    let fills_leaf = if !place.continues() && has_below { compared.get("hole") & !&lower } else { bit(false) };
    let kept = (&carried_first ^ fills_leaf).mux(&carried, &chosen);
    settled.next(&mut m, |name| match name {
        "valid" => compared.get("valid") & (&exists | !compared.get("hole")),
        "hole" | "carry" | "rival_exists" => compared.get(name),
        "rival_mark" => rival_mark.clone(),
        "existed" => exists.clone(),
        "ahead" => {
            let inserted = &carried_first & (&before_rival | !compared.get("rival_exists"));
            let stays = &exists & compared.get("was_first");
            compared.get("hole").mux(&(compared.get("carry") & &before_rival), &(stays | inserted))
        }
        "entry" => kept.clone(),
        _ => {
            let [right, count] = below.as_ref().expect("these fields are there where nodes have children");
            let value = if name == "right_below" { right } else { count };
            value & exists.repeat(value.width())
        }
    });

    if upper == 0 {
        m.output("root", &bypass.mux(&settled_entry, &right.get("entry")));
    } else {
        let rises = Record::new(&rise, |name| own_rise.get(name));
        rises.output(&mut m, "rise_");
        m.output("rise_node", &row_before.trunc(upper));
    }
    if place.continues() {
        own.output(&mut m, "below_");
        m.output("below_row", &next_row);
    }
    m
}
