//! Packets out: records to beats.

use std::marker::PhantomData;

use pointcore_contract::bus::Layout;
use pointcore_contract::{Record, Words, words};

/// The sending end of a stream of packets.
#[derive(Clone, Debug)]
pub struct PacketOut<R: Record> {
    config: R::Config,
    record: PhantomData<R>,
    layout: Layout,
    beat_bytes: usize,
    bytes: u32,
}

impl<R: Record<Domain = Words>> PacketOut<R> {
    /// For packets of a record.
    #[must_use]
    pub fn new(config: &R::Config, stream_bits: u32) -> Self {
        let layout = Layout::record::<R>(config);
        let bytes = layout.packet_bytes(stream_bits);
        Self { config: config.clone(), record: PhantomData, layout, beat_bytes: stream_bits as usize / 8, bytes }
    }

    /// The beats of a record's packet, each with its `tlast`.
    #[must_use]
    pub fn beats(&self, record: R) -> Vec<(Vec<u8>, bool)> {
        let packet = self.layout.encode(&words(&self.config, record), self.bytes);
        let count = packet.len() / self.beat_bytes;
        packet.chunks(self.beat_bytes).enumerate().map(|(index, beat)| (beat.to_vec(), index + 1 == count)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::record;

    /// Fields of several sizes.
    #[record(config: ())]
    struct Triple {
        /// Few bits.
        #[bits(3)]
        a: u8,
        /// Whole bytes.
        #[bits(32)]
        b: u32,
        /// A byte and a bit.
        #[bits(9)]
        c: u16,
    }

    #[test]
    fn a_packet_is_padded_to_whole_beats() {
        let beats = PacketOut::new(&(), 64).beats(Triple { a: 5, b: 0x0102_0304, c: 0x1ff });
        assert_eq!(beats, [(vec![5, 0, 0, 0, 4, 3, 2, 1], false), (vec![255, 1, 0, 0, 0, 0, 0, 0], true)]);
    }
}
