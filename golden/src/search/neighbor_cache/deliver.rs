//! Delivery: reads the neighborhoods that answer queries, a neighbor a cycle.

use super::Neighbor;
use super::entries::Entries;
use crate::stream::{Fifo, Skid};
use pointcore_contract::search::records::{CachedResult, QueryResult};

/// Answers that may wait.
const ANSWERS: usize = 4;

/// A query and the entry that answers it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Answer {
    pub(super) entry: usize,
    pub(super) number: u32,
    pub(super) cached: bool,
}

/// The delivery.
#[derive(Clone, Debug)]
pub(super) struct Deliver {
    answers: Fifo<Answer>,
    /// The answer that is sent and its next neighbor: the stage d0.
    sending: Option<(Answer, u8)>,
    /// A neighbor read: the stage d1.
    read: Option<CachedResult>,
    result: Skid<CachedResult>,
}

impl Deliver {
    pub(super) fn new() -> Self {
        Self { answers: Fifo::new(ANSWERS), sending: None, read: None, result: Skid::default() }
    }

    pub(super) fn in_ready(&self) -> bool {
        self.answers.in_ready()
    }

    pub(super) fn out(&self) -> Option<&CachedResult> {
        self.result.out()
    }

    /// One clock edge; returns the entry whose reader has read all of it.
    pub(super) fn clock(
        &mut self,
        answer: Option<Answer>,
        entries: &Entries,
        neighborhoods: &[Vec<Neighbor>],
        result_ready: bool,
    ) -> Option<usize> {
        let pushed = self.read.filter(|_| self.result.in_ready());
        let advances = self.read.is_none() || pushed.is_some();
        let takes_answer = self.sending.is_none();
        let mut released = None;
        if let Some((answer, rank)) = self.sending.take_if(|_| advances) {
            let count = entries.get(answer.entry).count;
            let found = rank < count;
            let last = rank + 1 >= count;
            let Neighbor { index, distance2 } =
                if found { neighborhoods[answer.entry][usize::from(rank)] } else { Neighbor::default() };
            let result = QueryResult { number: answer.number, last, found, index, distance2 };
            self.read = Some(CachedResult { result, cached: answer.cached });
            if last {
                released = Some(answer.entry);
            } else {
                self.sending = Some((answer, rank + 1));
            }
        } else if advances {
            self.read = None;
        }
        if takes_answer {
            self.sending = self.answers.out().map(|answer| (*answer, 0));
        }
        self.answers.step(answer, takes_answer);
        self.result.step(pushed, result_ready);
        released
    }
}
