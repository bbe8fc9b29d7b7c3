//! A level of the pipelined heap below the root: two memories hold the left and the right child of every parent.
//!
//! A step is presented in one cycle and decided in the next, when it also goes on to the level below while the child that
//! rises goes to the level above. A cycle later the child that rises from below completes the node to be rewritten,
//! `pending`, which later steps read past the memory until it is written. Steps come every second cycle at most, so the
//! pending node is all that a step can find outdated in the memory. Nodes count the entries below them, left and right:
//! that tells which children exist, and no memory needs a first content.

use pointcore_spec::core_a::{Config, Field};

use super::heap_order::{EntryFormat, Order};
use super::records::Record;
use crate::rtl::{Expr, Memory, Module, address_width, cat, lit};

/// Parents of the nodes of a level.
const fn parents(level: usize) -> usize {
    1 << (level - 1)
}

/// What an operation brings to a level, where it meets the two children of one parent.
pub(super) fn step_fields(config: &Config, level: usize) -> Vec<Field> {
    let fields = [
        // The parent's entry is gone; the first of the children and the carried entry takes its place.
        // Otherwise the carried entry is inserted below the parent.
        ("hole", 1),
        // An entry is carried, as by every insertion.
        ("carry", 1),
        ("entry", EntryFormat::new(config).width()),
        // Which parent.
        ("index", address_width(parents(level))),
        // Where an insertion goes on: set for the right child.
        ("right", 1),
        ("left_exists", 1),
        ("right_exists", 1),
    ];
    fields.map(|(name, width)| (name.to_owned(), width as u32)).to_vec()
}

/// The child that takes the parent's place.
pub(super) const RISE: [&str; 3] = ["rise_valid", "rise_right", "rise_entry"];

/// Entries below a node, on each side.
#[derive(Clone)]
pub(super) struct Counts {
    pub left: Expr,
    pub right: Expr,
}

impl Counts {
    /// Bits of a count at that level, below which lie `levels − 1 − level` more.
    pub const fn width(levels: usize, level: usize) -> usize {
        levels - 1 - level
    }

    /// Whether an insertion goes right: it goes left as long as there is room.
    pub fn goes_right(&self) -> Expr {
        self.left.all()
    }

    /// One more on the side where an insertion goes.
    pub fn inserted(&self) -> Self {
        let (right, width) = (self.goes_right(), self.left.width());
        Self { left: &self.left + (!&right).resize(width), right: &self.right + right.resize(width) }
    }

    /// One less on one side where `enable` is set.
    pub fn removed(&self, enable: &Expr, right: &Expr) -> Self {
        let width = self.left.width();
        let left = enable & !right;
        Self { left: &self.left - left.resize(width), right: &self.right - (enable & right).resize(width) }
    }
}

/// A node that was rewritten last, and whether it still has to reach the memory.
struct Pending {
    write: Expr,
    index: Expr,
    right: Expr,
    node: Expr,
}

/// The children of one parent.
struct Pair {
    left: Expr,
    right: Expr,
}

/// The memories with their bypass: the pair of `index` in the cycle after `read`.
fn pair(m: &mut Module, pending: &Pending, parents: usize, read: &Expr, index: &Expr, held_index: &Expr) -> Pair {
    let bypass = m.wire("bypass", &pending.index.eq(held_index));
    let mut child = |name: &str, side: Expr| {
        let memory: Memory = m.memory(&format!("{name}_nodes"), parents.max(2), pending.node.width());
        m.write(&memory, &(&pending.write & &side), &pending.index, &pending.node);
        let stored = m.read_if(&memory, &format!("{name}_stored"), read, index);
        m.wire(&format!("{name}_node"), &(&bypass & &side).mux(&pending.node, &stored))
    };
    Pair { left: child("left", !&pending.right), right: child("right", pending.right.clone()) }
}

/// Level `level` ≥ 1 of a heap.
pub(super) fn module(config: &Config, level: usize) -> Module {
    let levels = config.heap_levels as usize;
    let format = EntryFormat::new(config);
    let entry_bits = format.width();
    let count_bits = Counts::width(levels, level);

    let mut m =
        Module::new("core_a_heap_level", "A level of the pipelined heap: left and right child of every parent.");
    m.parameter("level", level);
    m.parameter("levels", levels);
    let order = Order { format, current: m.input("current", format.tile), last_epoch: m.input("last_epoch", 1) };
    let presented_valid = m.input("step_valid", 1);
    let presented = Record::input(&mut m, "step_", &step_fields(config, level));
    let valid = m.reg_reset("valid", 1, 0);
    m.next(&valid, &presented_valid);
    let step = presented.register(&mut m, "held_", &presented_valid);
    let (hole, carry, entry) = (step.get("hole"), step.get("carry"), step.get("entry"));

    let pending_write = m.reg_reset("pending_write", 1, 0);
    let pending_index = m.reg("pending_index", step.get("index").width());
    let pending_right = m.reg("pending_right", 1);
    let pending_node = m.reg("pending_node", entry_bits + 2 * count_bits);
    let pending = Pending {
        write: pending_write.expr(),
        index: pending_index.expr(),
        right: pending_right.expr(),
        node: pending_node.expr(),
    };
    let index = presented.get("index");
    let Pair { left, right } = pair(&mut m, &pending, parents(level), &presented_valid, &index, &step.get("index"));

    // The decision: the first of the children, or the one on the insertion's way, against the carried entry.
    let entry_of = |node: &Expr| node.bits(node.width() - 1, 2 * count_bits);
    let (left_entry, right_entry) = (entry_of(&left), entry_of(&right));
    let (left_exists, right_exists) = (step.get("left_exists"), step.get("right_exists"));
    let right_first = &right_exists & (!&left_exists | order.before(&right_entry, &left_entry));
    let chosen_right = m.wire("chosen_right", &hole.mux(&right_first, &step.get("right")));
    let chosen = m.wire("chosen", &chosen_right.mux(&right, &left));
    let chosen_entry = entry_of(&chosen);
    let exists = m.wire("exists", &chosen_right.mux(&right_exists, &left_exists));
    let before_carried = chosen_right.mux(&order.before(&right_entry, &entry), &order.before(&left_entry, &entry));
    let child_first = m.wire("child_first", &(&exists & &before_carried));
    let rises = m.wire("rises", &(&(&valid & &hole) & &(&exists & &(!&carry | &child_first))));
    for (name, value) in RISE.iter().zip([&rises, &chosen_right, &chosen_entry]) {
        m.output(name, value);
    }

    // The node to be rewritten: with the carried entry, unless the child stays or another rises from below.
    let update_valid = m.reg_reset("update_valid", 1, 0);
    m.next(&update_valid, &(&rises | (&valid & !&hole)));
    let mut update = |name: &str, value: &Expr| {
        let register = m.reg(&format!("update_{name}"), value.width());
        m.next_if(&register, &valid, value);
        register.expr()
    };
    let update_carry = update("carry", &carry);
    let update_index = update("index", &step.get("index"));
    let update_right = update("right", &chosen_right);
    let stays = &child_first & !&hole;
    let update_entry = update("entry", &stays.mux(&chosen_entry, &entry));

    let write;
    let node;
    if count_bits == 0 {
        write = &update_valid & &update_carry;
        node = update_entry;
    } else {
        let counts = Counts { left: chosen.bits(2 * count_bits - 1, count_bits), right: chosen.trunc(count_bits) };
        let inserted = counts.inserted();
        let next_count = |count: &Expr, inserted: &Expr| exists.mux(&hole.mux(count, inserted), &lit(count_bits, 0));
        let update_counts = Counts {
            left: update("left_count", &next_count(&counts.left, &inserted.left)),
            right: update("right_count", &next_count(&counts.right, &inserted.right)),
        };
        m.output("below_valid", &(&rises | (&valid & (!&hole & &exists))));
        let below = Record::new(&step_fields(config, level + 1), |name| match name {
            "hole" => hole.clone(),
            "carry" => carry.clone(),
            "entry" => (&hole | &child_first).mux(&entry, &chosen_entry),
            "index" if level == 1 => chosen_right.clone(),
            "index" => cat(&[&step.get("index"), &chosen_right]),
            "right" => counts.goes_right(),
            "left_exists" => counts.left.any(),
            _ => counts.right.any(),
        });
        below.output(&mut m, "below_");
        let [rise_valid, rise_right, rise_entry] = [("valid", 1), ("right", 1), ("entry", entry_bits)]
            .map(|(name, bits)| m.input(&format!("below_rise_{name}"), bits));
        write = &update_valid & (&update_carry | &rise_valid);
        let counts = update_counts.removed(&(&rise_valid & !&update_carry), &rise_right);
        node = cat(&[&rise_valid.mux(&rise_entry, &update_entry), &counts.left, &counts.right]);
    }
    m.next(&pending_write, &write);
    m.next_if(&pending_index, &write, &update_index);
    m.next_if(&pending_right, &write, &update_right);
    m.next_if(&pending_node, &write, &node);
    m
}
