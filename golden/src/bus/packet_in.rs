//! Packets in: beats to records.
//!
//! A packet is judged by its `tlast` and by the range of one of its fields; a refused one leaves no trace but its count.

use pointcore_contract::Field;
use pointcore_contract::bus::Layout;
use pointcore_contract::bus::packets::FieldRange;

/// What becomes of a packet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// A good packet's fields.
    Taken(Vec<u64>),
    /// It is dropped; what of it is still to come is dropped too.
    Refused,
}

/// The receiving end of a stream of packets.
#[derive(Clone, Debug)]
pub struct PacketIn {
    layout: Layout,
    bytes: usize,
    range: Option<FieldRange>,
    gathered: Vec<u8>,
    /// A packet that is longer than it may be goes on.
    is_overlong: bool,
}

impl PacketIn {
    /// For packets of these fields.
    #[must_use]
    pub fn new(fields: &[Field], stream_bits: u32, range: Option<FieldRange>) -> Self {
        let layout = Layout::of(fields);
        let bytes = layout.packet_bytes(stream_bits) as usize;
        Self { layout, bytes, range, gathered: vec![], is_overlong: false }
    }

    /// Takes a beat; says so when a packet is decided.
    pub fn beat(&mut self, data: &[u8], tlast: bool) -> Option<Verdict> {
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

    fn judge(&self, packet: &[u8]) -> Verdict {
        let fields = self.layout.decode(packet);
        let in_range = self.range.is_none_or(|FieldRange { name, low, high }| {
            let place = self.layout.places.iter().position(|place| place.name == name);
            let value = fields[place.expect("the range is of a field")];
            (u64::from(low)..=u64::from(high)).contains(&value)
        });
        if in_range { Verdict::Taken(fields) } else { Verdict::Refused }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packets_of_a_wrong_length_are_refused_once() {
        let fields = [Field::new("a", 8), Field::new("b", 32)];
        let mut unit = PacketIn::new(&fields, 32, Some(FieldRange { name: "a", low: 1, high: 3 }));
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
            Verdict::Taken(vec![1, 7]),
            Verdict::Refused,
            Verdict::Refused,
            Verdict::Taken(vec![3, 9]),
            Verdict::Refused,
        ];
        assert_eq!(verdicts, expected);
    }
}
