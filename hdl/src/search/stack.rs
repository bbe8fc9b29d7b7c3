//! The stacks of all threads (thesis 6.5.2, table 6.3): paths not taken, in one memory; golden twin:
//! `pointcore_golden::search::stack`.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::Path;
use pointcore_contract::search::units::stack::PORTS;
use pointcore_contract::splat::config::index_bits;
use pointcore_contract::width;

use super::parts::sets::decode;
use crate::units::ports::{OutputPorts, PulseInPorts, WordPort};
use crate::units::wires::Bundle;
use rtl::{Module, address_width, bit, cat};

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let threads = config.threads;
    let depth = config.tree_depth;
    let mut m = Module::new("search_stack", "A stack of paths for each thread.");
    m.parameter("threads", threads);
    m.parameter("depth", depth);
    let push = PORTS.push.declare(&mut m, config);
    let pop = PORTS.pop.declare(&mut m, config);
    let (pushing, popping) = (push.record.thread.thread, pop.record.thread);

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
    let paths = m.memory_unordered("paths", 1 << (config.thread_bits() + level_bits), width::<Path>(config));
    let write_address = cat([pushing, push_depth.trunc(level_bits)]);
    m.write(paths, push.valid, write_address, push.record.path.pack(config));
    let read_address = cat([popping, pop_depth.sub_lit(1).trunc(level_bits)]);
    let top = m.read_if(paths, "top", takes, read_address);

    let top_empty = m.reg_reset("top_empty", 1, 1);
    m.next_if(top_empty, pop.valid, pop_depth.is_zero());
    PORTS.top_empty.drive_word(&mut m, top_empty);
    PORTS.top.drive(&mut m, config, Path::unpack(config, top));
    m.assert("stack_has_room", !push.valid | push_depth.lt_lit(depth.into()));
    let same_thread = if threads > 1 { pushing.eq(popping) } else { bit(true) };
    m.assert("one_access_a_thread", !((push.valid & pop.valid) & same_thread));
    m
}
