//! Packets out (`docs/interfaces.md`): spreads records over the beats of an AXI4-Stream; golden twin:
//! `pointcore_golden::bus::packet_out`.

use pointcore_contract::splat::Field;

use super::parts::beats::Beats;
use super::parts::spread::spread;
use crate::units::records::{Record, event_out, stream_in};
use rtl::{Module, bit};

/// The unit; ports as in `contract::bus::ports::packet_out`.
#[must_use]
pub fn module(fields: &[Field], stream_bits: u32) -> Module {
    let beats = Beats::packet(fields, stream_bits);
    let mut m = Module::new("bus_packet_out", "Spreads records over the beats of packets.");
    m.parameter("beats", beats.count);
    m.parameter("width", stream_bits);
    let input = stream_in(&mut m, "in", fields);
    let accepts = bit(true);
    let words = spread(&mut m, &beats, input.valid, &Record::from(&input), accepts);
    m.ready(&input, words.ready);
    m.output("m_axis_tvalid", words.out.valid);
    let tready = m.input("m_axis_tready", 1);
    m.output("m_axis_tdata", words.out.field("data"));
    m.output("m_axis_tlast", words.out.field("last"));
    m.ready(&words.out, tready);
    event_out(&mut m, "sent", words.out.transfer() & words.out.field("last"));
    m.output("idle", words.idle);
    m
}
