//! Window: bursts of 64-bit words into the tree's memories.

use pointcore_contract::bus::axi::{BurstAddress, WriteBeat};

/// `INCR`.
const INCREMENTING: u8 = 1;
/// log2 of a word's bytes.
const WORD_SIZE: u8 = 3;
const WORD_BYTES: u32 = 8;
/// All bytes of a word.
const ALL_STROBES: u64 = 0xff;

/// How a burst ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// All is written.
    Okay,
    /// Refused for what it is, wholly or in part.
    RefusedBurst,
    /// Refused because the core is at work.
    RefusedBusy,
}

/// A memory of `2^index_bits` words.
#[derive(Clone, Debug)]
pub struct Window {
    index_bits: u32,
}

impl Window {
    /// An empty window.
    #[must_use]
    pub const fn new(index_bits: u32) -> Self {
        Self { index_bits }
    }

    /// A write burst: what is written, index and word, and how the burst is answered.
    #[must_use]
    pub fn write(&self, address: BurstAddress, beats: &[WriteBeat], is_locked: bool) -> (Vec<(u32, u64)>, Outcome) {
        let words = 1u64 << self.index_bits;
        let index = u64::from(address.address / WORD_BYTES);
        let count = u64::from(address.length) + 1;
        let is_plain = address.burst == INCREMENTING
            && address.size == WORD_SIZE
            && address.address.is_multiple_of(WORD_BYTES)
            && index + count <= words;
        if !is_plain {
            return (vec![], Outcome::RefusedBurst);
        }
        if is_locked {
            return (vec![], Outcome::RefusedBusy);
        }
        let mut written = vec![];
        for (place, beat) in (0..count).zip(beats) {
            if beat.strobes == ALL_STROBES && beat.last == (place + 1 == count) {
                written.push(((index + place) as u32, beat.data));
            }
        }
        let outcome = if written.len() as u64 == count { Outcome::Okay } else { Outcome::RefusedBurst };
        (written, outcome)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_plain_bursts_are_written() {
        let window = Window::new(3);
        let good = BurstAddress { id: 0, address: 0x30, length: 1, size: 3, burst: 1 };
        let beats = [false, true].map(|last| WriteBeat { data: 7, strobes: 0xff, last });
        assert_eq!(window.write(good, &beats, false), (vec![(6, 7), (7, 7)], Outcome::Okay));
        assert_eq!(window.write(good, &beats, true), (vec![], Outcome::RefusedBusy));
        for outside in [0x38, 0x40, 0x130] {
            let outside = BurstAddress { address: outside, ..good };
            assert_eq!(window.write(outside, &beats, true), (vec![], Outcome::RefusedBurst));
        }
        let partial = [WriteBeat { strobes: 0x7f, ..beats[0] }, beats[1]];
        assert_eq!(window.write(good, &partial, false), (vec![(7, 7)], Outcome::RefusedBurst));
    }
}
