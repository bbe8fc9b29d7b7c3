//! The memory of payloads behind the renderer's ports.

use crate::memory::{Bus, ExternalMemory, MemorySettings, RequestSize, WrittenBursts};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{PayloadPlace, PayloadWord, StoredWord, payload_word_bits};

/// Words that passed the ports, and what they cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PayloadTraffic {
    /// Words read.
    pub words_read: u64,
    /// Words written.
    pub words_written: u64,
    /// Bytes that the memory moved for them, whole bursts.
    pub bytes: u64,
    /// Cycles that this takes at the memory's bandwidth, and at that of the busiest port, whichever are more.
    pub busy_cycles: u64,
}

/// External memory that holds payloads in words, those of each rasterizer by themselves. Reads of a port come back in order, a word a
/// cycle at most; a read sees every write accepted before it.
///
/// Without a bandwidth among its settings, a word a cycle goes each way at every port. Else reads and writes of all ports share the bus.
#[derive(Clone)]
pub struct PayloadMemory {
    /// Words of a payload.
    beats: u32,
    word_bytes: u32,
    memory: ExternalMemory<PayloadPlace>,
    /// The bus of the writes, where they have one of their own.
    write_bus: Option<Bus>,
    ports: Vec<Port>,
}

/// What lies behind a port, and what passed it.
#[derive(Clone)]
struct Port {
    /// By place, those of a payload side by side.
    words: Vec<PayloadWord>,
    written: WrittenBursts,
    words_read: u64,
    words_written: u64,
}

impl PayloadMemory {
    /// A memory for a renderer; it has no ports where payloads are on the chip. Its answers keep their order, whatever the settings say.
    #[must_use]
    pub fn new(config: &Config, settings: MemorySettings) -> Self {
        let settings = MemorySettings { reorder_window: 1, ..settings };
        let beats = config.payload_beats;
        let word_bytes = payload_word_bytes(config);
        let ports = config.payload_ports();
        let bytes_at_once = word_bytes * ports.max(1);
        let port = Port {
            words: vec![PayloadWord::default(); (config.splats_held() * beats) as usize],
            written: WrittenBursts::new(&settings),
            words_read: 0,
            words_written: 0,
        };
        Self {
            beats,
            word_bytes,
            // Nothing is left to chance in order.
            memory: ExternalMemory::new(settings, ports as usize, bytes_at_once, 0),
            write_bus: settings.bytes_per_cycle.is_none().then(|| Bus::new(&settings, bytes_at_once)),
            ports: vec![port; ports as usize],
        }
    }

    /// How many ports there are.
    #[must_use]
    pub const fn ports(&self) -> usize {
        self.ports.len()
    }

    /// Accepts a read of a port in cycle `now`.
    pub fn request(&mut self, port: usize, place: PayloadPlace, now: u64) {
        self.memory.request(port, place, RequestSize { beats: self.beats, beat_bytes: self.word_bytes }, now);
    }

    /// Gives the bus to what waits for it; once a cycle, before what is on offer is asked for.
    pub fn advance(&mut self, now: u64) {
        self.memory.advance(now);
    }

    /// The word that is on offer at a port in cycle `now`.
    #[must_use]
    pub fn offer(&self, port: usize, now: u64) -> Option<PayloadWord> {
        let (place, beat) = self.memory.offer(port, now)?;
        Some(self.ports[port].words[self.index(place.splat, beat)])
    }

    /// The word offered at a port was taken.
    pub fn take(&mut self, port: usize) {
        self.ports[port].words_read += 1;
        self.memory.take(port);
    }

    /// Whether a write can be accepted in cycle `now`.
    #[must_use]
    pub fn is_writable(&self, now: u64) -> bool {
        self.write_bus.as_ref().unwrap_or_else(|| self.memory.bus()).is_free(now)
    }

    /// Accepts a write of a port in cycle `now`.
    pub fn write(&mut self, port: usize, write: &StoredWord, now: u64) {
        let StoredWord { splat, word, value } = *write;
        let index = self.index(splat, word.into());
        let port = &mut self.ports[port];
        port.words[index] = value;
        port.words_written += 1;
        let begin = u32::from(word) * self.word_bytes;
        let bytes = port.written.bytes(splat.into(), begin..begin + self.word_bytes);
        let bus = self.write_bus.as_mut().unwrap_or_else(|| self.memory.bus_mut());
        bus.transfer(bytes, now);
    }

    fn index(&self, splat: u16, word: u32) -> usize {
        usize::from(splat) * self.beats as usize + word as usize
    }

    /// What passed so far.
    #[must_use]
    pub fn traffic(&self) -> PayloadTraffic {
        let busiest = self.ports.iter().map(|port| port.words_read.max(port.words_written)).max().unwrap_or(0);
        let buses = || [Some(self.memory.bus()), self.write_bus.as_ref()].into_iter().flatten();
        let on_bus = buses().map(|bus| bus.busy_cycles().ceil() as u64).max().unwrap_or(0);
        PayloadTraffic {
            words_read: self.ports.iter().map(|port| port.words_read).sum(),
            words_written: self.ports.iter().map(|port| port.words_written).sum(),
            bytes: buses().map(Bus::bytes).sum(),
            busy_cycles: on_bus.max(busiest),
        }
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
        let PayloadTraffic { words_read, words_written, bytes, busy_cycles } = memory.traffic();
        assert_eq!((words_read, words_written, busy_cycles), (3, 6, 3));
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
