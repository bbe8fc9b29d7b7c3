//! Reorder stage: sorts copies by tile while many are on their way (thesis 5.5.2).
//!
//! Heap or lists sort tiles and pointers; the rest of a copy waits in a memory. An end record leaves after all copies before
//! it, and nothing after it enters until it left.

use super::heap::{self, Heap};
use super::lists::{self, Lists};
use crate::stream::{Fifo, HalfBuffer};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::config::Reordering;
use pointcore_contract::splat::records::HeapEntry;
use pointcore_contract::splat::records::TileCopy;
pub use pointcore_contract::splat::units::reorder::{In, Out};

/// What orders the pointers.
#[derive(Clone, Debug)]
enum Order {
    Heap(Heap),
    Lists(Lists),
}

impl Order {
    fn outputs(&self) -> heap::Out {
        match self {
            Self::Heap(heap) => heap.outputs(),
            Self::Lists(lists) => {
                let lists::Out { in_ready, out, empty } = lists.outputs();
                heap::Out { in_ready, out, empty }
            }
        }
    }

    fn clock(&mut self, input: Option<HeapEntry>, out_ready: bool) {
        match self {
            Self::Heap(heap) => heap.clock(&heap::In { input, out_ready }),
            Self::Lists(lists) => lists.clock(&lists::In { input, out_ready }),
        }
    }
}

/// The reorder stage.
#[derive(Clone, Debug)]
pub struct Reorder {
    input: HalfBuffer<TileCopy>,
    order: Order,
    copies: Vec<TileCopy>,
    /// Pointers never used yet count up to the number of copies.
    fresh: usize,
    returned: Fifo<u16>,
    /// The pointer that the next copy gets.
    free: Option<u16>,
    /// An end record waits for the copies before it.
    draining: bool,
    read: Option<TileCopy>,
    out: HalfBuffer<TileCopy>,
}

impl Reorder {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let pointers = config.pointers() as usize;
        Self {
            input: HalfBuffer::default(),
            order: match config.reorder {
                Reordering::Heap => Order::Heap(Heap::new(config)),
                Reordering::Lists => Order::Lists(Lists::new(config)),
            },
            copies: vec![TileCopy::default(); pointers],
            fresh: 0,
            returned: Fifo::new(pointers),
            free: None,
            draining: false,
            read: None,
            out: HalfBuffer::default(),
        }
    }
}

impl Model for Reorder {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.input.in_ready(), out: self.out.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let order = self.order.outputs();
        let head = self.input.out().filter(|_| !self.draining);
        let ends = head.is_some_and(|copy| copy.end);
        let offer = head.filter(|copy| !copy.end).and_then(|copy| {
            let pointer = self.free?;
            Some((HeapEntry { tile: copy.tile, pointer }, *copy))
        });

        // The output side, as the registers stand before this cycle.
        let has_room = self.out.in_ready();
        let advances = self.read.is_none() || has_room;
        let drained = self.draining && order.empty && self.read.is_none() && has_room;
        let pushed = if drained { Some(TileCopy { end: true, ..TileCopy::default() }) } else { self.read };
        let leaving = order.out.filter(|_| advances);
        if advances {
            self.read = leaving.map(|entry| self.copies[usize::from(entry.pointer)]);
        }

        let inserted = offer.filter(|_| order.in_ready);
        let mut takes_returned = false;
        match self.free {
            Some(_) => self.free = self.free.filter(|_| inserted.is_none()),
            None if self.fresh < self.copies.len() => {
                self.free = Some(self.fresh as u16);
                self.fresh += 1;
            }
            None => {
                self.free = self.returned.out().copied();
                takes_returned = true;
            }
        }
        self.returned.step(leaving.map(|entry| entry.pointer), takes_returned);
        if let Some((entry, copy)) = inserted {
            self.copies[usize::from(entry.pointer)] = copy;
        }
        self.draining = ends || (self.draining && !drained);
        self.order.clock(offer.map(|(entry, _)| entry), advances);
        self.input.step(inputs.input, ends || inserted.is_some());
        self.out.step(pushed, inputs.out_ready);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::for_each_seed;

    /// Frames of copies, random stalls: what leaves is what entered, frame by frame, in order of arrival within a tile.
    #[test]
    fn copies_of_a_tile_stay_in_order_and_frames_apart() {
        for_each_seed("reorder", |random| {
            let order = if random.bool() { Reordering::Heap } else { Reordering::Lists };
            let config = Config { heap_levels: 3, reorder: order, tiles_in_turn: 1, ..Config::default() };
            let mut reorder = Reorder::new(&config);
            let copy = |number: u32, random: &mut fastrand::Rng| {
                let mut copy = TileCopy { end: number % 50 == 49, tile: random.u32(0..6), ..TileCopy::default() };
                copy.splat = number as u16;
                copy
            };
            let mut sent: Vec<Vec<TileCopy>> = vec![Vec::new()];
            let mut received = sent.clone();
            let mut number = 0;
            let mut input = None;
            let mut changes = 0;
            while received.len() < 5 {
                let out = reorder.outputs();
                if input.is_none() && number < 200 && random.u8(0..4) > 0 {
                    input = Some(copy(number, random));
                    number += 1;
                }
                let out_ready = random.u8(0..4) == 0;
                if let Some(copy) = out.out.filter(|_| out_ready) {
                    let frame = received.last_mut().expect("there is a frame from the start on");
                    if copy.end {
                        received.push(Vec::new());
                    } else {
                        changes += usize::from(frame.last().is_none_or(|last| last.tile != copy.tile));
                        frame.push(copy);
                    }
                }
                reorder.clock(&In { input, out_ready });
                if let Some(copy) = input.take_if(|_| out.in_ready) {
                    let frame = sent.last_mut().expect("there is a frame from the start on");
                    if copy.end { sent.push(Vec::new()) } else { frame.push(copy) }
                }
            }
            for (sent, received) in sent.iter_mut().zip(&mut received) {
                sent.sort_by_key(|copy| copy.tile);
                received.sort_by_key(|copy| copy.tile);
                assert_eq!(sent, received, "both sorts are stable");
            }
            assert!(changes < 130, "196 copies changed the tile {changes} times");
        });
    }
}
