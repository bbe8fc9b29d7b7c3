//! Read half of an AXI4 master (`docs/interfaces.md`): requests for records to bursts, beats to records; golden twin:
//! `pointcore_golden::bus::reader`.
//!
//! A request stays in `request` while its bursts are issued, one a cycle. Strides and borders are powers of two, so every burst
//! holds whole records; the lengths of the bursts under way wait in a queue to tell where `rlast` is due.

use pointcore_contract::bus::config::{BORDER_BYTES, BURST_BEATS_MAX, ID_BITS, READS_MAX};
use pointcore_contract::bus::{Layout, ports};
use pointcore_contract::splat::config::index_bits;
use pointcore_contract::unit::In;
use pointcore_contract::{Field, record};

use super::parts::beats::{Beat, Beats};
use super::{ADDRESS_BITS, INCREMENTING, LENGTH_BITS, RESPONSE_BITS, named, size_of};
use crate::stream::{fifo, skid};
use crate::units::ports::{Flow, StreamInPorts, event_out};
use crate::units::wires::{Bundle, Wires, layout};
use rtl::{Expr, Module, bit, cat, lit};

/// Records wanted.
#[record(records_max: u32)]
pub(super) struct Request {
    /// Where the first one lies.
    #[bits(ADDRESS_BITS)]
    pub address: u32,
    /// How many.
    #[bits(index_bits(*records_max + 1))]
    pub records: u32,
}

/// Where requests come in.
const REQUEST: In<Request> = In::new("request", "valid", "Records wanted.");

/// What an address channel says of a burst of records of a stride.
#[record(stride: u32)]
pub(super) struct Burst {
    /// The first record's address, in strides.
    #[bits(ADDRESS_BITS - *stride)]
    pub address: u32,
    /// One less than its beats.
    #[bits(LENGTH_BITS)]
    pub length: u8,
}

/// The length of a burst under way.
#[record(config: ())]
struct Length {
    /// One less than its beats.
    #[bits(LENGTH_BITS)]
    length: u8,
}

/// The unit for records of these fields; ports as in `contract::bus::ports::reader`.
#[must_use]
pub fn module(fields: &[Field], memory_bits: u32, records_max: u32) -> Module {
    limited(fields, memory_bits, records_max, READS_MAX)
}

/// The unit with so many bursts under way at most (at least 2): few enough for a proof to go through.
#[must_use]
pub fn limited(fields: &[Field], memory_bits: u32, records_max: u32, reads_max: u32) -> Module {
    let beats = Beats::memory(fields, memory_bits);
    let mut m = Module::new("bus_reader", "Reads records from memory in bursts.");
    m.parameter("beats", beats.count);
    m.parameter("width", memory_bits);
    m.parameter("records", records_max);
    let request = REQUEST.declare(&mut m, &records_max);
    let stride = Layout::of(fields).stride(memory_bits).ilog2();
    let chunk_records = ports::chunk_records(fields, memory_bits);
    let lengths = bursts(&mut m, &request, stride, chunk_records, memory_bits, records_max, reads_max);

    let rvalid = m.input("m_axi_rvalid", 1);
    let queue = m.instance("beat_queue", skid(&layout::<Beat>(&beats.used_bits())));
    let rready = m.out(queue, "in_ready");
    m.output("m_axi_rready", rready);
    m.input("m_axi_rid", ID_BITS);
    let rdata = m.input("m_axi_rdata", memory_bits);
    let rresp = m.input("m_axi_rresp", RESPONSE_BITS);
    let rlast = m.input("m_axi_rlast", 1);
    m.connect(queue, "in_valid", rvalid);
    Beat { data: beats.squeeze(rdata), last: rlast }.connect(&mut m, &beats.used_bits(), queue, "in_");
    let head = Flow::<Beat<Wires>>::from(&mut m, &beats.used_bits(), queue, "out");

    let record_valid = m.reg_reset("record_valid", 1, 0);
    let record_taken = m.forward("record_taken", 1);
    let advance = m.wire("advance", !record_valid | record_taken);
    let expected = lengths.as_ref().map_or(bit(true), |lengths| lengths.valid);
    let moves = m.wire("moves", head.valid & (advance & expected));
    m.drive(head.ready, advance & expected);

    // The number of the beat in its burst; its low bits are the place in the record.
    let number_bits = if lengths.is_some() { LENGTH_BITS } else { beats.place_bits() };
    let number = (number_bits > 0).then(|| m.reg_reset("number", number_bits, 0));
    let ends = match (&number, &lengths) {
        (Some(number), Some(lengths)) => number.eq(lengths.record.length),
        (Some(number), None) => number.eq_lit(beats.count as u128 - 1),
        (None, _) => bit(true),
    };
    let ends = m.wire("ends", ends);
    if let Some(number) = &number {
        m.next_if(*number, moves, ends.mux(lit(number_bits, 0), number.add_lit(1)));
    }
    if let Some(lengths) = &lengths {
        m.drive(lengths.ready, moves & ends);
    }
    let place = (beats.count > 1).then(|| number.as_ref().map(|number| number.trunc(beats.place_bits()))).flatten();
    let completes = place.map_or(bit(true), |place| place.eq_lit(beats.count as u128 - 1));
    m.next_if(record_valid, advance, moves & completes);
    let record = beats.gather(&mut m, head.record.data, place, moves);
    let ready = m.stream_out("record", record_valid, named(fields, record));
    m.drive(record_taken, ready);

    event_out(&mut m, "error", (rvalid & rready) & rresp.any());
    let misplaced = head.record.last ^ ends;
    let is_wrong = m.reg_reset("is_wrong", 1, 0);
    m.next_if(is_wrong, moves, !ends & (is_wrong | misplaced));
    event_out(&mut m, "misplaced", moves & (ends & (is_wrong | misplaced)));
    m
}

/// Splits requests into bursts on the address channel; returns the lengths of the bursts under way, unless all are the same.
fn bursts(
    m: &mut Module,
    request: &Flow<Request<Wires>>,
    stride: u32,
    chunk_records: u32,
    memory_bits: u32,
    records_max: u32,
    reads_max: u32,
) -> Option<Flow<Length<Wires>>> {
    let beat_bytes = memory_bits / 8;
    debug_assert_eq!(chunk_records << stride, BORDER_BYTES.min(BURST_BEATS_MAX * beat_bytes));
    let record_beats_log2 = stride - beat_bytes.ilog2();
    let held = m.reg_reset("held", 1, 0);
    let address = m.reg("address", ADDRESS_BITS - stride);
    let queue = m.instance("address_queue", skid(&layout::<Burst>(&stride)));
    let room = m.out(queue, "in_ready");
    let asked_address = request.record.address.bits(ADDRESS_BITS - 1, stride);
    let issues;
    let length;
    let lengths;
    if records_max == 1 {
        issues = m.wire("issues", held & room);
        let ready = m.wire("takes_request", !held | room);
        m.drive(request.ready, ready);
        m.next_if(held, ready, request.valid);
        m.next_if(address, ready, asked_address);
        length = lit(LENGTH_BITS, (1 << record_beats_log2) - 1);
        lengths = None;
    } else {
        let records = m.reg("records", request.record.records.width());
        let chunk_bits = chunk_records.ilog2();
        let width = records.width().max(chunk_bits + 1);
        let offset = address.trunc(chunk_bits).zext(width);
        let room_records = m.wire("room_records", lit(width, chunk_records.into()) - offset);
        let wanted = records.zext(width);
        let crosses = m.wire("crosses", wanted.gt(room_records));
        let burst = m.wire("burst", crosses.mux(room_records, wanted));
        let under_way = m.instance("length_queue", fifo(reads_max, &layout::<Length>(&())));
        let below_limit = m.out(under_way, "in_ready");
        issues = m.wire("issues", held & (room & below_limit));
        let ready = m.wire("takes_request", !held | (issues & !crosses));
        m.drive(request.ready, ready);
        m.next_if(held, ready, request.valid);
        // What is beyond the border begins at it.
        let next_chunk = address.bits(address.width() - 1, chunk_bits).add_lit(1);
        let beyond = cat([next_chunk, lit(chunk_bits, 0)]);
        let changes = ready | issues;
        m.next_if(address, changes, ready.mux(asked_address, beyond));
        let left = (wanted - room_records).trunc(records.width());
        m.next_if(records, changes, ready.mux(request.record.records, left));
        // At most 256 beats: one less fits the length.
        let beats = match record_beats_log2 {
            0 => burst.resize(LENGTH_BITS + 1),
            shift => cat([burst.resize(LENGTH_BITS + 1 - shift), lit(shift, 0)]),
        };
        length = m.wire("length", beats.sub_lit(1).trunc(LENGTH_BITS));
        m.connect(under_way, "in_valid", issues);
        Length { length }.connect(m, &(), under_way, "in_");
        lengths = Some(Flow::from(m, &(), under_way, "out"));
    }
    m.connect(queue, "in_valid", issues);
    Burst { address: address.expr(), length }.connect(m, &stride, queue, "in_");
    let burst = Flow::from(m, &stride, queue, "out");
    address_out(m, "m_axi_ar", &burst, stride, beat_bytes);
    lengths
}

/// Drives an address channel from a queue of record addresses and lengths.
pub(super) fn address_out(m: &mut Module, prefix: &str, burst: &Flow<Burst<Wires>>, stride: u32, beat_bytes: u32) {
    m.output(&format!("{prefix}valid"), burst.valid);
    let ready = m.input(&format!("{prefix}ready"), 1);
    m.drive(burst.ready, ready);
    let constants: [(&str, Expr); 2] = [("size", size_of(beat_bytes)), ("burst", INCREMENTING.expr())];
    m.output(&format!("{prefix}id"), lit(ID_BITS, 0));
    let Burst { address, length } = burst.record;
    let address = if stride == 0 { address } else { cat([address, lit(stride, 0)]) };
    m.output(&format!("{prefix}addr"), address);
    m.output(&format!("{prefix}len"), length);
    for (name, value) in constants {
        m.output(&format!("{prefix}{name}"), value);
    }
}
