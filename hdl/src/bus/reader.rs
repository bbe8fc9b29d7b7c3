//! Read half of an AXI4 master (`docs/interfaces.md`): requests for records to bursts, beats to records; golden twin:
//! `pointcore_golden::bus::reader`.
//!
//! A request stays in `request` while its bursts are issued, one a cycle. Strides and borders are powers of two, so every burst
//! holds whole records; the lengths of the bursts under way wait in a queue to tell where `rlast` is due. Where all have one length
//! their number does. A beat that comes while none is under way is dropped.

use pointcore_contract::bus::axi::BurstAddress;
use pointcore_contract::bus::config::{BORDER_BYTES, BURST_BEATS_MAX, ID_BITS, READS_MAX};
use pointcore_contract::bus::units::reader::Ports;
use pointcore_contract::bus::units::{ReadRequest, chunk_records};
use pointcore_contract::bus::{ChannelOut, Layout};
use pointcore_contract::{Record, record};

use super::parts::beats::{Beat, Beats};
use super::{ADDRESS_BITS, INCREMENTING, LENGTH_BITS, size_of};
use crate::stream::{fifo, skid};
use crate::units::passage::Passage;
use crate::units::ports::{ChannelInPorts, ChannelOutPorts, Flow, StreamInPorts, StreamOutPorts, WordPort};
use crate::units::wires::{Bundle, Wires, layout};
use rtl::{Module, Reg, Wire, address_width, bit, cat, lit};

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

/// The unit for records of these fields; ports as in `contract::bus::units::reader`.
#[must_use]
pub fn module<R: Record>(config: &R::Config, memory_bits: u32, records_max: u32) -> Module {
    limited::<R>(config, memory_bits, records_max, READS_MAX)
}

/// The unit with so many bursts under way at most (at least 2): for who asks for no more, and for a proof to go through.
#[must_use]
pub fn limited<R: Record>(config: &R::Config, memory_bits: u32, records_max: u32, reads_max: u32) -> Module {
    let ports = Ports::<R>::ALL;
    let beats = Beats::memory::<R>(config, memory_bits);
    let mut m = Module::new("bus_reader", "Reads records from memory in bursts.");
    m.parameter("beats", beats.count);
    m.parameter("width", memory_bits);
    m.parameter("records", records_max);
    let request = ports.request.declare(&mut m, &records_max);
    let records = request.record.records;
    let is_within = records.any() & !lit(records.width(), records_max.into()).lt(records);
    m.assert("a_request_is_for_some_and_no_more_than_any_may_be", !request.valid | is_within);
    let stride = Layout::record::<R>(config).stride(memory_bits).ilog2();
    let chunk_records = chunk_records::<R>(config, memory_bits);
    let (burst, under_way) = bursts(&mut m, &request, stride, chunk_records, memory_bits, records_max, reads_max);
    address_out(&mut m, ports.memory.address, &burst, stride, memory_bits / 8);

    let bits = &beats.used_bits();
    let queue = Passage::<Beat>::place(&mut m, "beat_queue", skid(&layout::<Beat>(bits)));
    let rready = queue.room(&mut m);
    let (rvalid, beat) = ports.memory.data.declare(&mut m, &memory_bits, rready);
    queue.push(&mut m, bits, rvalid, Beat { data: beats.squeeze(beat.data), last: beat.last });
    let head = queue.out(&mut m, bits);

    let record_valid = m.reg_reset("record_valid", 1, 0);
    let record_taken = m.forward("record_taken", 1);
    let advance = m.wire("advance", !record_valid | record_taken);
    let expected = match &under_way {
        UnderWay::Lengths(lengths) => lengths.valid,
        UnderWay::Count { count, .. } => count.any(),
    };
    let moves = m.wire("moves", head.valid & (advance & expected));
    m.drive(head.ready, advance | !expected);

    // The number of the beat in its burst; its low bits are the place in the record.
    let number_bits = if matches!(under_way, UnderWay::Lengths(_)) { LENGTH_BITS } else { beats.place_bits() };
    let number = (number_bits > 0).then(|| m.reg_reset("number", number_bits, 0));
    let ends = match (&number, &under_way) {
        (Some(number), UnderWay::Lengths(lengths)) => number.eq(lengths.record.length),
        (Some(number), UnderWay::Count { .. }) => number.eq_lit(beats.count as u128 - 1),
        (None, _) => bit(true),
    };
    let ends = m.wire("ends", ends);
    if let (Some(number), UnderWay::Lengths(lengths)) = (&number, &under_way) {
        let is_within = !lengths.record.length.lt(*number);
        m.assert("no_burst_is_longer_than_asked_for", !lengths.valid | is_within);
    }
    if let Some(number) = &number {
        m.next_if(*number, moves, ends.mux(lit(number_bits, 0), number.add_lit(1)));
    }
    match &under_way {
        UnderWay::Lengths(lengths) => m.drive(lengths.ready, moves & ends),
        UnderWay::Count { ends: burst_ends, .. } => m.drive(*burst_ends, moves & ends),
    }
    let place = (beats.count > 1).then(|| number.as_ref().map(|number| number.trunc(beats.place_bits()))).flatten();
    let completes = place.map_or(bit(true), |place| place.eq_lit(beats.count as u128 - 1));
    m.next_if(record_valid, advance, moves & completes);
    let record = beats.gather(&mut m, head.record.data, place, moves);
    let ready = ports.record.drive(&mut m, config, record_valid, Bundle::from_values(config, record));
    m.drive(record_taken, ready);

    ports.error.event(&mut m, (rvalid & rready) & beat.response.any());
    let misplaced = head.record.last ^ ends;
    let is_wrong = m.reg_reset("is_wrong", 1, 0);
    m.next_if(is_wrong, moves, !ends & (is_wrong | misplaced));
    let unasked = head.valid & !expected;
    ports.misplaced.event(&mut m, unasked | (moves & (ends & (is_wrong | misplaced))));
    m
}

/// The bursts that memory has not answered.
enum UnderWay {
    /// The length of each.
    Lengths(Flow<Length<Wires>>),
    /// How many there are, where all have one length, and where the oldest ends.
    Count { count: Reg, ends: Wire },
}

/// Splits requests into bursts; returns those for the address channel, and those under way.
fn bursts(
    m: &mut Module,
    request: &Flow<ReadRequest<Wires>>,
    stride: u32,
    chunk_records: u32,
    memory_bits: u32,
    records_max: u32,
    reads_max: u32,
) -> (Flow<Burst<Wires>>, UnderWay) {
    let beat_bytes = memory_bits / 8;
    debug_assert_eq!(chunk_records << stride, BORDER_BYTES.min(BURST_BEATS_MAX * beat_bytes));
    let record_beats_log2 = stride - beat_bytes.ilog2();
    let held = m.reg_reset("held", 1, 0);
    let address = m.reg("address", ADDRESS_BITS - stride);
    let queue = Passage::<Burst>::place(m, "address_queue", skid(&layout::<Burst>(&stride)));
    let room = queue.room(m);
    let asked_address = request.record.address.bits(ADDRESS_BITS - 1, stride);
    let issues;
    let length;
    let under_way;
    if records_max == 1 {
        let count = m.reg_reset("under_way", address_width(reads_max + 1), 0);
        let below_limit = m.wire("below_limit", !count.eq_lit(reads_max.into()));
        issues = m.wire("issues", held & (room & below_limit));
        let ready = m.wire("takes_request", !held | issues);
        let ends = m.forward("burst_ends", 1);
        m.next(count, count + issues.zext(count.width()) - ends.zext(count.width()));
        m.drive(request.ready, ready);
        m.next_if(held, ready, request.valid);
        m.next_if(address, ready, asked_address);
        length = lit(LENGTH_BITS, (1 << record_beats_log2) - 1);
        under_way = UnderWay::Count { count, ends };
    } else {
        let records = m.reg("records", request.record.records.width());
        let chunk_bits = chunk_records.ilog2();
        let width = records.width().max(chunk_bits + 1);
        let offset = address.trunc(chunk_bits).zext(width);
        let room_records = m.wire("room_records", lit(width, chunk_records.into()) - offset);
        let wanted = records.zext(width);
        let crosses = m.wire("crosses", wanted.gt(room_records));
        let burst = m.wire("burst", crosses.mux(room_records, wanted));
        let queue = fifo(reads_max, &layout::<Length>(&()));
        let lengths = Passage::<Length>::place(m, "length_queue", queue);
        let below_limit = lengths.room(m);
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
        lengths.push(m, &(), issues, Length { length });
        let oldest = lengths.out(m, &());
        let beats_max = records_max.min(chunk_records) << record_beats_log2;
        if beats_max < 1 << LENGTH_BITS {
            let is_within = oldest.record.length.lt_lit(beats_max.into());
            m.assert("no_burst_is_longer_than_any_may_be", !oldest.valid | is_within);
        }
        under_way = UnderWay::Lengths(oldest);
    }
    queue.push(m, &stride, issues, Burst { address: address.expr(), length });
    (queue.out(m, &stride), under_way)
}

/// Drives an address channel from a queue of record addresses and lengths.
pub(super) fn address_out(
    m: &mut Module,
    channel: ChannelOut<BurstAddress>,
    queue: &Flow<Burst<Wires>>,
    stride: u32,
    beat_bytes: u32,
) {
    let Burst { address, length } = queue.record;
    let address = if stride == 0 { address } else { cat([address, lit(stride, 0)]) };
    let (size, burst) = (size_of(beat_bytes), INCREMENTING.expr());
    let said = BurstAddress { id: lit(ID_BITS, 0), address, length, size, burst };
    let ready = channel.drive(m, &ADDRESS_BITS, queue.valid, said);
    m.drive(queue.ready, ready);
}
