//! Packets in (`docs/interfaces.md`): gathers the beats of an AXI4-Stream into records and refuses packets of a wrong length;
//! golden twin: `pointcore_golden::bus::packet_in`.
//!
//! Packets are judged where beats come in. What passes goes through a queue of two into the registers of the record, which take
//! the next packet's first beat in the cycle in which the record leaves.

use pointcore_contract::bus::axi::PacketBeat;
use pointcore_contract::bus::packets::{FieldRange, Packet};
use pointcore_contract::bus::units::packet_in::Ports;
use pointcore_contract::{fields, record};

use super::parts::beats::Beats;
use crate::stream::skid;
use crate::units::passage::Passage;
use crate::units::ports::{ChannelInPorts, StreamOutPorts, WordPort};
use crate::units::wires::{Bundle, layout};
use rtl::{Expr, Module, Reg, bit, lit};

/// A beat that is judged.
#[record(beats: Beats)]
struct Judged {
    /// It completes a good packet.
    good: bool,
    /// Its bits without those that never hold anything.
    #[bits(beats.used_bits())]
    data: u64,
    /// Its place in its packet.
    #[when(beats.count > 1)]
    #[bits(beats.place_bits())]
    place: u32,
}

/// What tells a run's last packet.
enum Closing {
    /// A flag of its own, the field at this place.
    Flag(usize),
    /// Whoever uses the unit.
    Told(Expr),
}

/// The unit; ports as in `contract::bus::units::packet_in`. Packets with a field out of its range are refused.
#[must_use]
pub fn module<R: Packet>(config: &R::Config, stream_bits: u32) -> Module {
    let ports = Ports::<R>::ALL;
    let beats = Beats::packet::<R>(config, stream_bits);
    let mut m = Module::new("bus_packet_in", "Gathers the beats of packets into records.");
    m.parameter("beats", beats.count);
    m.parameter("width", stream_bits);
    let opens = ports.opens.declare_word(&mut m, 1);
    let closes = match R::end(config) {
        Some(end) => Closing::Flag(end),
        None => Closing::Told(ports.last.declare_word(&mut m, 1)),
    };
    let tready = m.forward("s_axis_ready", 1);
    let (tvalid, beat) = ports.packets.beats.declare(&mut m, &stream_bits, tready);
    let PacketBeat { data: tdata, last: tlast } = beat;
    let takes = m.wire("takes", tvalid & tready);

    // The place of the beat that comes in its packet; of one without end, only its end counts.
    let place = (beats.count > 1).then(|| m.reg_reset("place", beats.place_bits(), 0));
    let is_overlong = m.reg_reset("is_overlong", 1, 0);
    let at_end = place.map_or(bit(true), |place| place.eq_lit(beats.count as u128 - 1));
    let whole = m.wire("whole", takes & (tlast & (at_end & !is_overlong)));
    let wrong = takes & ((tlast ^ at_end) & !is_overlong);
    let incoming = Incoming { beats: &beats, data: tdata, place, takes };
    let names = fields::<R>(config);
    let in_range = R::ranges(config).into_iter().fold(bit(true), |all, FieldRange { field, low, high }| {
        let holds = |value: Expr| {
            let reaches = if low == 0 { bit(true) } else { value.ge_lit(low.into()) };
            reaches & !value.gt(lit(value.width(), high.into()))
        };
        all & incoming.noted(&mut m, &format!("{}_in_range", names[field].name), field, holds)
    });
    let in_range = m.wire("in_range", in_range);
    let good = m.wire("good", whole & in_range);
    m.next_if(is_overlong, takes, !tlast & (is_overlong | at_end));
    if let Some(place) = &place {
        let next = (tlast | at_end).mux(lit(beats.place_bits(), 0), place.add_lit(1));
        m.next_if(*place, takes & !is_overlong, next);
    }
    let begun = m.reg_reset("begun", 1, 0);
    m.next_if(begun, takes, !tlast);
    let closes = match closes {
        Closing::Flag(end) => incoming.noted(&mut m, "ends", end, |flag| flag),
        Closing::Told(last) => last,
    };
    let is_open = m.reg_reset("is_open", 1, 0);
    m.next(is_open, opens | (is_open & !(good & closes)));

    let queue = Passage::<Judged>::place(&mut m, "beat_queue", skid(&layout::<Judged>(&beats)));
    let room = queue.room(&mut m);
    m.drive(tready, room & (begun | is_open));
    let number = place.map_or_else(Expr::default, |place| place.expr());
    let judged = Judged { good, data: beats.squeeze(tdata), place: number };
    queue.push(&mut m, &beats, takes & !is_overlong, judged);

    let head = queue.out(&mut m, &beats);
    let out_valid = m.reg_reset("out_valid", 1, 0);
    let out_taken = m.forward("out_taken", 1);
    let advance = m.wire("advance", !out_valid | out_taken);
    m.drive(head.ready, advance);
    m.next_if(out_valid, advance, head.valid & head.record.good);
    let moves = m.wire("moves", head.transfer());
    let place = place.map(|_| head.record.place);
    let record = beats.gather(&mut m, head.record.data, place, moves);
    let ready = ports.out.drive(&mut m, config, out_valid, Bundle::from_values(config, record));
    m.drive(out_taken, ready);
    ports.taken.event(&mut m, good);
    ports.refused.event(&mut m, wrong | (whole & !in_range));
    m
}

/// A packet as it comes in.
struct Incoming<'a> {
    beats: &'a Beats,
    data: Expr,
    place: Option<Reg>,
    takes: Expr,
}

impl Incoming<'_> {
    /// What holds of a field, from its beat to the packet's last.
    fn noted(&self, m: &mut Module, name: &str, field: usize, holds: impl Fn(Expr) -> Expr) -> Expr {
        let (beat, value) = self.beats.field_in(field, self.data);
        let now = holds(value);
        let Some(place) = self.place else { return now };
        if beat + 1 == self.beats.count {
            return now;
        }
        let noted = m.reg(name, 1);
        m.next_if(noted, self.takes & place.eq_lit(beat as u128), now);
        noted.expr()
    }
}
