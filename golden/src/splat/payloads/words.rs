//! Payloads in words.

use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{PART_BITS, Payload, PayloadWord, payload_word_bits};
use pointcore_contract::{fields, read, words};

/// How a payload is cut into words: its fields side by side, the first one on top, and zeros below the last one.
#[derive(Clone, Debug)]
pub(super) struct Words {
    config: Config,
    /// How many there are.
    pub count: u32,
    /// Bits of one.
    bits: usize,
    /// Bits of the payload's fields.
    fields: Vec<u32>,
}

impl Words {
    pub fn new(config: &Config) -> Self {
        Self {
            config: config.clone(),
            count: config.payload_beats,
            bits: payload_word_bits(config) as usize,
            fields: fields::<Payload>(config).iter().map(|field| field.width).collect(),
        }
    }

    /// The words of a payload.
    pub fn cut(&self, payload: Payload) -> Vec<PayloadWord> {
        let values = words(&self.config, payload);
        let of_field = |(&width, value): (&u32, u64)| (0..width).rev().map(move |bit| value >> bit & 1);
        let mut bits: Vec<u64> = self.fields.iter().zip(values).flat_map(of_field).collect();
        bits.resize(self.count as usize * self.bits, 0);
        bits.chunks(self.bits).map(Self::word).collect()
    }

    /// The word of these bits, the highest first.
    fn word(bits: &[u64]) -> PayloadWord {
        let mut word = PayloadWord::default();
        for (part, bits) in word.part.iter_mut().zip(bits.rchunks(PART_BITS as usize)) {
            *part = bits.iter().fold(0, |part, bit| part << 1 | bit);
        }
        word
    }

    /// The payload of these words.
    pub fn join(&self, words: &[PayloadWord]) -> Payload {
        let of_word = |word: &PayloadWord| {
            let part = word.part;
            (0..self.bits).rev().map(move |bit| part[bit / PART_BITS as usize] >> (bit % PART_BITS as usize) & 1)
        };
        let mut bits = words.iter().flat_map(of_word);
        let of_field = |width: &u32| bits.by_ref().take(*width as usize).fold(0, |value, bit| value << 1 | bit);
        let values: Vec<u64> = self.fields.iter().map(of_field).collect();
        read(&self.config, &values)
    }
}
