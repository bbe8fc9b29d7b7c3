//! A level of the pipelined heap below the root: two memories hold the left and the right child of every parent.
//!
//! A step is presented in one cycle and decided in the next, when it also goes on to the level below while the child that
//! rises goes to the level above. A cycle later the child that rises from below completes the node to be rewritten,
//! `pending`, which later steps read past the memory until it is written. Steps come every second cycle at most, so the
//! pending node is all that a step can find outdated in the memory. Nodes count the entries below them, left and right:
//! that tells which children exist, and no memory needs a first content.

use pointcore_spec::core_a::{Config, Field};

use super::heap_order::{EntryFormat, Order};
use crate::rtl::{Expr, Module, Reg, address_width, cat, lit};
use crate::units::records::Record;

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

/// The node that was rewritten last, and whether it still has to reach the memory.
struct Pending {
    write: Reg,
    index: Reg,
    right: Reg,
    node: Reg,
}

impl Pending {
    fn new(m: &mut Module, index_bits: usize, node_bits: usize) -> Self {
        Self {
            write: m.reg_reset("pending_write", 1, 0),
            index: m.reg("pending_index", index_bits),
            right: m.reg("pending_right", 1),
            node: m.reg("pending_node", node_bits),
        }
    }

    /// Takes a node that is to be rewritten.
    fn take(&self, m: &mut Module, write: &Expr, update: &Update, node: &Expr) {
        m.next(&self.write, write);
        m.next_if(&self.index, write, &update.index);
        m.next_if(&self.right, write, &update.right);
        m.next_if(&self.node, write, node);
    }
}

/// A step in the cycle after it was presented, when the children it meets are known.
struct Held {
    valid: Reg,
    step: Record,
    left: Expr,
    right: Expr,
}

impl Held {
    fn new(m: &mut Module, config: &Config, level: usize, pending: &Pending) -> Self {
        let presented_valid = m.input("step_valid", 1);
        let presented = Record::input(m, "step_", &step_fields(config, level));
        let valid = m.reg_reset("valid", 1, 0);
        m.next(&valid, &presented_valid);
        let step = presented.register(m, "held_", &presented_valid);

        // The memories, and past them the node that has not reached them yet.
        let bypass = m.wire("bypass", &pending.index.eq(&step.get("index")));
        let mut child = |name: &str, side: Expr| {
            let memory = m.memory(&format!("{name}_nodes"), parents(level).max(2), pending.node.width());
            m.write(&memory, &(&pending.write & &side), &pending.index, &pending.node);
            let stored = m.read_if(&memory, &format!("{name}_stored"), &presented_valid, &presented.get("index"));
            m.wire(&format!("{name}_node"), &(&bypass & &side).mux(&pending.node, &stored))
        };
        let (left, right) = (child("left", !&pending.right), child("right", pending.right.expr()));
        Self { valid, step, left, right }
    }
}

/// One child against the carried entry: the first of both children where there is a hole, else that on an insertion's way.
struct Decision {
    right: Expr,
    entry: Expr,
    counts: Option<Counts>,
    exists: Expr,
    /// The child leaves before the carried entry.
    first: Expr,
    /// The child takes the parent's place.
    rises: Expr,
}

impl Decision {
    fn new(m: &mut Module, held: &Held, order: &Order, count_bits: usize) -> Self {
        let Held { valid, step, left, right } = held;
        let (hole, carry, entry) = (step.get("hole"), step.get("carry"), step.get("entry"));
        let entry_of = |node: &Expr| node.bits(node.width() - 1, 2 * count_bits);
        let (left_entry, right_entry) = (entry_of(left), entry_of(right));
        let (left_exists, right_exists) = (step.get("left_exists"), step.get("right_exists"));
        let right_first = &right_exists & (!&left_exists | order.before(&right_entry, &left_entry));
        let chosen_right = m.wire("chosen_right", &hole.mux(&right_first, &step.get("right")));
        let chosen = m.wire("chosen", &chosen_right.mux(right, left));
        let exists = m.wire("exists", &chosen_right.mux(&right_exists, &left_exists));
        let before_carried = chosen_right.mux(&order.before(&right_entry, &entry), &order.before(&left_entry, &entry));
        let first = m.wire("child_first", &(&exists & &before_carried));
        let rises = m.wire("rises", &((valid & &hole) & (&exists & (!&carry | &first))));
        let counts = (count_bits > 0)
            .then(|| Counts { left: chosen.bits(2 * count_bits - 1, count_bits), right: chosen.trunc(count_bits) });
        Self { right: chosen_right, entry: entry_of(&chosen), counts, exists, first, rises }
    }

    /// Presents the step to the level below.
    fn pass_on(&self, m: &mut Module, config: &Config, level: usize, held: &Held, counts: &Counts) {
        let (hole, entry) = (held.step.get("hole"), held.step.get("entry"));
        m.output("below_valid", &(&self.rises | (&held.valid & (!&hole & &self.exists))));
        let below = Record::new(&step_fields(config, level + 1), |name| match name {
            "hole" => hole.clone(),
            "carry" => held.step.get("carry"),
            "entry" => (&hole | &self.first).mux(&entry, &self.entry),
            // The first level's one parent has an index that says nothing.
            "index" if level == 1 => self.right.clone(),
            "index" => cat(&[&held.step.get("index"), &self.right]),
            "right" => counts.goes_right(),
            "left_exists" => counts.left.any(),
            _ => counts.right.any(),
        });
        below.output(m, "below_");
    }
}

/// The node to be rewritten, in the cycle after the decision: with the carried entry, unless the child stays or another
/// rises from below.
struct Update {
    valid: Reg,
    carry: Expr,
    index: Expr,
    right: Expr,
    entry: Expr,
    counts: Option<Counts>,
}

impl Update {
    fn new(m: &mut Module, held: &Held, decision: &Decision) -> Self {
        let hole = held.step.get("hole");
        let valid = m.reg_reset("update_valid", 1, 0);
        m.next(&valid, &(&decision.rises | (&held.valid & !&hole)));
        let mut update = |name: &str, value: &Expr| {
            let register = m.reg(&format!("update_{name}"), value.width());
            m.next_if(&register, &held.valid, value);
            register.expr()
        };
        let stays = &decision.first & !&hole;
        Self {
            valid,
            carry: update("carry", &held.step.get("carry")),
            index: update("index", &held.step.get("index")),
            right: update("right", &decision.right),
            entry: update("entry", &stays.mux(&decision.entry, &held.step.get("entry"))),
            counts: decision.counts.as_ref().map(|counts| {
                let inserted = counts.inserted();
                let mut next = |name: &str, count: &Expr, inserted: &Expr| {
                    let none = lit(count.width(), 0);
                    update(name, &decision.exists.mux(&hole.mux(count, inserted), &none))
                };
                Counts {
                    left: next("left_count", &counts.left, &inserted.left),
                    right: next("right_count", &counts.right, &inserted.right),
                }
            }),
        }
    }
}

/// Level `level` ≥ 1 of a heap.
pub(super) fn module(config: &Config, level: usize) -> Module {
    let levels = config.heap_levels as usize;
    let format = EntryFormat::new(config);
    let count_bits = Counts::width(levels, level);
    let mut m =
        Module::new("core_a_heap_level", "A level of the pipelined heap: left and right child of every parent.");
    m.parameter("level", level);
    m.parameter("levels", levels);
    let order = Order { format, current: m.input("current", format.tile), last_epoch: m.input("last_epoch", 1) };

    let pending = Pending::new(&mut m, address_width(parents(level)), format.width() + 2 * count_bits);
    let held = Held::new(&mut m, config, level, &pending);
    let decision = Decision::new(&mut m, &held, &order, count_bits);
    for (name, value) in RISE.iter().zip([&decision.rises, &decision.right, &decision.entry]) {
        m.output(name, value);
    }
    let update = Update::new(&mut m, &held, &decision);
    let Some((counts, update_counts)) = decision.counts.as_ref().zip(update.counts.as_ref()) else {
        // Nothing lies below: only a carried entry changes a node.
        pending.take(&mut m, &(&update.valid & &update.carry), &update, &update.entry);
        return m;
    };
    decision.pass_on(&mut m, config, level, &held, counts);
    let [rise_valid, rise_right, rise_entry] = [("valid", 1), ("right", 1), ("entry", format.width())]
        .map(|(name, bits)| m.input(&format!("below_rise_{name}"), bits));
    let counts = update_counts.removed(&(&rise_valid & !&update.carry), &rise_right);
    let node = cat(&[&rise_valid.mux(&rise_entry, &update.entry), &counts.left, &counts.right]);
    pending.take(&mut m, &(&update.valid & (&update.carry | &rise_valid)), &update, &node);
    m
}
