//! The memory of payloads behind the renderer's ports.

use crate::memory::{MemorySettings, ReadWriteMemory, Traffic};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{PayloadPlace, PayloadWord, StoredWord, payload_word_bits};

/// External memory that holds payloads in words, those of each rasterizer by themselves; a read sees every write accepted before it.
#[derive(Clone)]
pub struct PayloadMemory {
    /// Words of a payload.
    beats: u32,
    /// By port and place, those of a payload side by side.
    words: Vec<Vec<PayloadWord>>,
    memory: ReadWriteMemory<PayloadPlace>,
}

impl PayloadMemory {
    /// A memory for a renderer; it has no ports where payloads are on the chip. Its answers keep their order, whatever the settings say.
    #[must_use]
    pub fn new(config: &Config, settings: MemorySettings) -> Self {
        let (beats, ports) = (config.payload_beats, config.payload_ports());
        let words = vec![PayloadWord::default(); (config.splats_held() * beats) as usize];
        Self {
            beats,
            words: vec![words; ports as usize],
            memory: ReadWriteMemory::new(settings, ports, payload_word_bytes(config)),
        }
    }

    /// How many ports there are.
    #[must_use]
    pub const fn ports(&self) -> usize {
        self.memory.ports()
    }

    /// Accepts a read of a port in cycle `now`.
    pub fn request(&mut self, port: usize, place: PayloadPlace, now: u64) {
        self.memory.request(port, place, self.beats, now);
    }

    /// Gives the bus to what waits for it; once a cycle, before what is on offer is asked for.
    pub fn advance(&mut self, now: u64) {
        self.memory.advance(now);
    }

    /// The word that is on offer at a port in cycle `now`.
    #[must_use]
    pub fn offer(&self, port: usize, now: u64) -> Option<PayloadWord> {
        let (place, beat) = self.memory.offer(port, now)?;
        Some(self.words[port][self.index(place.splat, beat)])
    }

    /// The word offered at a port was taken.
    pub fn take(&mut self, port: usize) {
        self.memory.take(port);
    }

    /// Whether a write can be accepted in cycle `now`.
    #[must_use]
    pub fn is_writable(&self, now: u64) -> bool {
        self.memory.is_writable(now)
    }

    /// Accepts a write of a port in cycle `now`.
    pub fn write(&mut self, port: usize, write: &StoredWord, now: u64) {
        let StoredWord { splat, word, value } = *write;
        let index = self.index(splat, word.into());
        self.words[port][index] = value;
        self.memory.write(port, splat.into(), word.into(), now);
    }

    fn index(&self, splat: u16, word: u32) -> usize {
        usize::from(splat) * self.beats as usize + word as usize
    }

    /// The words that passed so far.
    #[must_use]
    pub fn traffic(&self) -> Traffic {
        self.memory.traffic()
    }
}

/// Bytes that a payload's word takes in memory.
#[must_use]
pub fn payload_word_bytes(config: &Config) -> u32 {
    payload_word_bits(config).div_ceil(u8::BITS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::splat::config::PayloadStore;

    const LATENCY: u64 = 7;

    fn config() -> Config {
        Config { payload: PayloadStore::Memory, payload_beats: 3, rasterizers: 2, ..Config::default() }
    }

    fn word(number: u64) -> PayloadWord {
        let mut word = PayloadWord::default();
        word.part[0] = number;
        word
    }

    #[test]
    fn the_words_of_a_place_come_in_order_after_the_latency() {
        let settings = MemorySettings { latency_cycles: LATENCY, ..MemorySettings::default() };
        let mut memory = PayloadMemory::new(&config(), settings);
        for port in 0..2 {
            for number in 0..3 {
                let value = word(10 * port + u64::from(number));
                memory.write(port as usize, &StoredWord { splat: 5, word: number, value }, 0);
            }
        }
        memory.request(1, PayloadPlace { splat: 5 }, 1);
        let mut came = vec![];
        for now in 1..20 {
            memory.advance(now);
            assert!(memory.offer(0, now).is_none());
            if let Some(word) = memory.offer(1, now) {
                came.push((now, word.part[0]));
                memory.take(1);
            }
        }
        assert_eq!(came, [(1 + LATENCY, 10), (2 + LATENCY, 11), (3 + LATENCY, 12)]);
        let Traffic { read, written, bytes, busy_cycles } = memory.traffic();
        assert_eq!((read, written, busy_cycles), (3, 6, 3));
        assert_eq!(bytes, 9 * u64::from(payload_word_bytes(&config())));
    }

    #[test]
    fn words_of_a_place_share_bursts() {
        let config = config();
        let settings = MemorySettings { burst_bytes: 1 << 10, ..MemorySettings::default() };
        let mut memory = PayloadMemory::new(&config, settings);
        for splat in [1, 2] {
            (0..3).for_each(|number| memory.write(0, &StoredWord { splat, word: number, value: word(0) }, 0));
        }
        assert_eq!(memory.traffic().bytes, 2 << 10);
    }
}
