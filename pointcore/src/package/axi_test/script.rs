//! The script that a bench on AXI plays: operations and data as words of 32 bits, and what the host has counted so far.

use super::operations::{Burst, Channel, Counted, Pauses, Refusal};
use super::registers::START;
use fastrand::Rng;
use pointcore_contract::bus::Layout;
use pointcore_contract::bus::registers::{CONTROL, COUNTERS, ERRORS, ErrorCounter, STATUS};
use std::collections::HashMap;
use std::fmt::Write as _;

/// The first word of a script.
pub const MAGIC: u32 = 0x5043_a71e;
/// Words before the data: the magic one, and where the operations begin.
const HEADER_WORDS: usize = 2;
/// All strobes of a word.
const ALL_STROBES: u32 = 0xf;
/// What registers answer.
const OKAY: u32 = 0;
const SLAVE_ERROR: u32 = 2;
/// Operations that place records which the renderer has in memory.
pub const PLACE_PAYLOADS: u8 = 35;
pub const PLACE_DEPTHS: u8 = 36;
/// Channels of the bench, by number.
const CHANNELS: u32 = 19;

/// Bytes as words of a script.
pub fn words(bytes: &[u8]) -> Vec<u32> {
    bytes.chunks(4).map(|word| word.iter().rev().fold(0, |value, byte| value << 8 | u32::from(*byte))).collect()
}

/// A script as a bench plays it.
pub struct FinishedScript {
    /// Its words.
    pub words: usize,
    /// Answers that it expects at a time at most.
    pub answers: usize,
    /// The words as `$readmemh` reads them.
    pub text: String,
}

/// A script as it grows.
pub struct Script {
    data: Vec<u32>,
    known: HashMap<Vec<u32>, u32>,
    operations: Vec<u32>,
    writes: u32,
    reads: u32,
    sent: u32,
    received: u32,
    /// Answers that were expected at a time at most.
    answers_max: usize,
    /// What the error counters hold, apart from what the bench counts.
    errors: HashMap<ErrorCounter, u32>,
    memory_is_spoilt: bool,
    /// Chooses whatever may be any.
    pub random: Rng,
}

impl Script {
    /// An empty script.
    pub fn new(seed: u64) -> Self {
        Self {
            data: vec![],
            known: HashMap::new(),
            operations: vec![],
            writes: 0,
            reads: 0,
            sent: 0,
            received: 0,
            answers_max: 0,
            errors: HashMap::new(),
            memory_is_spoilt: false,
            random: Rng::with_seed(seed),
        }
    }

    /// Places words among the data; returns where.
    pub fn data(&mut self, words: &[u32]) -> u32 {
        let place = (HEADER_WORDS + self.data.len()) as u32;
        let place = *self.known.entry(words.to_vec()).or_insert(place);
        if place as usize == HEADER_WORDS + self.data.len() {
            self.data.extend(words);
        }
        place
    }

    fn operation(&mut self, code: u32, argument: u32, operands: &[u32]) {
        self.operations.push(argument << 8 | code);
        self.operations.extend(operands);
    }

    /// Sets the pauses of a channel: of 256 cycles so many; 255 holds everything back.
    pub fn share(&mut self, channel: Channel, share: u8) {
        self.operation(1, u32::from(share) << 8 | channel as u32, &[]);
    }

    /// Sets the pauses of all channels, and how late memory answers.
    pub fn pauses(&mut self, pauses: Pauses) {
        let shares: &[u8] = match pauses {
            Pauses::None => &[0],
            Pauses::Some => &[0, 30, 128, 200, 240],
        };
        for channel in 0..CHANNELS {
            let share = shares[self.random.usize(..shares.len())];
            self.operation(1, u32::from(share) << 8 | channel, &[]);
        }
        let delay = match pauses {
            Pauses::None => 0,
            Pauses::Some => [0, 7, 31][self.random.usize(..3)],
        };
        self.operation(13, delay, &[]);
    }

    /// Lets cycles pass.
    pub fn wait(&mut self, cycles: u32) {
        self.operation(2, cycles, &[]);
    }

    /// Asks for a write, and goes on.
    pub fn begin_write(&mut self, address: u32, value: u32) {
        self.writes += 1;
        let begins_run = u32::from(address == CONTROL && value & START != 0) << 2;
        self.operation(3, (begins_run | OKAY) << 16 | ALL_STROBES << 12 | address, &[value]);
    }

    /// Asks for another frame in the run under way.
    pub fn start_ahead(&mut self) {
        self.writes += 1;
        self.operation(3, OKAY << 16 | ALL_STROBES << 12 | CONTROL, &[START]);
        self.sync();
    }

    /// Writes a register.
    pub fn write(&mut self, address: u32, value: u32) {
        self.begin_write(address, value);
        self.sync();
    }

    /// Writes with these strobes, which must be refused.
    pub fn refuse_write(&mut self, address: u32, value: u32, strobes: u32, refusal: Refusal) {
        self.writes += 1;
        self.operation(3, SLAVE_ERROR << 16 | strobes << 12 | address, &[value]);
        self.count(match refusal {
            Refusal::Access => ErrorCounter::Access,
            Refusal::Busy => ErrorCounter::Busy,
        });
    }

    /// Writes a whole register, which must be refused.
    pub fn refuse(&mut self, address: u32, value: u32, refusal: Refusal) {
        self.refuse_write(address, value, ALL_STROBES, refusal);
        self.sync();
    }

    /// Reads a register, and goes on.
    pub fn begin_read(&mut self, address: u32, value: u32) {
        self.reads += 1;
        self.operation(4, OKAY << 16 | address, &[value]);
    }

    /// Reads a register that holds this value.
    pub fn read(&mut self, address: u32, value: u32) {
        self.begin_read(address, value);
        self.sync();
    }

    /// Reads what must be refused.
    pub fn refuse_read(&mut self, address: u32) {
        self.reads += 1;
        self.operation(4, SLAVE_ERROR << 16 | address, &[0]);
        self.count(ErrorCounter::Access);
    }

    /// Reads a counter that the bench counts, too.
    pub fn read_counted(&mut self, address: u32, counted: Counted, added: u32) {
        self.reads += 1;
        self.operation(5, counted.number() << 12 | address, &[added]);
        self.sync();
    }

    /// Writes to and reads from all words from one to another, which must all be refused.
    pub fn refuse_words(&mut self, first: u32, last: u32) {
        let count = (last - first) / 4 + 1;
        self.operation(19, last << 12 | first, &[u32::MAX]);
        self.operation(20, last << 12 | first, &[]);
        (self.writes, self.reads) = (self.writes + count, self.reads + count);
        *self.errors.entry(ErrorCounter::Access).or_default() += 2 * count;
    }

    /// Waits until all accesses and bursts are answered.
    pub fn sync(&mut self) {
        self.operation(6, 0, &[]);
    }

    /// Counts an error that the core must count.
    pub fn count(&mut self, counter: ErrorCounter) {
        *self.errors.entry(counter).or_default() += 1;
    }

    /// Compares all error counters, and `status`, of which `busy` and `done` are given.
    pub fn errors(&mut self, status: u32) {
        self.sync();
        for (address, (counter, ..)) in (COUNTERS..).step_by(4).zip(ERRORS) {
            let counted = self.errors.get(&counter).copied().unwrap_or_default();
            match counter {
                ErrorCounter::Memory if self.memory_is_spoilt => {
                    self.read_counted(address, Counted::MemoryErrors, counted);
                }
                ErrorCounter::Burst if self.memory_is_spoilt => {
                    self.read_counted(address, Counted::Misplaced, counted);
                }
                _ => self.read(address, counted),
            }
        }
        let any = self.memory_is_spoilt || self.errors.values().any(|count| *count > 0);
        self.read(STATUS, u32::from(any) << 2 | status);
    }

    /// The error counters have been cleared.
    pub fn cleared(&mut self) {
        self.errors.clear();
        self.operation(23, 0, &[]);
        self.memory_is_spoilt = false;
    }

    /// The packet of a record, with noise where it holds nothing.
    pub fn packet(&mut self, layout: &Layout, values: &[u64], stream_bits: u32) -> Vec<u32> {
        let bytes = layout.packet_bytes(stream_bits);
        let held = words(&layout.mask(bytes, |_| u64::MAX));
        let sent = words(&layout.encode(values, bytes));
        sent.iter().zip(held).map(|(word, held)| word | (self.random.u32(..) & !held)).collect()
    }

    /// Sends a packet of whole words as beats.
    pub fn send(&mut self, packet: &[u32], stream_bits: u32) {
        let place = self.data(packet);
        self.sent += 1;
        self.operation(7, packet.len() as u32 / (stream_bits / 32), &[place]);
    }

    /// Waits until all packets are taken.
    pub fn wait_sent(&mut self) {
        self.operation(8, 0, &[]);
    }

    /// Expects packets: of each answer some, as they lie from a place on.
    pub fn expect(&mut self, answers: &[(u32, u32)]) {
        let operands: Vec<u32> = answers.iter().flat_map(|&(place, packets)| [place, packets]).collect();
        self.answers_max = self.answers_max.max(answers.len());
        self.received += answers.iter().map(|(_, packets)| packets).sum::<u32>();
        self.operation(9, answers.len() as u32, &operands);
    }

    /// Waits until only so many packets are missing.
    pub fn wait_received(&mut self, missing: u32) {
        self.operation(10, missing, &[]);
    }

    /// Waits for the interrupt.
    pub fn wait_interrupt(&mut self) {
        self.wait_interrupt_after(0);
    }

    /// Waits for the interrupt, before which nothing must have moved for some cycles.
    pub fn wait_interrupt_after(&mut self, still_cycles: u32) {
        self.operation(11, still_cycles, &[]);
    }

    /// Holds packets back from a beat on; without a beat, no longer.
    pub fn hold(&mut self, beat: Option<u32>) {
        self.operation(12, beat.unwrap_or_default() << 8 | u32::from(beat.is_some()), &[]);
    }

    /// Spoils answers of memory: of 256 beats so many errors, misplaced ends, and of 256 writes so many errors.
    pub fn spoil(&mut self, [responses, ends, answers]: [u8; 3]) {
        self.memory_is_spoilt |= responses > 0 || ends > 0 || answers > 0;
        self.operation(14, u32::from(answers) << 16 | u32::from(ends) << 8 | u32::from(responses), &[]);
    }

    /// Has a memory give beats that nobody asked for.
    pub fn give_unasked(&mut self, memory: u32, beats: u32) {
        self.memory_is_spoilt = true;
        self.operation(15, beats << 8 | memory, &[]);
    }

    /// Waits until these bits of `status` are low.
    pub fn wait_low(&mut self, bits: u32) {
        self.operation(16, bits, &[]);
    }

    /// The level of the interrupt.
    pub fn interrupt(&mut self, level: u32) {
        self.operation(17, level, &[]);
    }

    /// The core is in reset from here on: what is asked for until its end waits for that.
    pub fn begin_reset(&mut self) {
        self.operation(24, 0, &[]);
    }

    /// Resets the core for some cycles.
    pub fn reset(&mut self, cycles: u32) {
        self.operation(18, cycles, &[]);
        self.errors.clear();
    }

    /// Gives memories their contents.
    pub fn images(&mut self, images: [u32; 2]) {
        self.operation(21, 0, &images);
    }

    /// Nothing is under way, and so many packets have not come.
    pub fn check_quiet(&mut self, missing: u32) {
        self.operation(22, missing, &[]);
    }

    /// Writes through the window, and goes on.
    pub fn begin_burst(&mut self, burst: &Burst, is_okay: bool) {
        let data = self.data(&burst.data);
        let response = if is_okay { OKAY } else { SLAVE_ERROR };
        let id = self.random.u32(..16);
        let (beats, strobes) = burst.strobes;
        let argument = response << 17 | burst.kind << 15 | burst.size << 12 | burst.length << 4 | id;
        self.operation(32, argument, &[burst.address, data, beats, burst.misplaced, strobes]);
    }

    /// Reads through the window, which is refused.
    pub fn refuse_burst_read(&mut self, address: u32, length: u32) {
        let id = self.random.u32(..16);
        self.operation(33, length << 4 | id, &[address]);
        self.count(ErrorCounter::Burst);
    }

    /// Places an empty reconstruction buffer.
    pub fn place_buffer(&mut self, base: u32) {
        self.operation(34, 0, &[base]);
    }

    /// Places memories of payloads in which nothing is written.
    pub fn place_payloads(&mut self, base: u32) {
        self.operation(PLACE_PAYLOADS.into(), 0, &[base]);
    }

    /// Places memories of depths.
    pub fn place_depths(&mut self, base: u32) {
        self.operation(PLACE_DEPTHS.into(), 0, &[base]);
    }

    /// The whole script.
    pub fn finish(mut self) -> FinishedScript {
        let totals = [self.writes, self.reads, self.sent, self.received];
        self.operation(0, 0, &totals);
        let header = [MAGIC, (HEADER_WORDS + self.data.len()) as u32];
        let words: Vec<u32> = header.into_iter().chain(self.data).chain(self.operations).collect();
        let mut text = String::new();
        words.iter().for_each(|word| writeln!(text, "{word:x}").expect("a string can be written"));
        FinishedScript { words: words.len(), answers: self.answers_max, text }
    }
}
