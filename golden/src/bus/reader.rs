//! Reader: requests for records to bursts, bytes to records.

use std::marker::PhantomData;

use super::Burst;
use pointcore_contract::bus::Layout;
use pointcore_contract::bus::config::{BORDER_BYTES, BURST_BEATS_MAX};
use pointcore_contract::{Record, Words, read};

/// The read half of a memory port.
#[derive(Clone, Debug)]
pub struct Reader<R: Record> {
    config: R::Config,
    record: PhantomData<R>,
    layout: Layout,
    beat_bytes: u32,
    stride: u32,
}

impl<R: Record<Domain = Words>> Reader<R> {
    /// For records of a kind.
    #[must_use]
    pub fn new(config: &R::Config, memory_bits: u32) -> Self {
        let layout = Layout::record::<R>(config);
        let stride = layout.stride(memory_bits);
        Self { config: config.clone(), record: PhantomData, layout, beat_bytes: memory_bits / 8, stride }
    }

    /// Bytes from record to record.
    #[must_use]
    pub const fn stride(&self) -> u32 {
        self.stride
    }

    /// The bursts of a request, beat by beat: a burst ends where the request does, with the 256th beat, or before a border.
    #[must_use]
    pub fn bursts(&self, address: u32, records: u32) -> Vec<Burst> {
        let end = u64::from(address) + u64::from(records) * u64::from(self.stride);
        let mut bursts: Vec<Burst> = vec![];
        let border = BORDER_BYTES.min(BURST_BEATS_MAX * self.beat_bytes);
        for beat in (u64::from(address)..end).step_by(self.beat_bytes as usize).map(|byte| byte as u32) {
            match bursts.last_mut() {
                Some(burst) if !beat.is_multiple_of(border) => burst.beats += 1,
                _ => bursts.push(Burst { address: beat, beats: 1 }),
            }
        }
        bursts
    }

    /// A record from its bytes.
    #[must_use]
    pub fn record(&self, bytes: &[u8]) -> R {
        read(&self.config, &self.layout.decode(bytes))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::record;

    /// More than four bytes.
    #[record(config: ())]
    struct Long {
        /// As many as need eight bytes.
        #[bits(33)]
        a: u64,
    }

    #[test]
    fn bursts_end_before_borders() {
        let reader = Reader::<Long>::new(&(), 32);
        assert_eq!(reader.stride(), 8);
        let bursts =
            reader.bursts(0x3f8, 130).into_iter().map(|burst| (burst.address, burst.beats)).collect::<Vec<_>>();
        assert_eq!(bursts, [(0x3f8, 2), (0x400, 256), (0x800, 2)]);
        let wide = Reader::<Long>::new(&(), 512);
        let bursts = wide.bursts(0xfc0, 2).into_iter().map(|burst| (burst.address, burst.beats)).collect::<Vec<_>>();
        assert_eq!(bursts, [(0xfc0, 1), (0x1000, 1)]);
    }
}
