//! Sieve (thesis 6.5.2): takes out beats without a point near enough before the priority queues spend a cycle on them;
//! golden twin: `pointcore_golden::search::sieve`.
//!
//! The last beat that was kept waits in `held` until it is known whether the leaf's end goes along with it.

use pointcore_contract::search::{Config, records};

use super::radii::radii;
use super::sets::set;
use crate::stream::fifo;
use crate::units::records::{Record, layout, pulse_in, queue_in, registered_pulse_out};
use rtl::{Expr, Module};

/// Whether a lane is nearer than the radius.
fn survives(config: &Config, beat: &Record, radius2: Expr) -> Expr {
    let nearer: Vec<_> = (0..config.lanes).map(|lane| beat.get(&format!("distance{lane}")).lt(radius2)).collect();
    set(&nearer).any()
}

/// The unit; ports as in `contract::search::ports::sieve`.
#[must_use]
pub fn module(config: &Config) -> Module {
    let fields = records::candidates(config);
    let mut m = Module::new("search_sieve", "Takes out beats without a point near enough.");
    m.parameter("threads", config.threads);
    m.parameter("lanes", config.lanes);
    m.parameter("depth", config.sieve_depth());
    let start = pulse_in(&mut m, "start", &records::start(config));
    let radius = pulse_in(&mut m, "radius", &records::radius(config));
    let head = queue_in(&mut m, "candidates", &fields);
    let kept = m.instance("kept_queue", fifo(config.sieve_depth(), &layout(&fields)));
    let room = m.out(kept, "in_ready");

    // s1: the radius is there; s2: it is known whether a lane is nearer.
    let decides = m.forward("decides", 1);
    let s1_valid = m.reg_reset("s1_valid", 1, 0);
    let advance = m.wire("advance", !s1_valid | decides);
    m.next_if(s1_valid, advance, head.valid);
    let s1 = Record::from(&head).register(&mut m, "s1_", advance);
    let radius2 = radii(&mut m, config, [&start, &radius], advance, head.field("thread"));
    m.ready(&head, advance);
    let s2_valid = m.reg_reset("s2_valid", 1, 0);
    m.next_if(s2_valid, decides, s1_valid);
    let s2_survives = m.reg("s2_survives", 1);
    m.next_if(s2_survives, decides, survives(config, &s1, radius2));
    let s2 = s1.register(&mut m, "s2_", decides);
    let near = m.wire("near", s2_valid & s2_survives);

    // What is held goes when its leaf is closed or when the next beat of the leaf is kept.
    let held_valid = m.reg_reset("held_valid", 1, 0);
    let held_last = m.reg("held_last", 1);
    let closed = m.wire("closed", held_valid & held_last);
    let displaced = m.wire("displaced", closed | (held_valid & near));
    let leaves = m.wire("leaves", displaced & room);
    let proceeds = m.wire("proceeds", !displaced | room);
    m.drive(decides, !s2_valid | proceeds);

    let keep = m.wire("keep", near & proceeds);
    let last = s2.get("last");
    let ends = m.wire("ends", (s2_valid & last) & (!near & proceeds));
    let closes = m.wire("closes", ends & (held_valid & !held_last));
    m.next(held_valid, keep | (held_valid & !leaves));
    m.next_if(held_last, keep | closes, last);
    let others: Vec<_> = fields.iter().filter(|(name, _)| name != "last").cloned().collect();
    let held = s2.only(&others).register(&mut m, "held_", keep);
    let held = Record::new(&fields, |name| if name == "last" { held_last.expr() } else { held.get(name) });
    m.connect(kept, "in_valid", leaves);
    held.connect(&mut m, kept, "in_");
    let out = m.stream_from(kept, "out");
    m.stream_export("kept", &out);
    registered_pulse_out(&mut m, "skipped", ends & !closes, &s2.only(&records::thread_only(config)));
    m
}
