//! The window to the tree: bursts that write it, and bursts that are refused.

use super::super::operations::{Burst, Channel, Pauses, Refusal};
use super::super::registers::{START, clear};
use super::super::script::words;
use super::memory::WORD_BYTES;
use super::runs::Host;
use pointcore_contract::bus::config::BURST_BEATS_MAX;
use pointcore_contract::bus::registers::{CONTROL, ErrorCounter, SETTINGS};
use pointcore_contract::bus::units::{window_bits, window_index_bits};
use std::collections::BTreeMap;

/// How the address of a burst goes on.
const FIXED: u32 = 0;
const INCREMENTING: u32 = 1;
const WRAPPING: u32 = 2;
const RESERVED: u32 = 3;
/// The binary logarithm of a word's bytes.
const SIZE: u32 = 3;
/// All strobes of a word.
const ALL_STROBES: u32 = 0xff;
/// Words of the longest good burst.
const LONGEST: usize = 20;
/// The address of `queries`.
const QUERIES: u32 = SETTINGS + 8;

fn burst(address: u32, data: Vec<u32>) -> Burst {
    let length = (data.len() as u32 / 2).saturating_sub(1);
    Burst { address, data, length, size: SIZE, kind: INCREMENTING, strobes: (0, ALL_STROBES), misplaced: 0 }
}

impl Host<'_> {
    fn window_bytes(&self) -> u32 {
        (2 * WORD_BYTES) << self.config.tree_depth
    }

    fn noise(&mut self, count: usize) -> Vec<u32> {
        (0..2 * count).map(|_| self.control.script.random.u32(..)).collect()
    }

    /// Writes the tree, in bursts of any length.
    pub fn write_tree(&mut self, records: &BTreeMap<u32, Vec<u8>>) {
        let records: Vec<_> = records.iter().collect();
        let mut next = 0;
        while next < records.len() {
            let longest = self.control.script.random.usize(1..=LONGEST);
            let first = *records[next].0;
            let run = records[next..].iter().zip(first..).take_while(|((number, _), expected)| **number == *expected);
            let data: Vec<u32> = run.take(longest).flat_map(|((_, bytes), _)| words(bytes)).collect();
            next += data.len() / 2;
            self.control.script.begin_burst(&burst(first * WORD_BYTES, data), true);
        }
        self.control.script.sync();
    }

    /// Bursts that are refused for what they are; nothing of them may be written but what is right.
    fn refused_bursts(&mut self) -> Vec<Burst> {
        let end = self.window_bytes();
        let four = self.noise(4);
        let plain = burst(WORD_BYTES, four);
        let mut bursts: Vec<Burst> = [FIXED, WRAPPING, RESERVED].map(|kind| Burst { kind, ..plain.clone() }).into();
        bursts.extend((0..8).filter(|size| *size != SIZE).map(|size| Burst { size, ..plain.clone() }));
        bursts.extend((1..WORD_BYTES).map(|byte| Burst { address: WORD_BYTES + byte, ..plain.clone() }));
        // Addresses beyond the end, where the port has such.
        let address_bits = window_bits(window_index_bits(self.config)).address;
        let beyond = (end.ilog2()..address_bits).map(|bit| Burst { address: 1 << bit | WORD_BYTES, ..plain.clone() });
        bursts.extend(beyond);
        let noise = self.noise(BURST_BEATS_MAX as usize);
        // Beyond the end by one word, and by as many as a burst can.
        for (address, beats) in [(end - WORD_BYTES, 2), (end - 3 * WORD_BYTES, 4), (end - WORD_BYTES, BURST_BEATS_MAX)]
        {
            bursts.push(burst(address, noise[..2 * beats as usize].to_vec()));
        }
        bursts
    }

    /// Bursts with beats that are not written; the others are the tree's.
    fn spoilt_bursts(&mut self, records: &BTreeMap<u32, Vec<u8>>) -> Vec<Burst> {
        let right: Vec<u32> =
            (1..3).flat_map(|number| records.get(&number).map_or(vec![0, 0], |bytes| words(bytes))).collect();
        let mut bursts = vec![];
        for byte in 0..WORD_BYTES {
            for strobes in [ALL_STROBES ^ 1 << byte, 1 << byte] {
                let wrong = self.noise(1);
                let data = [&right[..2], &wrong[..]].concat();
                bursts.push(Burst { strobes: (2, strobes), ..burst(WORD_BYTES, data) });
            }
        }
        for misplaced in [1, 2, 3] {
            let mut data = right.clone();
            for beat in (0..2).filter(|beat| misplaced >> beat & 1 != 0) {
                let noise = self.noise(1);
                data[2 * beat..2 * beat + 2].copy_from_slice(&noise);
            }
            bursts.push(Burst { misplaced, ..burst(WORD_BYTES, data) });
        }
        bursts.push(Burst { strobes: (3, 0), ..burst(WORD_BYTES, self.noise(2)) });
        bursts
    }

    /// Bursts of all kinds, before and after the tree is written, and a start during a burst.
    pub fn check_window(&mut self) {
        for pauses in [Pauses::None, Pauses::Some] {
            self.control.script.pauses(pauses);
            let records = self.tree(0, None);
            self.write_all();
            self.write_tree(&records);
            let bursts = [self.refused_bursts(), self.spoilt_bursts(&records)].concat();
            for (number, burst) in bursts.iter().enumerate() {
                self.control.script.begin_burst(burst, false);
                self.control.script.count(ErrorCounter::Burst);
                if number % 4 == 0 {
                    let length = [0, 2, 16, 255][number / 4 % 4];
                    let address = self.control.script.random.u32(..);
                    self.control.script.refuse_burst_read(address, length);
                }
                if number % 3 == 0 {
                    self.control.script.errors(0);
                }
            }
            self.control.script.errors(0);
            clear(self.control.script);
            // A burst may end with the window.
            let (number, bytes) = records.iter().next_back().expect("a tree has a leaf");
            self.control.script.begin_burst(&burst(number * WORD_BYTES, words(bytes)), true);
            self.control.script.errors(0);
            self.start_within_burst(&records);
        }
    }

    /// Noise in the whole window, if it is small.
    fn write_all(&mut self) {
        let all = 2 << self.config.tree_depth;
        let length = BURST_BEATS_MAX.min(all);
        let noise = self.noise(length as usize);
        for first in (0..all).step_by(length as usize).take(4) {
            self.control.script.begin_burst(&burst(first * WORD_BYTES, noise.clone()), true);
        }
        self.control.script.sync();
    }

    fn start_within_burst(&mut self, records: &BTreeMap<u32, Vec<u8>>) {
        let right: Vec<u32> = records.get(&1).map_or(vec![0, 0], |bytes| words(bytes));
        self.control.script.write(QUERIES, 1);
        self.control.script.share(Channel::WindowData, 255);
        self.control.script.begin_burst(&burst(WORD_BYTES, right), true);
        self.control.script.wait(100);
        // No waiting for the burst, which waits itself.
        self.control.script.refuse_write(CONTROL, START, 0xf, Refusal::Busy);
        self.control.script.wait(200);
        self.control.script.share(Channel::WindowData, 0);
        self.control.script.errors(0);
        clear(self.control.script);
        self.control.script.write(QUERIES, 0);
    }

    /// During a run nothing is written.
    pub fn check_locked(&mut self) {
        let noise = self.noise(4);
        for address in [0, WORD_BYTES, self.window_bytes() / 2] {
            self.control.script.begin_burst(&burst(address, noise.clone()), false);
            self.control.script.count(ErrorCounter::Busy);
        }
        // A beat that is wrong does not matter then.
        let spoilt = Burst { strobes: (1, 0x7f), misplaced: 2, ..burst(WORD_BYTES, noise.clone()) };
        self.control.script.begin_burst(&spoilt, false);
        self.control.script.count(ErrorCounter::Busy);
        // What a burst is comes first.
        for wrong in [Burst { kind: FIXED, ..burst(0, noise.clone()) }, Burst { size: 2, ..burst(0, noise) }] {
            self.control.script.begin_burst(&wrong, false);
            self.control.script.count(ErrorCounter::Burst);
        }
        self.control.script.refuse_burst_read(0, 3);
        self.control.script.sync();
    }
}
