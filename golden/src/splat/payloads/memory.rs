//! Payloads in memory behind a port: their words leave as copies come, and are asked for before their copies are drawn.

use super::Arriving;
use super::words::Words;
use crate::stream::{Fifo, HalfBuffer};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::WRITTEN_COPIES;
use pointcore_contract::splat::records::{Payload, PayloadWord, StoredWord, TileCopy};
use std::collections::VecDeque;

/// A copy that waits until memory has taken its splat's payload.
#[derive(Clone, Copy, Debug)]
struct Waiting {
    /// It is the first of its splat.
    begins: bool,
    copy: TileCopy,
}

/// What is on its way to memory and from there.
#[derive(Clone, Debug)]
pub(super) struct Memory {
    words: Words,
    /// Words of the payload that began last, which memory has not taken.
    writes: VecDeque<StoredWord>,
    waiting: Fifo<Waiting>,
    /// Splats whose payload is in memory, and whose first copy waits.
    written: u32,
    copy: HalfBuffer<TileCopy>,
    /// Words that have come from memory.
    came: Fifo<PayloadWord>,
    /// Those of them that were taken for the current copy.
    kept: Vec<PayloadWord>,
    /// The last word of a copy was taken in the last cycle.
    pub read: bool,
}

impl Memory {
    /// The unit after reset.
    pub fn new(config: &Config) -> Self {
        let words = config.payload_ahead * config.payload_beats;
        Self {
            words: Words::new(config),
            writes: VecDeque::new(),
            waiting: Fifo::new(WRITTEN_COPIES as usize),
            written: 0,
            copy: HalfBuffer::default(),
            came: Fifo::new(words.max(2) as usize),
            kept: vec![],
            read: false,
        }
    }

    /// A copy can be taken.
    pub fn has_room(&self) -> bool {
        self.waiting.in_ready()
    }

    /// The payload before has left.
    pub fn has_payload_room(&self) -> bool {
        self.writes.is_empty()
    }

    /// The copy that may go on.
    pub fn shown(&self) -> Option<TileCopy> {
        self.copy.out().copied()
    }

    /// The word for memory.
    pub fn write(&self) -> Option<StoredWord> {
        self.writes.front().copied()
    }

    /// Words can come.
    pub fn data_ready(&self) -> bool {
        self.came.in_ready()
    }

    /// The payload whose last word has come.
    pub fn payload(&self) -> Option<Payload> {
        let last = self.came.out().filter(|_| self.is_last())?;
        let words: Vec<_> = self.kept.iter().chain([last]).copied().collect();
        Some(self.words.join(&words))
    }

    fn is_last(&self) -> bool {
        self.kept.len() + 1 == self.words.count as usize
    }

    /// A cycle of the way in, in which a copy may come.
    pub fn arrive(&mut self, arriving: Option<Arriving>, copy_ready: bool, write_ready: bool) {
        let may_leave = |waiting: &Waiting| !waiting.begins || self.written > 0;
        let leaves = self.waiting.out().copied().filter(|waiting| self.copy.in_ready() && may_leave(waiting));
        self.copy.step(leaves.map(|waiting| waiting.copy), copy_ready);
        let waiting = arriving.map(|Arriving { copy, payload }| Waiting { begins: payload.is_some(), copy });
        self.waiting.step(waiting, leaves.is_some());

        let taken = if write_ready { self.writes.pop_front() } else { None };
        self.written += u32::from(taken.is_some() && self.writes.is_empty());
        self.written -= u32::from(leaves.is_some_and(|waiting| waiting.begins));
        if let Some((place, payload)) = arriving.and_then(|Arriving { copy, payload }| Some((copy.splat, payload?))) {
            let words = (0..).zip(self.words.cut(payload));
            self.writes = words.map(|(word, value)| StoredWord { splat: place, word, value }).collect();
        }
    }

    /// A cycle of the way out: there is a `current` copy, and `room` for it with its payload.
    pub fn leave(&mut self, current: bool, room: bool, data: Option<PayloadWord>) {
        let takes = current && (!self.is_last() || room);
        let taken = self.came.out().copied().filter(|_| takes);
        self.came.step(data, takes);
        self.read = taken.is_some() && self.is_last();
        if self.read {
            self.kept.clear();
        } else {
            self.kept.extend(taken);
        }
    }
}
