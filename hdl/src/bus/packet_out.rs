//! Packets out (`docs/interfaces.md`): spreads records over the beats of an AXI4-Stream; golden twin:
//! `pointcore_golden::bus::packet_out`.

use pointcore_contract::Record;
use pointcore_contract::bus::axi::PacketBeat;
use pointcore_contract::bus::units::packet_out::Ports;

use super::parts::beats::Beats;
use super::parts::spread::spread;
use crate::units::ports::{ChannelOutPorts, StreamInPorts, WordPort};
use crate::units::wires::Bundle;
use rtl::{Module, bit};

/// The unit; ports as in `contract::bus::units::packet_out`.
#[must_use]
pub fn module<R: Record>(config: &R::Config, stream_bits: u32) -> Module {
    let ports = Ports::<R>::ALL;
    let beats = Beats::packet::<R>(config, stream_bits);
    let mut m = Module::new("bus_packet_out", "Spreads records over the beats of packets.");
    m.parameter("beats", beats.count);
    m.parameter("width", stream_bits);
    let input = ports.input.declare(&mut m, config);
    let accepts = bit(true);
    let words = spread(&mut m, &beats, input.valid, &input.record.values(config), accepts);
    m.drive(input.ready, words.ready);
    let beat = PacketBeat { data: words.out.record.data, last: words.out.record.last };
    let tready = ports.packets.beats.drive(&mut m, &stream_bits, words.out.valid, beat);
    m.drive(words.out.ready, tready);
    ports.sent.event(&mut m, words.out.transfer() & words.out.record.last);
    ports.idle.drive_word(&mut m, words.idle);
    m
}
