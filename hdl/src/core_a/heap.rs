//! Pipelined heap that orders splat copies by tile (thesis 5.5.2, eq. 5.14), an operation every second cycle; golden twin:
//! `pointcore_golden::core_a::heap`.
//!
//! This module holds the root and the numbers that order entries; `heap_level` is a level below. An insertion walks
//! down to where there is room, a removal pulls the first child up level by level, and a replacement is a removal whose
//! hole the new entry may fill.

use pointcore_spec::core_a::{Config, Field};

use super::heap_level::{self, Counts, RISE, step_fields};
use super::heap_order::{EntryFormat, Order};
use crate::rtl::{Expr, Module, cat, lit};
use crate::units::records::{Record, queue_out, stream_in};

/// The unit; ports as in `spec::core_a::ports::heap`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let format = EntryFormat::new(config);
    let levels = config.heap_levels as usize;
    let mut m = Module::new("core_a_heap", "Pipelined heap that orders splat copies by tile, then by arrival.");
    m.parameter("levels", levels);
    m.parameter("sequence_bits", format.sequence);
    let fields: [Field; 2] = [("tile".into(), config.tile_bits()), ("pointer".into(), config.heap_levels)];
    let input = stream_in(&mut m, "in", &fields);
    let out = queue_out(&mut m, "out", &fields);

    let resting = m.reg_reset("resting", 1, 0);
    let count = m.reg_reset("count", levels, 0);
    let occupied = m.wire("occupied", &count.any());
    let sequence = m.reg_reset("arrival", format.sequence, 0);
    let alive = ["alive_even", "alive_odd"].map(|name| m.reg_reset(name, levels, 0));
    let blocked = {
        let own_epoch_alive = sequence.msb().mux(&alive[1].any(), &alive[0].any());
        m.wire("fresh_epoch_blocked", &(sequence.trunc(format.sequence - 1).is_zero() & own_epoch_alive))
    };
    let pop = m.wire("pop", &(!&resting & (&occupied & &out.room)));
    let ready = m.wire("ready", &(&(!&resting & !&blocked) & &(!count.all() | &pop)));
    m.ready(&input, &ready);
    let push = m.wire("push", &(&ready & &input.valid));
    let insert = m.wire("insert", &(&push & !&pop));

    let root = m.reg("root", format.width());
    let root_counts =
        ["root_left_count", "root_right_count"].map(|name| m.reg_reset(name, Counts::width(levels, 0), 0));
    m.next(&resting, &(&push | &pop));
    m.next_if(&count, &(&push ^ &pop), &push.mux(&count.add_lit(1), &count.sub_lit(1)));
    m.next_if(&sequence, &push, &sequence.add_lit(1));
    for (epoch, alive) in alive.iter().enumerate() {
        let is_of = |entry_sequence: &Expr| entry_sequence.msb().eq_lit(epoch as u128);
        let (comes, goes) = (&push & is_of(&sequence), &pop & is_of(&format.sequence(&root)));
        m.next_if(alive, &(&comes ^ &goes), &comes.mux(&alive.add_lit(1), &alive.sub_lit(1)));
    }
    let current = m.reg_reset("current", format.tile, 0);
    m.next_if(&current, &pop, &format.tile(&root));
    let last_epoch = m.reg("last_epoch", 1);
    m.next_if(&last_epoch, &push, &sequence.msb());

    let order = Order { format, current: current.expr(), last_epoch: last_epoch.expr() };
    let newcomer = cat(&[&input.field("tile"), &sequence, &input.field("pointer")]);
    let root_stays = m.wire("root_stays", &(&occupied & !order.newcomer_before(&newcomer, &root)));
    let counts = Counts { left: root_counts[0].expr(), right: root_counts[1].expr() };
    let first_step = Record::new(&step_fields(config, 1), |name| match name {
        "hole" => pop.clone(),
        "carry" => push.clone(),
        "entry" => (&pop | &root_stays).mux(&newcomer, &root),
        "index" => lit(1, 0),
        "right" => counts.goes_right(),
        "left_exists" => counts.left.any(),
        _ => counts.right.any(),
    });
    let [rise_valid, rise_right, rise_entry] =
        levels_below(&mut m, config, &order, &(&pop | (&push & &occupied)), &first_step);

    // The root's place: what rises from below a cycle after a removal, or the newcomer until that is known.
    let takes_newcomer = &pop | (&push & !&root_stays);
    m.next_if(&root, &(&rise_valid | takes_newcomer), &rise_valid.mux(&rise_entry, &newcomer));
    let replacing = m.reg("replacing", 1);
    m.next(&replacing, &push);
    let grows = m.wire("grows", &(&insert & &occupied));
    let shrinks = m.wire("shrinks", &(&rise_valid & !&replacing));
    let (inserted, removed) = (counts.inserted(), counts.removed(&shrinks, &rise_right));
    for (register, inserted, removed) in
        [(&root_counts[0], &inserted.left, &removed.left), (&root_counts[1], &inserted.right, &removed.right)]
    {
        m.next_if(register, &(&grows | &shrinks), &grows.mux(inserted, removed));
    }

    m.output("empty", &!(&occupied | &out.holds));
    out.push(&mut m, &pop, |name| if name == "tile" { format.tile(&root) } else { format.pointer(&root) });
    m
}

/// Places the levels below the root one after the other; returns what rises to the root.
fn levels_below(m: &mut Module, config: &Config, order: &Order, valid: &Expr, first_step: &Record) -> [Expr; 3] {
    let instances: Vec<_> = (1..config.heap_levels as usize)
        .map(|level| m.instance(&format!("level_{level}"), heap_level::module(config, level)))
        .collect();
    for instance in &instances {
        m.connect(instance, "current", &order.current);
        m.connect(instance, "last_epoch", &order.last_epoch);
    }
    m.connect(&instances[0], "step_valid", valid);
    first_step.connect(m, &instances[0], "step_");
    for (level, pair) in instances.windows(2).enumerate() {
        let valid = m.out(&pair[0], "below_valid");
        m.connect(&pair[1], "step_valid", &valid);
        let step = Record::new(&step_fields(config, level + 2), |name| m.out(&pair[0], &format!("below_{name}")));
        step.connect(m, &pair[1], "step_");
        for name in RISE {
            let risen = m.out(&pair[1], name);
            m.connect(&pair[0], &format!("below_{name}"), &risen);
        }
    }
    RISE.map(|name| m.out(&instances[0], name))
}
