//! A stage of the pipelined heap: two neighboring levels, which take turns at one set of memories, comparators and registers.
//!
//! Two memories hold the left and the right child of every parent. A step meets the children of one parent in three ticks:
//! *look* (the memories show the children; the one it goes on with is *chosen*, the other its *rival*), *compare* (from
//! registers, while the level below looks), and *settle* (the chosen child's place is rewritten, with what rises from below
//! where there is a hole). Steps begin every second tick, so one looks while its predecessor settles at the same level:
//! what the memories do not hold yet is in the register `stored` when it compares.
//!
//! A tick is a cycle, or two where the clock matters more than the rate (`heap_interval`): the first shows and compares, the
//! second decides.
//!
//! Which child is first is stored with the children: the parity of their marks. So a removal knows its way as soon as the
//! memories show them, and the comparison that decides it anew has a tick of its own.

use pointcore_contract::splat::Config;

use super::links::{Pace, Place, Registers};
use super::order::{EntryFormat, Order};
use crate::units::records::{Record, width};
use rtl::{Expr, Module, Reg, Wire, bit, cat, lit};

/// What a level says of the step it compares, to the level that settles it; `node` is the number of the parent.
pub(super) const RISE: [&str; 6] = ["entry", "exists", "ahead", "right", "childless", "node"];

/// Memories with addresses of up to so many bits are made of lookup tables: all of their time lies before their output's register.
const SMALL_MEMORY_BITS: u32 = 7;

/// What every part of a stage refers to.
struct Stage {
    place: Place,
    order: Order,
    pace: Pace,
    /// Set in ticks where the lower level looks, the upper one compares and the lower one settles.
    lower: Expr,
    compared: Registers,
    settled: Registers,
    /// The node that was stored in the tick before.
    stored: Reg,
    /// The row that is looked at, and the one before.
    row: Reg,
    row_before: Reg,
    /// The number of the chosen child, which is the row to be looked at next.
    next_row: Wire,
}

/// The comparison of a step.
struct Comparison {
    exists: Expr,
    chosen: Expr,
    rival_mark: Expr,
    carried: Expr,
    /// The carried entry is the first of itself and the chosen child.
    carried_first: Expr,
    before_rival: Expr,
    /// Whether there is anything on the right below the chosen child, and how much on the left.
    below: Option<[Expr; 2]>,
    /// The step at the level below.
    step: Record,
    rise: Record,
}

impl Comparison {
    fn new(m: &mut Module, stage: &Stage) -> Self {
        let Stage { ref place, ref order, ref pace, lower, ref compared, .. } = *stage;
        let format = place.format;
        let exists = compared.get("exists");
        let stored = Record::unpack(&place.node(), stage.stored);
        let (chosen_stored, rival_stored) = (compared.get("chosen_stored"), compared.get("rival_stored"));
        let newest = |m: &mut Module, name: &str| {
            m.wire(&format!("chosen_{name}"), chosen_stored.mux(stored.get(name), compared.get(name)))
        };
        let chosen_entry = newest(m, "entry");
        let chosen = pace.found(m, "chosen_entry", chosen_entry);
        let chosen_key = format.key(chosen_entry);
        let rival = m.wire("rival", rival_stored.mux(format.key(stored.get("entry")), compared.get("rival")));
        let rival_mark = rival_stored.mux(stored.get("mark"), compared.get("rival_mark"));

        let mut carried = compared.get("carried");
        if place.upper == 0 {
            // The sweep of a newcomer is known only now.
            let sweep = lower.mux(m.input("newcomer_sweep", 1), carried.msb());
            carried = cat([sweep, carried.trunc(format.width() - 1)]);
        }
        let before = |m: &mut Module, name: &str, a: Expr, b: Expr| {
            let before = m.wire(name, order.before(a, b));
            pace.found(m, name, before)
        };
        let before_chosen = before(m, "before_chosen", format.key(carried), chosen_key);
        let before_rival = before(m, "before_rival", format.key(carried), rival);
        let carried_first = m.wire("carried_first", compared.get("carry") & (!exists | before_chosen));
        let first = m.wire("first", carried_first.mux(carried, chosen));
        let last = carried_first.mux(chosen, carried);

        let below = place.has_lower().then(|| ["right_below", "left_count"].map(|name| newest(m, name)));
        let (left_exists, right_exists, left_full) = match &below {
            // A node of the lower level counts one bit less.
            Some([right, count]) if count.width() > 1 => {
                let low = count.trunc(count.width() - 1);
                (count.any(), *right, low.all() & (count.msb() | !lower))
            }
            Some([right, count]) => (*count, *right, *count | !lower),
            None => (bit(false), bit(false), bit(false)),
        };
        let left_exists = pace.found(m, "left_exists", left_exists);
        let right_exists = pace.found(m, "right_exists", right_exists);
        let left_full = pace.found(m, "left_full", left_full);
        let childless = !(left_exists | right_exists);
        let step = Record::new(&place.step(), |name| match name {
            "valid" => compared.get("valid") & exists,
            "right" => left_full,
            "left_exists" => left_exists,
            "right_exists" => right_exists,
            "entry" => last,
            "rival" => rival,
            passed => compared.get(passed),
        });
        let rival_stays = before(m, "rival_stays", compared.get("parent_rival"), chosen_key);
        let rise = Record::new(&place.rise(), |name| match name {
            "entry" => first,
            "exists" => exists,
            "ahead" => exists & !rival_stays,
            "childless" => childless,
            passed => compared.get(passed),
        });
        Self { exists, chosen, rival_mark, carried, carried_first, before_rival, below, step, rise }
    }

    /// The step settles in the next tick.
    fn settle_next(&self, m: &mut Module, stage: &Stage) {
        let Stage { ref place, ref pace, lower, ref compared, .. } = *stage;
        let hole = compared.get("hole");
        // Where nothing lies below, a hole is filled with the carried entry.
        let is_leaf = if place.continues() || !place.has_lower() { bit(false) } else { !lower };
        let kept = (self.carried_first ^ (hole & is_leaf)).mux(self.carried, self.chosen);
        stage.settled.next(m, pace, |name| match name {
            "valid" => compared.get("valid") & (self.exists | !hole),
            "existed" => self.exists,
            "rival_mark" => self.rival_mark,
            "entry" => kept,
            "ahead" => {
                let inserted = self.carried_first & (self.before_rival | !compared.get("rival_exists"));
                let stays = self.exists & compared.get("was_first");
                hole.mux(compared.get("carry") & self.before_rival, stays | inserted)
            }
            "right_below" | "left_count" => {
                let [right, count] = self.below.as_ref().expect("these fields are there where nodes have children");
                let value = if name == "right_below" { right } else { count };
                *value & self.exists.repeat(value.width())
            }
            passed => compared.get(passed),
        });
    }
}

/// What becomes of the chosen child's place.
struct Settlement {
    valid: Expr,
    /// The number of that place; its lowest bit is the side.
    number: Expr,
    side: Expr,
    /// The side of the first child from now on.
    first_side: Expr,
    entry: Expr,
    node: Expr,
}

impl Settlement {
    fn new(m: &mut Module, stage: &Stage, comparison: &Comparison) -> Self {
        let Stage { ref place, ref pace, lower, ref settled, .. } = *stage;
        let (hole, carry, own) = (settled.get("hole"), settled.get("carry"), settled.get("entry"));
        let bits = place.row_bits() + 1;
        let own_number = stage.row_before.zext(bits);
        let (risen, entry, number) = if place.continues() {
            let below = Record::input(m, "below_rise_", &place.rise());
            let risen = below.mux(lower, &comparison.rise);
            let entry = hole.mux(risen.get("entry"), own);
            (risen, entry, lower.mux(m.input("below_rise_node", bits), own_number))
        } else {
            // Nothing rises to the last level.
            let risen = Record::zeros(&place.rise()).mux(lower, &comparison.rise);
            let entry = (hole & !lower).mux(comparison.rise.get("entry"), own);
            let [last, last_before] = ["last_row", "last_row_before"].map(|name| m.reg(name, bits));
            pace.next(m, last, stage.next_row);
            pace.next(m, last_before, last);
            (risen, entry, lower.mux(last_before, own_number))
        };
        let side = m.wire("side", number.bit(0));
        let entry = m.wire("entry_to_store", entry);
        let (risen_exists, risen_right) = (risen.get("exists"), risen.get("right"));
        let (ahead, rival_exists) = (settled.get("ahead"), settled.get("rival_exists"));
        let filled_first = (carry | risen_exists) & (!rival_exists | ahead | risen.get("ahead"));
        let is_first = m.wire("is_first", hole.mux(filled_first, ahead));
        let first_side = m.wire("first_side", side ^ !is_first);
        let leaves = hole & !carry & risen_exists;
        let comes = !hole & settled.get("existed");
        let node = Record::new(&place.node(), |name| match name {
            "entry" => entry,
            "mark" => first_side ^ (rival_exists & settled.get("rival_mark")),
            "right_below" => {
                let last_leaves = leaves & risen_right & risen.get("childless");
                (settled.get(name) & !last_leaves) | (comes & risen_right)
            }
            _ => {
                let (count, down) = (settled.get(name), leaves & !risen_right);
                let changes = down | (comes & !risen_right);
                let change = if count.width() > 1 { cat([down.repeat(count.width() - 1), changes]) } else { changes };
                count + change
            }
        });
        let node = m.wire("node_to_store", node.pack());
        pace.next(m, stage.stored, node);
        Self { valid: settled.get("valid"), number, side, first_side, entry, node }
    }
}

/// Shows the children of the step's parent, chooses one, and hands both to the comparison. Returns the chosen entry with all
/// that has settled, for the root.
fn look(m: &mut Module, stage: &Stage, step: &Record, above_row: Expr, settlement: &Settlement) -> Expr {
    let Stage { ref place, ref pace, lower, ref compared, row, .. } = *stage;
    let Settlement { valid, number, side, first_side, entry, node } = *settlement;
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
        Record::unpack(&place.node(), shown)
    };
    let (left, right) = (child("left", !side), child("right", side));

    let (left_exists, right_exists) = (step.get("left_exists"), step.get("right_exists"));
    let newer = m.wire("newer", step.get("follows") & valid);
    let stored_first = left.get("mark") ^ right.get("mark");
    let first = (left_exists & right_exists).mux(newer.mux(first_side, stored_first), right_exists);
    let goes_right = m.wire("goes_right", step.get("hole").mux(first, step.get("right")));
    m.drive(stage.next_row, cat([*row, goes_right]));
    let same_side = m.wire("same_side", goes_right ^ !side);
    let goes_left = !goes_right;
    let pick = |name: &str, right_one: Expr| right_one.mux(right.get(name), left.get(name));
    compared.next(m, pace, |name| match name {
        "follows" => step.get("follows") & same_side,
        "carried" => step.get("entry"),
        "exists" => goes_right.mux(right_exists, left_exists),
        "rival_exists" => goes_right.mux(left_exists, right_exists),
        "right" => goes_right,
        "was_first" => goes_right.eq(first),
        "parent_rival" => step.get("rival"),
        "chosen_stored" => newer & same_side,
        "rival_stored" => newer & !same_side,
        "rival" => place.format.key(pick("entry", goes_left)),
        "rival_mark" => pick("mark", goes_left),
        "entry" | "right_below" | "left_count" => pick(name, goes_right),
        passed => step.get(passed),
    });
    newer.mux(entry, right.get("entry"))
}

/// The stage whose upper level is `upper`.
pub(super) fn module(config: &Config, format: EntryFormat, upper: u32) -> Module {
    let place = Place::new(config, format, upper);
    let mut m = Module::new("splat_heap_stage", "Two neighboring levels of the pipelined heap.");
    m.parameter("level", upper);
    m.parameter("levels", place.levels);
    m.parameter("interval", config.heap_interval);
    let order = Order { format: place.format, sweep: m.input("sweep", 1), last_epoch: m.input("last_epoch", 1) };
    let pace = Pace::new(&mut m, config);
    let lower = pace.lower(&mut m);
    let above = Record::input(&mut m, "step_", &place.step());
    let bits = place.row_bits();
    let above_row = if upper > 0 { m.input("step_row", upper).zext(bits) } else { lit(bits, 0) };
    let stage = Stage {
        place,
        order,
        pace,
        compared: Registers::new(&mut m, "compared_", &place.compared()),
        settled: Registers::new(&mut m, "settled_", &place.settled()),
        stored: m.reg("stored", width(&place.node())),
        row: m.reg("row", bits),
        row_before: m.reg("row_before", bits),
        next_row: m.forward("next_row", bits + 1),
        lower,
    };
    let comparison = Comparison::new(&mut m, &stage);
    comparison.settle_next(&mut m, &stage);
    let settlement = Settlement::new(&mut m, &stage, &comparison);
    let step = comparison.step.mux(stage.lower, &above);
    let root = look(&mut m, &stage, &step, above_row, &settlement);
    if upper == 0 {
        // The root stands on the right below nothing.
        m.output("root", root);
    } else {
        comparison.rise.output(&mut m, "rise_");
        m.output("rise_node", stage.row_before.trunc(upper));
    }
    if place.continues() {
        comparison.step.output(&mut m, "below_");
        m.output("below_row", stage.next_row);
    }
    m
}
