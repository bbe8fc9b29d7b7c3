//! Pipelined heap that orders splat copies by tile (thesis 5.5.2, eq. 5.14), an operation every second or fourth cycle; golden twin:
//! `pointcore_golden::splat::heap`.
//!
//! This module decides what enters the heap and what leaves it; `stage` is two levels. An insertion walks
//! down to where there is room, a removal promotes the first child level by level, and a replacement is a removal whose
//! hole the new entry may fill.

mod links;
mod order;
mod ports;
mod stage;

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::HeapEntry;
use pointcore_contract::splat::units::heap::PORTS;

use crate::units::ports::{StreamInPorts, StreamOutPorts, WordPort};
use crate::units::wires::{Bundle, Wires};
use links::{Pace, Place, Promotion, Step};
use order::{Entry, EntryFormat, Key};
use ports::{BELOW_PROMOTED_NODE, BELOW_ROW, LAP, LAST_EPOCH, NEWCOMER_LAP, PROMOTED_NODE, ROOT, STEP_ROW};
use rtl::{Expr, Instance, Module, bit, lit};

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    numbered(config, config.sequence_bits())
}

/// The unit with arrival numbers of so many bits.
#[must_use]
pub fn numbered(config: &Config, sequence_bits: u32) -> Module {
    let format = EntryFormat::new(config, sequence_bits);
    let levels = config.heap_levels;
    let mut m = Module::new("splat_heap", "Pipelined heap that orders splat copies by tile, then by arrival.");
    m.parameter("levels", levels);
    m.parameter("interval", config.heap_interval);
    m.parameter("sequence_bits", format.sequence);
    let input = PORTS.input.declare(&mut m, config);
    let out = PORTS.out.queue(&mut m, config);

    // Operations begin every second tick, when the upper levels of the stages read; after reset at once.
    let pace = Pace::new(&mut m, config);
    let lower = pace.lower(&mut m);
    let begins = m.wire("begins", pace.at_end(!lower));
    let stages = stages(&mut m, config, format);
    let root: Entry<Wires> = Bundle::unpack(&format, ROOT.word_of(&mut m, stages[0]));

    let count = m.reg_reset("count", levels, 0);
    let arrival = m.reg_reset("arrival", format.sequence, 0);
    let alive = ["alive_even", "alive_odd"].map(|name| m.reg_reset(name, levels, 0));
    // Counters change when an operation begins: what they say is known a cycle later, in time for the next.
    let mut known = |name: &str, now: Expr| {
        let register = m.reg_reset(name, 1, 0);
        m.next(register, now);
        register
    };
    let occupied = known("occupied", count.any());
    let full = known("full", count.all());
    let own_epoch_alive = arrival.msb().mux(alive[1].any(), alive[0].any());
    let starts_epoch = arrival.trunc(format.sequence - 1).is_zero();
    let blocked = known("fresh_epoch_blocked", starts_epoch & own_epoch_alive);
    let pop = m.wire("pop", begins & (occupied & out.room));
    let ready = m.wire("ready", (begins & !blocked) & (!full | pop));
    m.drive(input.ready, ready);
    let push = m.wire("push", ready & input.valid);
    m.next_if(count, push ^ pop, push.mux(count.add_lit(1), count.sub_lit(1)));
    m.next_if(arrival, push, arrival.add_lit(1));
    for (epoch, alive) in alive.iter().enumerate() {
        let is_of = |number: Expr| number.eq_lit(epoch as u128);
        let (comes, goes) = (push & is_of(arrival.msb()), pop & is_of(root.key.sequence.msb()));
        m.next_if(*alive, comes ^ goes, comes.mux(alive.add_lit(1), alive.sub_lit(1)));
    }

    // The lap of a newcomer is decided a tick later, when the current tile is known.
    let current = m.reg_reset("current", format.tile, 0);
    m.next_if(current, pop, root.key.tile);
    let lap = m.reg_reset("lap", 1, 0);
    m.next_if(lap, pop, root.key.lap);
    let last_epoch = m.reg("last_epoch", 1);
    m.next_if(last_epoch, push, arrival.msb());
    let newcomer_tile = m.reg("newcomer_tile", format.tile);
    let HeapEntry { tile, pointer } = input.record;
    pace.next(&mut m, newcomer_tile, tile);
    let newcomer_lap = m.wire("newcomer_lap", lap ^ newcomer_tile.lt(current));
    NEWCOMER_LAP.feed_word(&mut m, stages[0], newcomer_lap);

    // The root is the right child of nothing, and every step comes by it. It has no sibling.
    let newcomer = Entry { key: Key { lap: bit(false), tile, sequence: arrival.expr() }, pointer };
    let step = Step {
        valid: push | pop,
        hole: pop,
        carry: push,
        right: bit(true),
        left_exists: bit(false),
        right_exists: *occupied,
        follows: bit(true),
        entry: newcomer.pack(&format),
        sibling: lit(format.key_width(), 0),
    };
    step.connect(&mut m, &Place::new(config, format, 0), stages[0], "step_");
    for stage in &stages {
        LAP.feed_word(&mut m, *stage, lap);
        LAST_EPOCH.feed_word(&mut m, *stage, last_epoch);
    }

    PORTS.empty.drive_word(&mut m, !(count.any() | out.holds));
    out.push(&mut m, config, pop, HeapEntry { tile: root.key.tile, pointer: root.pointer });
    m
}

/// Places the stages one below the other and connects neighbors.
fn stages(m: &mut Module, config: &Config, format: EntryFormat) -> Vec<Instance> {
    let instances: Vec<_> = (0..config.heap_levels)
        .step_by(2)
        .map(|level| m.instance(&format!("stage_{level}"), stage::module(config, format, level)))
        .collect();
    // What stages tell each other is the same everywhere.
    let place = &Place::new(config, format, 0);
    for pair in instances.windows(2) {
        let [above, below] = [pair[0], pair[1]];
        Step::shown_by(m, place, above, "below_").connect(m, place, below, "step_");
        let row = BELOW_ROW.word_of(m, above);
        STEP_ROW.feed_word(m, below, row);
        Promotion::shown_by(m, place, below, "promoted_").connect(m, place, above, "below_promoted_");
        let node = PROMOTED_NODE.word_of(m, below);
        BELOW_PROMOTED_NODE.feed_word(m, above, node);
    }
    instances
}
