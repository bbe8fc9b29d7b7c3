//! Packets out: records to beats.

use pointcore_contract::Field;
use pointcore_contract::bus::Layout;

/// The sending end of a stream of packets.
#[derive(Clone, Debug)]
pub struct PacketOut {
    layout: Layout,
    beat_bytes: usize,
    bytes: u32,
}

impl PacketOut {
    /// For packets of these fields.
    #[must_use]
    pub fn new(fields: &[Field], stream_bits: u32) -> Self {
        let layout = Layout::of(fields);
        let bytes = layout.packet_bytes(stream_bits);
        Self { layout, beat_bytes: stream_bits as usize / 8, bytes }
    }

    /// The beats of a record's packet, each with its `tlast`.
    #[must_use]
    pub fn beats(&self, fields: &[u64]) -> Vec<(Vec<u8>, bool)> {
        let packet = self.layout.encode(fields, self.bytes);
        let count = packet.len() / self.beat_bytes;
        packet.chunks(self.beat_bytes).enumerate().map(|(index, beat)| (beat.to_vec(), index + 1 == count)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_packet_is_padded_to_whole_beats() {
        let fields = [Field::new("a", 3), Field::new("b", 32), Field::new("c", 9)];
        let beats = PacketOut::new(&fields, 64).beats(&[5, 0x0102_0304, 0x1ff]);
        assert_eq!(beats, [(vec![5, 0, 0, 0, 4, 3, 2, 1], false), (vec![255, 1, 0, 0, 0, 0, 0, 0], true)]);
    }
}
