//! Writer: records to bursts of a stride each.

use std::marker::PhantomData;

use super::Burst;
use pointcore_contract::bus::Layout;
use pointcore_contract::{Record, Words, words};

/// The write half of a memory port.
#[derive(Clone, Debug)]
pub struct Writer<R: Record> {
    config: R::Config,
    record: PhantomData<R>,
    layout: Layout,
    beat_bytes: u32,
    stride: u32,
}

impl<R: Record<Domain = Words>> Writer<R> {
    /// For records of a kind.
    #[must_use]
    pub fn new(config: &R::Config, memory_bits: u32) -> Self {
        let layout = Layout::record::<R>(config);
        let stride = layout.stride(memory_bits);
        Self { config: config.clone(), record: PhantomData, layout, beat_bytes: memory_bits / 8, stride }
    }

    /// The burst of a record and its bytes, padding zero.
    #[must_use]
    pub fn burst(&self, address: u32, record: R) -> (Burst, Vec<u8>) {
        let bytes = self.layout.encode(&words(&self.config, record), self.stride);
        (Burst { address, beats: self.stride / self.beat_bytes }, bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::record;

    /// A flag and a word.
    #[record(config: ())]
    struct Flagged {
        /// The flag.
        a: bool,
        /// The word.
        #[bits(64)]
        b: u64,
    }

    #[test]
    fn a_record_is_a_burst_of_its_stride() {
        let (burst, bytes) = Writer::new(&(), 64).burst(0x100, Flagged { a: true, b: 0x0807_0605_0403_0201 });
        assert_eq!(burst, Burst { address: 0x100, beats: 2 });
        assert_eq!(bytes, [1, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8]);
    }
}
