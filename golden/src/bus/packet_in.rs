//! Packets in: beats to records.
//!
//! A packet is judged by its `tlast` and by the ranges of its fields; a refused one leaves no trace but its count.

use pointcore_contract::bus::Layout;
use pointcore_contract::bus::packets::{FieldRange, Packet};
use pointcore_contract::{Words, read};

/// What becomes of a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict<R> {
    /// A good packet's record.
    Taken(R),
    /// It is dropped; what of it is still to come is dropped too.
    Refused,
}

/// The receiving end of a stream of packets.
#[derive(Clone, Debug)]
pub struct PacketIn<R: Packet> {
    config: R::Config,
    layout: Layout,
    bytes: usize,
    gathered: Vec<u8>,
    /// A packet that is longer than it may be goes on.
    is_overlong: bool,
}

impl<R: Packet<Domain = Words>> PacketIn<R> {
    /// For packets of a record.
    #[must_use]
    pub fn new(config: &R::Config, stream_bits: u32) -> Self {
        let layout = Layout::record::<R>(config);
        let bytes = layout.packet_bytes(stream_bits) as usize;
        Self { config: config.clone(), layout, bytes, gathered: vec![], is_overlong: false }
    }

    /// Takes a beat; says so when a packet is decided.
    pub fn beat(&mut self, data: &[u8], tlast: bool) -> Option<Verdict<R>> {
        if self.is_overlong {
            self.is_overlong = !tlast;
            return None;
        }
        self.gathered.extend_from_slice(data);
        let is_whole = self.gathered.len() == self.bytes;
        if !is_whole && !tlast {
            return None;
        }
        let packet = std::mem::take(&mut self.gathered);
        self.is_overlong = !tlast;
        Some(if is_whole && tlast { self.judge(&packet) } else { Verdict::Refused })
    }

    fn judge(&self, packet: &[u8]) -> Verdict<R> {
        let fields = self.layout.decode(packet);
        let holds = |range: &FieldRange| (range.low.into()..=range.high.into()).contains(&fields[range.field]);
        let in_range = R::ranges(&self.config).iter().all(holds);
        if in_range { Verdict::Taken(read(&self.config, &fields)) } else { Verdict::Refused }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::{places, record};

    /// Two fields, of which one has a range.
    #[record(config: ())]
    struct Pair {
        /// From 1 to 3.
        #[bits(8)]
        a: u8,
        /// Any value.
        #[bits(32)]
        b: u32,
    }

    impl Packet for Pair {
        fn ranges(config: &()) -> Vec<FieldRange> {
            places::<Self>(config).a.map(|field| FieldRange { field, low: 1, high: 3 }).into_iter().collect()
        }
    }

    #[test]
    fn packets_of_a_wrong_length_are_refused_once() {
        let mut unit = PacketIn::<Pair>::new(&(), 32);
        let mut verdicts = vec![];
        for (byte, tlast) in [
            (1, false),
            (7, true),
            (1, true),
            (2, false),
            (2, false),
            (2, false),
            (2, true),
            (3, false),
            (9, true),
            (4, false),
            (0, true),
        ] {
            verdicts.extend(unit.beat(&[byte, 0, 0, 0], tlast));
        }
        let expected = [
            Verdict::Taken(Pair { a: 1, b: 7 }),
            Verdict::Refused,
            Verdict::Refused,
            Verdict::Taken(Pair { a: 3, b: 9 }),
            Verdict::Refused,
        ];
        assert_eq!(verdicts, expected);
    }
}
