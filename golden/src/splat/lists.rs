//! Lists: copies of a tile wait in a linked list, tiles in the order in which their lists began, and some of them are served in turn
//! (thesis 5.5.2).
//!
//! A tick is two cycles; in each a copy is appended or a list is opened, and a copy leaves. A list that was opened grows no more: what
//! comes to its tile begins another, which is not opened before the first has left.

use super::parts::share::Share;
use crate::stream::{Fifo, HalfBuffer, Skid};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::HeapEntry;
pub use pointcore_contract::splat::units::lists::{In, Out};
use std::collections::VecDeque;

/// A list that is open, from its next pointer on.
#[derive(Clone, Copy, Debug)]
struct List {
    next: HeapEntry,
    last: u16,
}

/// The lists.
#[derive(Clone, Debug)]
pub struct Lists {
    share: Share,
    tiles_in_turn: usize,
    /// The place of the tile whose list becomes empty next after reset.
    clears: Option<u32>,
    /// The last pointer of every tile's list, if it has one that was not opened.
    lasts: Vec<Option<u16>>,
    /// The pointer behind each in its list.
    links: Vec<u16>,
    /// It is the second cycle of a tick.
    second: bool,
    /// The next tick opens the list that waits first.
    opens: bool,
    opened: Option<List>,
    /// The entry that the last tick appended, and the one it follows.
    appended: Option<(HeapEntry, Option<u16>)>,
    /// First entries of the lists that were not opened.
    waiting: Fifo<HeapEntry>,
    /// The first of them.
    first: HalfBuffer<HeapEntry>,
    turns: VecDeque<List>,
    /// A list whose next pointer is looked up.
    looked_up: Option<List>,
    count: usize,
    out: Skid<HeapEntry>,
}

impl Lists {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let pointers = config.pointers() as usize;
        Self {
            share: Share::new(config),
            tiles_in_turn: config.turns() as usize,
            clears: Some(0),
            lasts: vec![None; 1 << config.place_bits()],
            links: vec![0; pointers],
            second: false,
            opens: false,
            opened: None,
            appended: None,
            waiting: Fifo::new(pointers),
            first: HalfBuffer::default(),
            turns: VecDeque::new(),
            looked_up: None,
            count: 0,
            out: Skid::default(),
        }
    }

    /// The first cycle of a tick: a list is opened, the one opened before takes its turn.
    fn open(&mut self) -> bool {
        self.turns.extend(self.opened.take());
        if self.opens {
            let next = *self.first.out().expect("what waits stays until it is opened");
            let last = self.lasts[self.share.place(next.tile) as usize].take().expect("a list that waits has an end");
            self.opened = Some(List { next, last });
        }
        self.opens
    }

    /// The second one: an entry is appended and one leaves. Returns that, and the entry that begins a list.
    fn append(&mut self, input: Option<HeapEntry>) -> [Option<HeapEntry>; 2] {
        let begins = match self.appended.take() {
            Some((HeapEntry { pointer, .. }, Some(last))) => {
                self.links[usize::from(last)] = pointer;
                None
            }
            Some((entry, None)) => Some(entry),
            None => None,
        };
        if let Some(entry) = input {
            self.appended = Some((entry, self.lasts[self.share.place(entry.tile) as usize].replace(entry.pointer)));
            self.count += 1;
        }

        let open = self.turns.len() + usize::from(self.looked_up.is_some());
        let is_open = |tile| self.turns.iter().chain(&self.looked_up).any(|list| list.next.tile == tile);
        self.opens = self.opened.is_none()
            && open < self.tiles_in_turn
            && self.first.out().is_some_and(|entry| !is_open(entry.tile));

        let leaving = if self.out.in_ready() { self.turns.pop_front() } else { None };
        self.turns.extend(self.looked_up.take());
        self.looked_up = leaving.filter(|list| list.next.pointer != list.last).map(|mut list| {
            list.next.pointer = self.links[usize::from(list.next.pointer)];
            list
        });
        self.count -= usize::from(leaving.is_some());
        [leaving.map(|list| list.next), begins]
    }
}

impl Model for Lists {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let empty = self.count == 0 && self.out.out().is_none();
        Out { in_ready: self.second, out: self.out.out().copied(), empty }
    }

    fn clock(&mut self, inputs: &In) {
        let (mut opens, mut leaving, mut begins) = (false, None, None);
        if let Some(place) = self.clears {
            self.clears = self.share.following(place);
        } else if self.second {
            [leaving, begins] = self.append(inputs.input);
            self.second = false;
        } else {
            opens = self.open();
            self.second = true;
        }
        let first_leaves_room = self.first.in_ready();
        self.first.step(self.waiting.out().copied(), opens);
        self.waiting.step(begins, first_leaves_room);
        self.out.step(leaving, inputs.out_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::for_each_seed;

    /// Entries of few tiles fill the lists and leave.
    fn run(config: &Config, tiles: &[u32]) -> Vec<HeapEntry> {
        let mut lists = Lists::new(config);
        let mut entries = (0..).zip(tiles).map(|(pointer, &tile)| HeapEntry { tile, pointer }).peekable();
        let mut left = vec![];
        for cycle in 0..2000 {
            // Nothing leaves before all have come.
            let inputs = In { input: entries.peek().copied(), out_ready: cycle > 1000 };
            let Out { in_ready, out, .. } = lists.outputs();
            if in_ready {
                entries.next();
            }
            left.extend(out.filter(|_| inputs.out_ready));
            lists.clock(&inputs);
        }
        assert!(lists.outputs().empty && left.len() == tiles.len());
        left
    }

    #[test]
    fn tiles_take_turns() {
        let config = Config { width: 64, height: 8, tiles_in_turn: 3, ..Config::default() };
        let left = run(&config, &[7, 7, 7, 7, 1, 1, 2, 2, 3]);
        // Two of tile 7 wait in the queue behind when it is opened again.
        let tiles: Vec<_> = left.iter().map(|entry| entry.tile).collect();
        assert_eq!(tiles, [7, 7, 7, 1, 2, 7, 1, 2, 3]);
    }

    #[test]
    fn entries_of_a_tile_stay_in_order() {
        for_each_seed("lists", |random| {
            let config = Config { width: 64, height: 8, tiles_in_turn: random.u32(1..=7), ..Config::default() };
            let tiles: Vec<_> = (0..300).map(|_| random.u32(0..8)).collect();
            let mut left = run(&config, &tiles);
            left.sort_by_key(|entry| entry.tile);
            assert!(left.is_sorted_by_key(|entry| (entry.tile, entry.pointer)), "the sort is stable");
        });
    }
}
