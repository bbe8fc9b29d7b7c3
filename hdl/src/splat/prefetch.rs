//! Asks memory for the payload of copies before they are drawn, and lets them wait meanwhile; golden twin:
//! `pointcore_golden::splat::prefetch`.

use crate::stream::fifo_distributed;
use crate::units::ports::{StreamInPorts, StreamOutPorts, WordPort};
use crate::units::queue::Pushed;
use crate::units::wires::layout;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{PayloadPlace, TileCopy};
use pointcore_contract::splat::units::prefetch::PORTS;
use rtl::{Module, address_width};

/// The unit.
#[must_use]
pub fn module(config: &Config) -> Module {
    let mut m = Module::new("splat_prefetch", "Asks for payloads before their copies are drawn.");
    m.parameter("ahead", config.payload_ahead);
    let input = PORTS.input.declare(&mut m, config);
    let left = PORTS.left.declare_word(&mut m, 1);
    let queue = fifo_distributed(config.payload_ahead.max(2), &layout::<TileCopy>(config));
    let (copies, out) = Pushed::<TileCopy>::place(&mut m, config, "copies", queue);
    PORTS.out.export(&mut m, config, out);
    let reads = PORTS.read.queue(&mut m, config);

    // Copies whose payload was asked for, and has not left where it came to.
    let asked = m.reg_reset("asked", address_width(config.payload_ahead + 1), 0);
    let may_ask = m.wire("may_ask", asked.lt_lit(config.payload_ahead.into()));
    let ready = m.wire("ready", (copies.room & reads.room) & may_ask);
    m.drive(input.ready, ready);
    let takes = m.wire("takes", input.valid & ready);
    let asks = m.wire("asks", takes & !input.record.end);
    let [more, less] = [asks, left].map(|flag| flag.zext(asked.width()));
    m.next(asked, asked + more - less);
    copies.push(&mut m, config, takes, input.record);
    reads.push(&mut m, config, asks, PayloadPlace { splat: input.record.splat });
    m
}
