//! The bytes of a record, as C lays out a struct: fields in order, each in the low bits of the smallest container of 1, 2, 4
//! or 8 bytes that holds it, at a multiple of the container's size.

use crate::{Field, Record, fields};

/// Where a field lies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The field.
    pub name: String,
    /// Its bits.
    pub width: u32,
    /// First byte of its container.
    pub byte: u32,
    /// Bytes of its container.
    pub bytes: u32,
}

/// Where every field of a record lies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// The fields in order.
    pub places: Vec<Place>,
    /// Bytes up to the end of the last field.
    pub bytes: u32,
}

impl Layout {
    /// Lays out a record.
    #[must_use]
    pub fn record<R: Record>(config: &R::Config) -> Self {
        Self::of(&fields::<R>(config))
    }

    /// Lays out fields.
    #[must_use]
    pub fn of(fields: &[Field]) -> Self {
        let mut end = 0;
        let places = fields.iter().map(|Field { name, width, .. }| {
            let bytes = width.div_ceil(8).next_power_of_two();
            let byte = u32::next_multiple_of(end, bytes);
            end = byte + bytes;
            Place { name: name.clone(), width: *width, byte, bytes }
        });
        let places = places.collect();
        Self { places, bytes: end }
    }

    /// Beats of a packet: the record padded to whole beats.
    #[must_use]
    pub const fn beats(&self, beat_bits: u32) -> u32 {
        self.bytes.div_ceil(beat_bits / 8)
    }

    /// Bytes of a packet.
    #[must_use]
    pub const fn packet_bytes(&self, stream_bits: u32) -> u32 {
        self.beats(stream_bits) * (stream_bits / 8)
    }

    /// Bytes from one record in memory to the next: a power of two, no less than a beat of the memory.
    #[must_use]
    pub const fn stride(&self, memory_bits: u32) -> u32 {
        let beat = memory_bits / 8;
        let bytes = self.bytes.next_power_of_two();
        if bytes < beat { beat } else { bytes }
    }

    /// The record's bytes, padded to `bytes`; one value a field, in order.
    #[must_use]
    pub fn encode(&self, values: &[u64], bytes: u32) -> Vec<u8> {
        let mut packet = vec![0; bytes as usize];
        for (place, value) in self.places.iter().zip(values) {
            let container = &mut packet[place.byte as usize..][..place.bytes as usize];
            container.copy_from_slice(&value.to_le_bytes()[..place.bytes as usize]);
        }
        packet
    }

    /// Ones where fields are, of each those that `of` leaves of its name; zeros elsewhere.
    #[must_use]
    pub fn mask(&self, bytes: u32, of: impl Fn(&str) -> u64) -> Vec<u8> {
        let ones = |place: &Place| of(&place.name) & (u64::MAX >> (64 - place.width));
        self.encode(&self.places.iter().map(ones).collect::<Vec<_>>(), bytes)
    }

    /// The values of the fields in order; what surrounds them is ignored.
    #[must_use]
    pub fn decode(&self, packet: &[u8]) -> Vec<u64> {
        let value = |place: &Place| {
            let mut bytes = [0; 8];
            bytes[..place.bytes as usize].copy_from_slice(&packet[place.byte as usize..][..place.bytes as usize]);
            u64::from_le_bytes(bytes) & (u64::MAX >> (64 - place.width))
        };
        self.places.iter().map(value).collect()
    }
}

impl Place {
    /// The first bit of the field within the record.
    #[must_use]
    pub const fn bit(&self) -> u32 {
        self.byte * 8
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fields(widths: &[u32]) -> Vec<Field> {
        widths.iter().enumerate().map(|(index, width)| Field::new(format!("f{index}"), *width)).collect()
    }

    #[test]
    fn fields_lie_as_in_c() {
        // struct { uint8_t a; uint32_t b; uint16_t c; uint8_t d; uint64_t e; uint8_t f; }
        let layout = Layout::of(&fields(&[1, 24, 9, 8, 52, 3]));
        let places: Vec<_> = layout.places.iter().map(|place| (place.byte, place.bytes)).collect();
        assert_eq!(places, [(0, 1), (4, 4), (8, 2), (10, 1), (16, 8), (24, 1)]);
        assert_eq!(layout.bytes, 25);
        assert_eq!([32, 64, 128, 256, 512].map(|bits| layout.packet_bytes(bits)), [28, 32, 32, 32, 64]);
        assert_eq!([32, 256, 512].map(|bits| layout.stride(bits)), [32, 32, 64]);
        assert_eq!(layout.beats(64), 4);
    }

    #[test]
    fn what_is_encoded_is_decoded() {
        let layout = Layout::of(&fields(&[1, 24, 9, 8, 52, 3]));
        let values = [1, 0xab_cdef, 0x1ff, 0x80, 0xf_0123_4567_89ab, 5];
        let mut bytes = layout.encode(&values, layout.packet_bytes(64));
        assert_eq!(bytes[4..8], [0xef, 0xcd, 0xab, 0]);
        assert_eq!(layout.decode(&bytes), values);
        bytes[0] |= 0xfe;
        bytes[7] = 0xff;
        assert_eq!(layout.decode(&bytes), values, "padding is ignored");
        let mask = layout.mask(layout.packet_bytes(64), |name| if name == "f1" { !0xff } else { u64::MAX });
        assert_eq!(mask[..12], [1, 0, 0, 0, 0, 0xff, 0xff, 0, 0xff, 1, 0xff, 0]);
    }
}
