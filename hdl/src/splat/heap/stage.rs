//! A stage of the pipelined heap: two neighboring levels, which take turns at one set of memories, comparators and registers.
//!
//! Two memories hold the left and the right child of every parent. A step meets the children of one parent in three ticks:
//! *read* (the memories show the children; the one it goes on with is *chosen*, the other its *sibling*), *compare* (from
//! registers, while the level below reads), and *write back* (the chosen child's place is rewritten, where there is a hole
//! with what is *promoted* from below). Steps begin every second tick, so one reads while its predecessor writes back at the
//! same level: what the memories do not hold yet is in the register `stored` when it compares.
//!
//! A tick is a cycle, or two where the clock matters more than the rate (`heap_interval`): the first shows and compares, the
//! second decides.
//!
//! Which child is first is stored with the children: the parity of their marks. So a removal knows its way as soon as the
//! memories show them, and the comparison that decides it anew has a tick of its own.

use pointcore_contract::splat::Config;

use super::links::{Below, Compared, Node, Pace, Place, Promotion, Registers, Step, WriteBack};
use super::order::{Entry, EntryFormat, Order};
use super::ports::{BELOW_PROMOTED_NODE, BELOW_ROW, LAP, LAST_EPOCH, NEWCOMER_LAP, PROMOTED_NODE, ROOT, STEP_ROW};
use crate::units::ports::WordPort;
use crate::units::wires::{Bundle, Wires};
use pointcore_contract::width;
use rtl::{Expr, Module, Reg, Wire, bit, cat, lit};

/// Memories with addresses of up to so many bits are made of lookup tables: all of their time lies before their output's register.
const SMALL_MEMORY_BITS: u32 = 7;

/// What every part of a stage refers to.
struct Stage {
    place: Place,
    order: Order,
    pace: Pace,
    /// Set in ticks where the lower level reads, the upper one compares and the lower one writes back.
    lower: Expr,
    compared: Registers<Compared>,
    write_back: Registers<WriteBack>,
    /// The node that was stored in the tick before.
    stored: Reg,
    /// The row that is read, and the one before.
    row: Reg,
    row_before: Reg,
    /// The number of the chosen child, which is the row to be read next.
    next_row: Wire,
}

impl Stage {
    /// Of a node with so much below it: whether there is a left child, whether there is a right one, and whether the left side is full.
    fn children(&self, below: &Below<Wires>) -> [Expr; 3] {
        let Below { right_below: right, left_count: count } = *below;
        if count.width() == 1 {
            return [count, right, count | !self.lower];
        }
        // A node of the lower level counts one bit less.
        let low = count.trunc(count.width() - 1);
        [count.any(), right, low.all() & (count.msb() | !self.lower)]
    }
}

/// The comparison of a step.
struct Comparison {
    exists: Expr,
    chosen: Expr,
    sibling_mark: Expr,
    carried: Expr,
    /// The carried entry is the first of itself and the chosen child.
    carried_first: Expr,
    before_sibling: Expr,
    /// What lies below the chosen child.
    below: Below<Wires>,
    /// The step at the level below.
    step: Step<Wires>,
    promotion: Promotion<Wires>,
}

impl Comparison {
    fn new(m: &mut Module, stage: &Stage) -> Self {
        let Stage { ref place, ref order, ref pace, lower, ref compared, .. } = *stage;
        let (format, compared) = (place.format, &compared.record);
        let stored: Node<Wires> = Node::unpack(place, stage.stored);
        let newest = |m: &mut Module, name: &str, stored: Expr, shown: Expr| {
            m.wire(&format!("chosen_{name}"), compared.chosen_stored.mux(stored, shown))
        };
        let chosen_entry = newest(m, "entry", stored.entry, compared.entry);
        let chosen = pace.found(m, "chosen_entry", chosen_entry);
        let chosen_key = format.key(chosen_entry);
        let sibling = m.wire("sibling", compared.sibling_stored.mux(format.key(stored.entry), compared.sibling));
        let sibling_mark = compared.sibling_stored.mux(stored.mark, compared.sibling_mark);

        let mut carried = compared.carried;
        if place.upper == 0 {
            // The lap of a newcomer is known only now.
            let mut newcomer: Entry<Wires> = Bundle::unpack(&format, carried);
            newcomer.key.lap = lower.mux(NEWCOMER_LAP.declare_word(m, 1), newcomer.key.lap);
            carried = newcomer.pack(&format);
        }
        let before = |m: &mut Module, name: &str, a: Expr, b: Expr| {
            let before = m.wire(name, order.before(a, b));
            pace.found(m, name, before)
        };
        let before_chosen = before(m, "before_chosen", format.key(carried), chosen_key);
        let before_sibling = before(m, "before_sibling", format.key(carried), sibling);
        let exists = compared.exists;
        let carried_first = m.wire("carried_first", compared.carry & (!exists | before_chosen));
        let first = m.wire("first", carried_first.mux(carried, chosen));
        let last = carried_first.mux(chosen, carried);

        let mut below = Below::default();
        let mut children = [bit(false); 3];
        if place.has_lower() {
            below = Below {
                right_below: newest(m, "right_below", stored.below.right_below, compared.below.right_below),
                left_count: newest(m, "left_count", stored.below.left_count, compared.below.left_count),
            };
            children = stage.children(&below);
        }
        let [left_exists, right_exists, left_full] = children;
        let left_exists = pace.found(m, "left_exists", left_exists);
        let right_exists = pace.found(m, "right_exists", right_exists);
        let left_full = pace.found(m, "left_full", left_full);
        let childless = !(left_exists | right_exists);
        let Compared { hole, carry, follows, right, .. } = *compared;
        let valid = compared.valid & exists;
        let step =
            Step { valid, hole, carry, right: left_full, left_exists, right_exists, follows, entry: last, sibling };
        let sibling_stays = before(m, "sibling_stays", compared.parent_sibling, chosen_key);
        let promotion = Promotion { entry: first, ahead: exists & !sibling_stays, right, childless };
        Self { exists, chosen, sibling_mark, carried, carried_first, before_sibling, below, step, promotion }
    }

    /// The step writes back in the next tick.
    fn write_back_next(&self, m: &mut Module, stage: &Stage) {
        let Stage { ref place, ref pace, lower, ref compared, .. } = *stage;
        let Compared { hole, carry, sibling_exists, was_first, valid, .. } = compared.record;
        let exists = self.exists;
        // Where nothing lies below, a hole is filled with the carried entry.
        let is_leaf = if place.continues() || !place.has_lower() { bit(false) } else { !lower };
        let kept = (self.carried_first ^ (hole & is_leaf)).mux(self.carried, self.chosen);
        let inserted = self.carried_first & (self.before_sibling | !sibling_exists);
        // What is inserted in a level that has none below finds an empty place.
        let stays = if place.has_lower() { exists & was_first } else { bit(false) };
        let mut below = Below::default();
        if place.has_lower() {
            let Below { right_below, left_count } = self.below;
            below =
                Below { right_below: right_below & exists, left_count: left_count & exists.repeat(left_count.width()) };
        }
        let write_back = WriteBack {
            // Where there is no child, what is written means nothing; where there is no level, nothing is.
            valid: if place.has_lower() { valid } else { valid & lower },
            hole,
            carry,
            existed: exists,
            ahead: hole.mux(carry & self.before_sibling, stays | inserted),
            sibling_exists,
            sibling_mark: self.sibling_mark,
            entry: kept,
            below,
        };
        stage.write_back.next(m, place, pace, write_back);
    }
}

/// What is written to the chosen child's place.
struct Written {
    valid: Expr,
    /// The number of that place; its lowest bit is the side.
    number: Expr,
    side: Expr,
    /// The side of the first child from now on.
    first_side: Expr,
    entry: Expr,
    node: Expr,
}

impl Written {
    fn new(m: &mut Module, stage: &Stage, comparison: &Comparison) -> Self {
        let Stage { ref place, ref pace, lower, ref write_back, .. } = *stage;
        let WriteBack { hole, carry, existed, ahead, sibling_exists, sibling_mark, entry: own, below, valid } =
            write_back.record;
        let bits = place.row_bits() + 1;
        let own_number = stage.row_before.zext(bits);
        let (promoted, entry, number) = if place.continues() {
            let below = Bundle::input(m, place, "below_promoted_");
            let promoted: Promotion<Wires> = Bundle::choose(place, lower, below, comparison.promotion);
            let entry = hole.mux(promoted.entry, own);
            (promoted, entry, lower.mux(BELOW_PROMOTED_NODE.declare_word(m, bits), own_number))
        } else {
            // Nothing is promoted to the last level, where only `ahead` is asked.
            let promotion = comparison.promotion;
            let promoted = Promotion { ahead: promotion.ahead & !lower, ..promotion };
            let entry = (hole & !lower).mux(promotion.entry, own);
            let [last, last_before] = ["last_row", "last_row_before"].map(|name| m.reg(name, bits));
            pace.next(m, last, stage.next_row);
            pace.next(m, last_before, last);
            (promoted, entry, lower.mux(last_before, own_number))
        };
        let side = m.wire("side", number.bit(0));
        let entry = m.wire("entry_to_store", entry);
        // Where nothing fills the hole its place is empty: which of the two is first and what lies below mean nothing.
        let filled_first = !sibling_exists | ahead | promoted.ahead;
        let is_first = m.wire("is_first", hole.mux(filled_first, ahead));
        let first_side = m.wire("first_side", side ^ !is_first);
        let leaves = hole & !carry;
        let comes = !hole & existed;
        let mark = first_side ^ (sibling_exists & sibling_mark);
        let mut node = Node { entry, mark, below };
        if place.has_lower() {
            let last_leaves = leaves & promoted.right & promoted.childless;
            node.below.right_below = (below.right_below & !last_leaves) | (comes & promoted.right);
            let (count, down) = (below.left_count, leaves & !promoted.right);
            let changes = down | (comes & !promoted.right);
            let change = if count.width() > 1 { cat([down.repeat(count.width() - 1), changes]) } else { changes };
            node.below.left_count = count + change;
        }
        let node = m.wire("node_to_store", node.pack(place));
        pace.next(m, stage.stored, node);
        Self { valid, number, side, first_side, entry, node }
    }
}

/// Reads the children of the step's parent, chooses one, and hands both to the comparison. Returns the chosen entry with all
/// that is written back, for the root.
fn read_children(m: &mut Module, stage: &Stage, step: &Step<Wires>, above_row: Expr, written: &Written) -> Expr {
    let Stage { ref place, ref pace, lower, ref compared, row, .. } = *stage;
    let Written { valid, number, side, first_side, entry, node } = *written;
    let presented = lower.mux(above_row, stage.next_row.trunc(place.row_bits()));
    pace.next(m, row, presented);
    pace.next(m, stage.row_before, row);
    // The rows of a last stage of one level end before those of its lower level.
    let address_bits = place.row_bits().min(place.levels - 1);
    // The memories show the rows either at the start of a tick, in which case they are registered, or not before its end.
    let is_late = address_bits <= SMALL_MEMORY_BITS && matches!(pace, Pace::TwoCycles(_));
    let mut child = |name: &str, enable: Expr| {
        let address = number.bits(place.row_bits(), 1).trunc(address_bits);
        let write = pace.at_end(valid & enable);
        let show = |m: &mut Module, name: &str, write: Expr, address: Expr, row: Expr| {
            let (name_of_nodes, depth) = (format!("{name}_nodes"), 1 << address.width());
            let memory = if is_late {
                m.memory_distributed(&name_of_nodes, depth, node.width())
            } else {
                m.memory_unordered(&name_of_nodes, depth, node.width())
            };
            m.write(memory, write, address, node);
            m.read(memory, &format!("{name}_shown"), row)
        };
        let shown = match pace {
            Pace::TwoCycles(_) if is_late => show(m, name, write, address, row.trunc(address_bits)),
            // Which of two neighboring rows it is comes last of all, and the way to a block RAM is long: both are read, and one is chosen
            // when the tick ends.
            Pace::TwoCycles(_) => {
                let mut bank = |of: &str, is_written: Expr| {
                    let [written, read] = [&address, &presented].map(|row| row.bits(address_bits - 1, 1));
                    let shown = show(m, &format!("{name}_{of}"), write & is_written, written, read);
                    pace.found(m, &format!("{name}_{of}"), shown)
                };
                let (even, odd) = (bank("even", !address.bit(0)), bank("odd", address.bit(0)));
                row.bit(0).mux(odd, even)
            }
            Pace::Cycle => show(m, name, write, address, presented.trunc(address_bits)),
        };
        Node::unpack(place, shown)
    };
    let (left, right): (Node<Wires>, _) = (child("left", !side), child("right", side));

    let Step { hole, carry, left_exists, right_exists, follows, .. } = *step;
    let newer = m.wire("newer", follows & valid);
    let stored_first = left.mark ^ right.mark;
    let first = (left_exists & right_exists).mux(newer.mux(first_side, stored_first), right_exists);
    let goes_right = m.wire("goes_right", hole.mux(first, step.right));
    m.drive(stage.next_row, cat([*row, goes_right]));
    let same_side = m.wire("same_side", goes_right ^ !side);
    let chosen = Bundle::choose(place, goes_right, right, left);
    let other = Bundle::choose(place, !goes_right, right, left);
    let shown = Compared {
        valid: step.valid,
        hole,
        carry,
        follows: follows & same_side,
        carried: step.entry,
        exists: goes_right.mux(right_exists, left_exists),
        right: goes_right,
        was_first: goes_right.eq(first),
        parent_sibling: step.sibling,
        chosen_stored: newer & same_side,
        sibling_stored: newer & !same_side,
        sibling: place.format.key(other.entry),
        sibling_exists: goes_right.mux(left_exists, right_exists),
        sibling_mark: other.mark,
        entry: chosen.entry,
        below: chosen.below,
    };
    compared.next(m, place, pace, shown);
    newer.mux(entry, right.entry)
}

/// The stage whose upper level is `upper`.
pub(super) fn module(config: &Config, format: EntryFormat, upper: u32) -> Module {
    let place = Place::new(config, format, upper);
    let mut m = Module::new("splat_heap_stage", "Two neighboring levels of the pipelined heap.");
    m.variant("level", upper);
    m.parameter("levels", place.levels);
    m.parameter("interval", config.heap_interval);
    let (lap, last_epoch) = (LAP.declare_word(&mut m, 1), LAST_EPOCH.declare_word(&mut m, 1));
    let order = Order { format: place.format, lap, last_epoch };
    let pace = Pace::new(&mut m, config);
    let lower = pace.lower(&mut m);
    let above = Step::input(&mut m, &place, "step_");
    let bits = place.row_bits();
    let above_row = if upper > 0 { STEP_ROW.declare_word(&mut m, upper).zext(bits) } else { lit(bits, 0) };
    let stage = Stage {
        place,
        order,
        pace,
        compared: Registers::<Compared>::new(&mut m, &place, "compared_", |compared| compared.valid),
        write_back: Registers::<WriteBack>::new(&mut m, &place, "write_back_", |written| written.valid),
        stored: m.reg("stored", width::<Node>(&place)),
        row: m.reg("row", bits),
        row_before: m.reg("row_before", bits),
        next_row: m.forward("next_row", bits + 1),
        lower,
    };
    let comparison = Comparison::new(&mut m, &stage);
    comparison.write_back_next(&mut m, &stage);
    let written = Written::new(&mut m, &stage, &comparison);
    let step = Bundle::choose(&place, stage.lower, comparison.step, above);
    let root = read_children(&mut m, &stage, &step, above_row, &written);
    if upper == 0 {
        // The root stands on the right below nothing.
        ROOT.drive_word(&mut m, root);
    } else {
        comparison.promotion.output(&mut m, &place, "promoted_");
        PROMOTED_NODE.drive_word(&mut m, stage.row_before.trunc(upper));
    }
    if place.continues() {
        comparison.step.output(&mut m, &place, "below_");
        BELOW_ROW.drive_word(&mut m, stage.next_row);
    }
    m
}
