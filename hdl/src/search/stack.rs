//! The stacks of all threads (thesis 6.5.2, table 6.3): paths not taken, in one memory; golden twin:
//! `pointcore_golden::search::stack`.

use pointcore_contract::search::{Config, records};
use pointcore_contract::splat::config::index_bits;

use super::parts::sets::decode;
use crate::units::records::{Record, pulse_in, width};
use rtl::{Module, address_width, bit, cat};

/// The unit; ports as in `contract::search::ports::stack`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let threads = config.threads;
    let depth = config.tree_depth;
    let thread_only = records::thread_only(config);
    let path = records::path(config);
    let mut m = Module::new("search_stack", "A stack of paths for each thread.");
    m.parameter("threads", threads);
    m.parameter("depth", depth);
    let pushed_fields: Vec<_> = thread_only.iter().chain(&path).cloned().collect();
    let push = pulse_in(&mut m, "push", &pushed_fields);
    let pop = pulse_in(&mut m, "pop", &thread_only);
    let (pushing, popping) = (push.record.get("thread"), pop.record.get("thread"));

    let depth_bits = index_bits(depth + 1);
    let depths: Vec<_> = (0..threads).map(|thread| m.reg_reset(&format!("depth_{thread}"), depth_bits, 0)).collect();
    let push_depth = m.wire("push_depth", pushing.pick(depths.clone()));
    let pop_depth = m.wire("pop_depth", popping.pick(depths.clone()));
    let takes = m.wire("takes", pop.valid & pop_depth.any());
    let [up, down] = [("up", push.valid, pushing), ("down", takes, popping)]
        .map(|(name, valid, thread)| m.wire(name, decode(valid, thread, threads)));
    for (thread, register) in (0..).zip(depths) {
        let changes = up.bit(thread) | down.bit(thread);
        m.next_if(register, changes, up.bit(thread).mux(register.add_lit(1), register.sub_lit(1)));
    }

    let level_bits = address_width(depth);
    let paths = m.memory_unordered("paths", 1 << (config.thread_bits() + level_bits), width(&path));
    let write_address = cat([pushing, push_depth.trunc(level_bits)]);
    m.write(paths, push.valid, write_address, push.record.only(&path).pack());
    let read_address = cat([popping, pop_depth.sub_lit(1).trunc(level_bits)]);
    let top = m.read_if(paths, "top", takes, read_address);

    let top_empty = m.reg_reset("top_empty", 1, 1);
    m.next_if(top_empty, pop.valid, pop_depth.is_zero());
    m.output("top_empty", top_empty);
    Record::unpack(&path, top).output(&mut m, "top_");
    m.assert("stack_has_room", !push.valid | push_depth.lt_lit(depth.into()));
    let same_thread = if threads > 1 { pushing.eq(popping) } else { bit(true) };
    m.assert("one_access_a_thread", !((push.valid & pop.valid) & same_thread));
    m
}
