//! Packets out (`docs/interfaces.md`): spreads records over the beats of an AXI4-Stream; golden twin:
//! `pointcore_golden::bus::packet_out`.

use pointcore_contract::Field;

use super::layout;
use super::parts::beats::Beats;
use super::parts::spread::spread;
use crate::units::ports::event_out;
use rtl::{Module, bit};

/// The unit; ports as in `contract::bus::ports::packet_out`.
#[must_use]
pub fn module(fields: &[Field], stream_bits: u32) -> Module {
    let beats = Beats::packet(fields, stream_bits);
    let mut m = Module::new("bus_packet_out", "Spreads records over the beats of packets.");
    m.parameter("beats", beats.count);
    m.parameter("width", stream_bits);
    let input = m.stream_in("in", &layout(fields));
    let values: Vec<_> = input.fields.iter().map(|(_, value)| *value).collect();
    let accepts = bit(true);
    let words = spread(&mut m, &beats, input.valid, &values, accepts);
    m.ready(&input, words.ready);
    m.output("m_axis_tvalid", words.out.valid);
    let tready = m.input("m_axis_tready", 1);
    m.output("m_axis_tdata", words.out.record.data);
    m.output("m_axis_tlast", words.out.record.last);
    m.drive(words.out.ready, tready);
    event_out(&mut m, "sent", words.out.transfer() & words.out.record.last);
    m.output("idle", words.idle);
    m
}
