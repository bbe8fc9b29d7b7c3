//! Write half of an AXI4 master (`docs/interfaces.md`): records to bursts of a stride each; golden twin:
//! `pointcore_golden::bus::writer`.

use pointcore_contract::Record;
use pointcore_contract::bus::Layout;
use pointcore_contract::bus::axi::WriteBeat;
use pointcore_contract::bus::config::WRITES_MAX;
use pointcore_contract::bus::units::Addressed;
use pointcore_contract::bus::units::writer::Ports;

use super::parts::beats::{Beat, Beats};
use super::parts::spread::spread;
use super::reader::{Burst, address_out};
use super::{ADDRESS_BITS, LENGTH_BITS};
use crate::stream::skid;
use crate::units::passage::Passage;
use crate::units::ports::{ChannelInPorts, ChannelOutPorts, StreamInPorts, WordPort};
use crate::units::wires::{Bundle, layout};
use rtl::{Module, address_width, bit, lit};

/// The unit for records of these fields; ports as in `contract::bus::units::writer`.
#[must_use]
pub fn module<R: Record>(config: &R::Config, memory_bits: u32) -> Module {
    limited::<R>(config, memory_bits, WRITES_MAX)
}

/// The unit with so many writes that await their answer at most: few enough for a proof to go through.
#[must_use]
pub fn limited<R: Record>(config: &R::Config, memory_bits: u32, writes_max: u32) -> Module {
    let ports = Ports::<R>::ALL;
    let beats = Beats::memory::<R>(config, memory_bits);
    let stride = Layout::record::<R>(config).stride(memory_bits).ilog2();
    let mut m = Module::new("bus_writer", "Writes records to memory, each in a burst.");
    m.parameter("beats", beats.count);
    m.parameter("width", memory_bits);
    let input = ports.input.declare(&mut m, config);
    let Addressed { address, record } = input.record;

    let unanswered = m.reg_reset("unanswered", address_width(writes_max + 1), 0);
    let below_limit = m.wire("below_limit", !unanswered.eq_lit(writes_max.into()));
    let queue = Passage::<Burst>::place(&mut m, "address_queue", skid(&layout::<Burst>(&stride)));
    let room = queue.room(&mut m);
    let accepts = m.wire("accepts", room & below_limit);
    let words = spread(&mut m, &beats, input.valid, &record.values(config), accepts);
    m.drive(input.ready, words.ready);
    let accepted = m.wire("accepted", input.valid & words.ready);
    let first = address.bits(ADDRESS_BITS - 1, stride);
    let burst = Burst { address: first, length: lit(LENGTH_BITS, beats.count as u128 - 1) };
    queue.push(&mut m, &stride, accepted, burst);
    let burst = queue.out(&mut m, &stride);
    address_out(&mut m, ports.memory.address, &burst, stride, memory_bits / 8);

    let Beat { data, last } = words.out.record;
    let beat = WriteBeat { data, strobes: bit(true).repeat(memory_bits / 8), last };
    let wready = ports.memory.data.drive(&mut m, &memory_bits, words.out.valid, beat);
    m.drive(words.out.ready, wready);

    let (bvalid, answer) = ports.memory.answer.declare(&mut m, &(), bit(true));
    let width = unanswered.width();
    m.next(unanswered, unanswered + accepted.zext(width) - bvalid.zext(width));
    ports.error.event(&mut m, bvalid & answer.response.any());
    ports.idle.drive_word(&mut m, unanswered.is_zero());
    m
}
