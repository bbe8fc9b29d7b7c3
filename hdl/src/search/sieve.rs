//! Sieve (thesis 6.5.2): takes out beats without a point near enough before the priority queues spend a cycle on them;
//! golden twin: `pointcore_golden::search::sieve`.
//!
//! The last beat that was kept waits in `held` until it is known whether the leaf's end goes along with it.

use pointcore_contract::search::Config;
use pointcore_contract::search::records::Candidates;
use pointcore_contract::search::units::sieve::PORTS;

use super::parts::radii::radii;
use super::parts::sets::set;
use crate::stream::fifo;
use crate::units::passage::Passage;
use crate::units::ports::{PulseInPorts, PulseOutPorts, StreamInPorts, StreamOutPorts, held};
use crate::units::twins::{next_twins, twins};
use crate::units::wires::{Bundle, Wires, layout};
use rtl::{Expr, Module};

/// Whether a lane is nearer than the radius.
fn survives(config: &Config, beat: &Candidates<Wires>, radius2: Expr) -> Expr {
    let nearer: Vec<_> = beat.distances[..config.lanes as usize].iter().map(|distance| distance.lt(radius2)).collect();
    set(&nearer).any()
}

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("search_sieve", "Takes out beats without a point near enough.");
    m.parameter("threads", config.threads);
    m.parameter("lanes", config.lanes);
    m.parameter("depth", config.sieve_depth());
    let start = PORTS.start.declare(&mut m, config);
    let radius = PORTS.radius.declare(&mut m, config);
    let head = PORTS.candidates.queue(&mut m, config);
    let queue = fifo(config.sieve_depth(), &layout::<Candidates>(config));
    let kept = Passage::<Candidates>::place(&mut m, "kept_queue", queue);
    let room = kept.room(&mut m);

    // s1: the radius is there; s2: it is known whether a lane is nearer. `decides` moves all of s2, `advance` all of s1; s1 and the queue
    // before it hang on other registers.
    let decides = m.forward("decides", 1);
    let decides_early = m.forward("decides_early", 1);
    let [s1_valid, s1_empty] = twins(&mut m, ["s1_valid", "s1_empty"]);
    let advance = m.wire("advance", !s1_valid | decides_early);
    next_twins(&mut m, "s1_valid_or_empty", [s1_valid, s1_empty], advance.mux(head.valid, s1_valid));
    let s1 = head.record.register(&mut m, config, "s1_", advance);
    let radius2 = radii(&mut m, config, [start.into(), radius.into()], advance, head.record.place.thread.thread);
    m.drive(head.ready, s1_empty | decides_early);
    let [s2_valid, s2_empty] = twins(&mut m, ["s2_valid", "s2_empty"]);
    next_twins(&mut m, "s2_valid_or_empty", [s2_valid, s2_empty], decides.mux(s1_valid, s2_valid));
    let s2_survives = m.reg("s2_survives", 1);
    m.next_if(s2_survives, decides, survives(config, &s1, radius2));
    let s2 = s1.register(&mut m, config, "s2_", decides);
    let near = m.wire("near", s2_valid & s2_survives);

    // What is held goes when its leaf is closed or when the next beat of the leaf is kept.
    let held_valid = m.reg_reset("held_valid", 1, 0);
    let held_last = m.reg("held_last", 1);
    let closed = m.wire("closed", held_valid & held_last);
    let displaced = m.wire("displaced", closed | (held_valid & near));
    let leaves = m.wire("leaves", displaced & room);
    let proceeds = m.wire("proceeds", !displaced | room);
    m.drive(decides, !s2_valid | proceeds);
    m.drive(decides_early, s2_empty | (!(held_valid & (held_last | s2_survives)) | room));
    m.assert("decides_as_early", decides.eq(decides_early));

    let keep = m.wire("keep", near & proceeds);
    let last = s2.place.last;
    let ends = m.wire("ends", (s2_valid & last) & (!near & proceeds));
    let closes = m.wire("closes", ends & (held_valid & !held_last));
    m.next(held_valid, keep | (held_valid & !leaves));
    m.next_if(held_last, keep | closes, last);
    let mut held = s2;
    held.place.last = held_last.expr();
    held.place.thread = s2.place.thread.register(&mut m, config, "held_", keep);
    held.place.address = self::held(&mut m, "held_address", keep, s2.place.address);
    for (lane, distance) in held.distances[..config.lanes as usize].iter_mut().enumerate() {
        *distance = self::held(&mut m, &format!("held_distance{lane}"), keep, *distance);
    }
    kept.push(&mut m, config, leaves, held);
    let out = kept.out(&mut m, config);
    PORTS.kept.export(&mut m, config, out);
    PORTS.skipped.registered(&mut m, config, ends & !closes, s2.place.thread);
    m
}
