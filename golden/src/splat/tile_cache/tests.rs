//! The cache between a memory and an accumulator that adds one to the weight of every pixel of a copy's tile.

use super::*;
use crate::testing::for_each_seed;
use fastrand::Rng;
use std::collections::VecDeque;

const TILES: u32 = 64;

/// What stands around the cache, with each pixel's depth to tell whose it is.
struct Surroundings {
    memory: Vec<[Pixel; 64]>,
    beats: VecDeque<Pixel>,
    slots: Vec<[Pixel; 64]>,
    /// The pixel that was read last, and the one before.
    read: Pixel,
    drained: Pixel,
    /// Slots of the copies under way, with their tiles.
    copies: VecDeque<(u8, u32)>,
    frame_ends: bool,
    /// Copies accumulated per tile, and the pixels that came out.
    expected: Vec<u32>,
    finished: Vec<PlacedPixel>,
    evictions: usize,
}

impl Surroundings {
    fn new(config: &Config) -> Self {
        let garbage = [Pixel { weight: 99, depth: 99, ..Pixel::default() }; 64];
        Self {
            memory: vec![garbage; TILES as usize],
            beats: VecDeque::new(),
            slots: vec![garbage; config.tile_slots as usize],
            read: Pixel::default(),
            drained: Pixel::default(),
            copies: VecDeque::new(),
            frame_ends: false,
            expected: vec![0; TILES as usize],
            finished: Vec::new(),
            evictions: 0,
        }
    }

    /// Accumulates the oldest copy once its slot is ready.
    fn retire(&mut self, slot_ready: u64) -> Option<Slot> {
        let &(slot, tile) = self.copies.front().filter(|(slot, _)| slot_ready >> slot & 1 == 1)?;
        for (index, pixel) in self.slots[usize::from(slot)].iter_mut().enumerate() {
            let place = u64::from(tile) << 6 | index as u64;
            assert!(pixel.weight == 0 || pixel.depth == place, "slot {slot} holds another tile than {tile}");
            (pixel.weight, pixel.depth) = (pixel.weight + 1, place);
        }
        self.expected[tile as usize] += 1;
        self.copies.pop_front();
        Some(Slot { slot })
    }

    /// A cycle of the cache with what it offers and asks for. Returns whether the copy was accepted and the frame ended.
    fn step(&mut self, cache: &mut TileCache, input: Option<TileCopy>, random: &mut Rng) -> (bool, bool) {
        let out = cache.outputs();
        let retire = if random.bool() { self.retire(out.slot_ready) } else { None };
        let frame_end = self.frame_ends && self.copies.is_empty() && retire.is_none();
        self.frame_ends &= !frame_end;
        let inputs = In {
            input,
            out_ready: random.bool(),
            read_ready: self.beats.is_empty() && random.bool(),
            data: self.beats.front().copied().filter(|_| random.bool()),
            write_ready: random.bool(),
            pixel_ready: random.bool(),
            number: 0,
            retire,
            frame_end,
            drained: self.drained,
        };
        if let Some(placed) = out.out.filter(|_| inputs.out_ready) {
            self.frame_ends = placed.copy.end;
            if !placed.copy.end {
                self.copies.push_back((placed.slot, placed.copy.tile));
            }
        }
        if let Some(Tile { tile }) = out.read.filter(|_| inputs.read_ready) {
            self.beats.extend(self.memory[tile as usize]);
        }
        if inputs.data.is_some() && out.data_ready {
            self.beats.pop_front();
        }
        if let Some(placed) = out.write.filter(|_| inputs.write_ready) {
            self.memory[placed.tile as usize][usize::from(placed.pixel)] = placed.value;
            self.evictions += usize::from(placed.pixel == 63);
        }
        if let Some(SlotPixel { slot, pixel }) = out.drain {
            assert!(out.slot_ready >> slot & 1 == 0, "a slot in use is read");
            self.drained = std::mem::replace(&mut self.read, self.slots[usize::from(slot)][usize::from(pixel)]);
        }
        if let Some(Fill { place: SlotPixel { slot, pixel }, value }) = out.fill {
            assert!(out.slot_ready >> slot & 1 == 0, "a slot in use is written");
            self.slots[usize::from(slot)][usize::from(pixel)] = value;
        }
        let pixel = out.pixel.filter(|_| inputs.pixel_ready);
        let ended = pixel.is_some_and(|pixel| pixel.end);
        self.finished.extend(pixel.filter(|_| !ended).map(|pixel| pixel.placed));
        cache.clock(&inputs);
        (out.in_ready, ended)
    }
}

#[test]
fn every_copy_reaches_its_tile_and_every_tile_comes_out() {
    for_each_seed("tile_cache", |random| {
        let config = Config { width: 64, height: 64, tile_slots: random.u32(2..6), ..Config::default() };
        let mut cache = TileCache::new(&config);
        let mut around = Surroundings::new(&config);
        for _frame in 0..3 {
            around.expected.fill(0);
            around.finished.clear();
            // Runs of a tile, as the reorder stage makes them; few tiles, so that evicted ones come back.
            let copy = |tile| TileCopy { tile: tile * 5, ..TileCopy::default() };
            let mut copies: VecDeque<_> =
                (0..100).flat_map(|_| vec![copy(random.u32(0..10)); random.usize(1..5)]).collect();
            copies.push_back(TileCopy { end: true, ..TileCopy::default() });
            let count = copies.len() as u32 - 1;
            loop {
                let input = copies.front().copied().filter(|_| random.bool());
                let (accepted, ended) = around.step(&mut cache, input, random);
                if input.is_some() && accepted {
                    copies.pop_front();
                }
                if ended {
                    break;
                }
            }
            assert_eq!(around.expected.iter().sum::<u32>(), count);
            let touched = (0..TILES).filter(|tile| around.expected[*tile as usize] > 0);
            let places: Vec<_> = touched.flat_map(|tile| (0..64).map(move |pixel| (tile, pixel))).collect();
            assert_eq!(places, around.finished.iter().map(|placed| (placed.tile, placed.pixel)).collect::<Vec<_>>());
            for PlacedPixel { tile, pixel, value } in &around.finished {
                assert_eq!(value.weight, around.expected[*tile as usize], "tile {tile}");
                assert_eq!(value.depth, u64::from(*tile) << 6 | u64::from(*pixel));
            }
        }
        assert!(around.evictions > 50, "only {} tiles were evicted", around.evictions);
    });
}
