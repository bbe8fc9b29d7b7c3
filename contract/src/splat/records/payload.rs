//! What the copies of a splat have in common, whole and in words.

use super::{ATTRIBUTES, ATTRIBUTES_MAX, Footprint, Moving, attribute_name};
use crate::bus::Layout;
use crate::splat::Config;
use crate::splat::config::index_bits;
use crate::{record, width};

/// Bits of a part of a word: as many as a model's integer holds.
pub const PART_BITS: u32 = u64::BITS;
/// The most numbers of 32 bits in a payload: attributes and what footprints hold.
const NUMBERS_MAX: u32 = ATTRIBUTES_MAX + 24;
/// The most parts of a word: those of a whole payload.
const PARTS_MAX: usize = (NUMBERS_MAX * u32::BITS).div_ceil(PART_BITS) as usize;

/// What the copies of a splat have in common.
#[record(config: Config)]
pub struct Payload {
    /// Footprint, where nothing moves.
    #[when(!config.has_motion())]
    pub footprint: Footprint,
    /// Footprint and depth band of a splat that may move.
    #[when(config.has_motion())]
    pub moving: Moving,
    /// Attributes.
    #[count(config.attributes())]
    #[name(attribute_name(config, i))]
    #[bits(config.attribute.width())]
    pub attributes: [u32; ATTRIBUTES],
}

/// Bits of a payload's words, of which there are [`Config::payload_beats`]; the last one is padded.
#[must_use]
pub fn payload_word_bits(config: &Config) -> u32 {
    width::<Payload>(config).div_ceil(config.payload_beats)
}

/// Parts of a payload's word.
#[must_use]
pub fn payload_parts(config: &Config) -> u32 {
    payload_word_bits(config).div_ceil(PART_BITS)
}

/// Bits of a part of a word: the last one has what is left.
fn part_bits(config: &Config, place: usize) -> u32 {
    PART_BITS.min(payload_word_bits(config) - place as u32 * PART_BITS)
}

/// A word of a payload, in parts, the lowest bits first.
#[record(config: Config)]
pub struct PayloadWord {
    /// Bits of the payload's fields, side by side.
    #[count(payload_parts(config))]
    #[bits(part_bits(config, i))]
    pub part: [u64; PARTS_MAX],
}

/// A word of a payload on its way to memory.
#[record(config: Config)]
pub struct StoredWord {
    /// The place of the payload.
    #[bits(config.splat_bits())]
    pub splat: u16,
    /// Which of its words it is.
    #[bits(index_bits(config.payload_beats))]
    pub word: u8,
    /// The word.
    pub value: PayloadWord,
}

/// The place of a payload whose words are wanted.
#[record(config: Config)]
pub struct PayloadPlace {
    /// The place.
    #[bits(config.splat_bits())]
    pub splat: u16,
}

/// Bytes that the payloads of one rasterizer take in memory with beats of so many bits: a place begins at a power of two, and so does
/// each of its words.
#[must_use]
pub fn payload_bytes(config: &Config, beat_bits: u32) -> u32 {
    let stride = Layout::record::<PayloadWord>(config).stride(beat_bits);
    stride << (config.splat_bits() + index_bits(config.payload_beats))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::splat::config::Feature;
    use crate::{FragmentDepth, fields};

    #[test]
    fn words_hold_the_widest_payload() {
        let widest = Config {
            attribute: "f32".parse().expect("a format"),
            continuous: ATTRIBUTES_MAX,
            depth: FragmentDepth::Plane,
            payload_beats: 1,
            ..Config::default()
        };
        let moving = Config { time_bins: 4, screen_filter: Feature::Off, ..widest.clone() };
        for (payload_beats, kind) in (1..=8).flat_map(|beats| [(beats, &widest), (beats, &moving)]) {
            let config = Config { payload_beats, ..kind.clone() };
            let words = width::<PayloadWord>(&config) * payload_beats;
            assert!((0..payload_beats).contains(&(words - width::<Payload>(&config))));
            assert!(fields::<PayloadWord>(&config).iter().all(|part| (1..=PART_BITS).contains(&part.width)));
        }
        assert!([widest, moving].iter().all(|config| payload_parts(config) as usize <= PARTS_MAX));
    }
}
