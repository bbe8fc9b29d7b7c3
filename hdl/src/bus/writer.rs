//! Write half of an AXI4 master (`docs/interfaces.md`): records to bursts of a stride each; golden twin:
//! `pointcore_golden::bus::writer`.

use pointcore_contract::Field;
use pointcore_contract::bus::Layout;
use pointcore_contract::bus::config::{ID_BITS, WRITES_MAX};

use super::parts::beats::Beats;
use super::parts::spread::spread;
use super::reader::{Burst, address_out};
use super::{ADDRESS_BITS, LENGTH_BITS, RESPONSE_BITS, layout};
use crate::stream::skid;
use crate::units::ports::{Flow, event_out};
use crate::units::wires;
use rtl::{Module, address_width, bit, lit};

/// The unit for records of these fields; ports as in `contract::bus::ports::writer`.
#[must_use]
pub fn module(fields: &[Field], memory_bits: u32) -> Module {
    limited(fields, memory_bits, WRITES_MAX)
}

/// The unit with so many writes that await their answer at most: few enough for a proof to go through.
#[must_use]
pub fn limited(fields: &[Field], memory_bits: u32, writes_max: u32) -> Module {
    let beats = Beats::memory(fields, memory_bits);
    let stride = Layout::of(fields).stride(memory_bits).ilog2();
    let mut m = Module::new("bus_writer", "Writes records to memory, each in a burst.");
    m.parameter("beats", beats.count);
    m.parameter("width", memory_bits);
    let placed = [&[Field::new("address", ADDRESS_BITS)], fields].concat();
    let input = m.stream_in("in", &layout(&placed));
    let values: Vec<_> = input.fields.iter().map(|(_, value)| *value).collect();
    let (address, values) = (values[0], &values[1..]);

    let unanswered = m.reg_reset("unanswered", address_width(writes_max + 1), 0);
    let below_limit = m.wire("below_limit", !unanswered.eq_lit(writes_max.into()));
    let queue = m.instance("address_queue", skid(&wires::layout::<Burst>(&stride)));
    let room = m.out(queue, "in_ready");
    let accepts = m.wire("accepts", room & below_limit);
    let words = spread(&mut m, &beats, input.valid, values, accepts);
    m.ready(&input, words.ready);
    let accepted = m.wire("accepted", input.valid & words.ready);
    m.connect(queue, "in_valid", accepted);
    m.connect(queue, "in_address", address.bits(ADDRESS_BITS - 1, stride));
    m.connect(queue, "in_length", lit(LENGTH_BITS, beats.count as u128 - 1));
    let burst = Flow::from(&mut m, &stride, queue, "out");
    address_out(&mut m, "m_axi_aw", &burst, stride, memory_bits / 8);

    m.output("m_axi_wvalid", words.out.valid);
    let wready = m.input("m_axi_wready", 1);
    m.drive(words.out.ready, wready);
    m.output("m_axi_wdata", words.out.record.data);
    m.output("m_axi_wstrb", bit(true).repeat(memory_bits / 8));
    m.output("m_axi_wlast", words.out.record.last);

    let bvalid = m.input("m_axi_bvalid", 1);
    m.output("m_axi_bready", bit(true));
    m.input("m_axi_bid", ID_BITS);
    let bresp = m.input("m_axi_bresp", RESPONSE_BITS);
    let width = unanswered.width();
    m.next(unanswered, unanswered + accepted.zext(width) - bvalid.zext(width));
    event_out(&mut m, "error", bvalid & bresp.any());
    m.output("idle", unanswered.is_zero());
    m
}
