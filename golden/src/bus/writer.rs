//! Writer: records to bursts of a stride each.

use super::Burst;
use pointcore_contract::Field;
use pointcore_contract::bus::Layout;

/// The write half of a memory port.
#[derive(Clone, Debug)]
pub struct Writer {
    layout: Layout,
    beat_bytes: u32,
    stride: u32,
}

impl Writer {
    /// For records of these fields.
    #[must_use]
    pub fn new(fields: &[Field], memory_bits: u32) -> Self {
        let layout = Layout::of(fields);
        let stride = layout.stride(memory_bits);
        Self { layout, beat_bytes: memory_bits / 8, stride }
    }

    /// The burst of a record and its bytes, padding zero.
    #[must_use]
    pub fn burst(&self, address: u32, fields: &[u64]) -> (Burst, Vec<u8>) {
        let bytes = self.layout.encode(fields, self.stride);
        (Burst { address, beats: self.stride / self.beat_bytes }, bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_is_a_burst_of_its_stride() {
        let writer = Writer::new(&[Field::new("a", 1), Field::new("b", 64)], 64);
        let (burst, bytes) = writer.burst(0x100, &[1, 0x0807_0605_0403_0201]);
        assert_eq!(burst, Burst { address: 0x100, beats: 2 });
        assert_eq!(bytes, [1, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8]);
    }
}
