//! The cache between a memory and an accumulator that adds one to the weight of every pixel of a copy's tile.

use super::*;
use crate::testing::for_each_seed;
use fastrand::Rng;
use pointcore_contract::splat::records::{DrainedPixel, Fill, Pixel, PixelRun, PlacedPixel, SlotMasks, SlotPixel};
use std::collections::VecDeque;

const TILES: u32 = 64;

/// What stands around the cache, with each pixel's depth to tell whose it is.
struct Surroundings {
    memory: Vec<[Pixel; 64]>,
    beats: VecDeque<Pixel>,
    slots: Vec<[Pixel; 64]>,
    held: Vec<SlotMasks>,
    masks: SlotMasks,
    /// Pixels that were read in the cycle before, and in the one before that.
    read: Option<DrainedPixel>,
    drained: Option<DrainedPixel>,
    /// Banks that are left to the cache in this cycle, and in the next.
    sample_writes: u32,
    /// Slots of the copies under way, with their tiles and pixels.
    copies: VecDeque<(u8, u32, u64)>,
    frame_ends: bool,
    /// Copies accumulated per pixel, and the pixels that came out.
    expected: Vec<[u32; 64]>,
    finished: Vec<PlacedPixel>,
    /// Pixels read and written.
    reads: usize,
    writes: usize,
}

impl Surroundings {
    fn new(config: &Config) -> Self {
        let garbage = [Pixel { weight: 99, depth: 99, ..Pixel::default() }; 64];
        Self {
            memory: vec![garbage; TILES as usize],
            beats: VecDeque::new(),
            slots: vec![garbage; config.tile_slots as usize],
            held: vec![SlotMasks { written: 99, dirty: 99 }; config.tile_slots as usize],
            masks: SlotMasks::default(),
            read: None,
            drained: None,
            sample_writes: 0,
            copies: VecDeque::new(),
            frame_ends: false,
            expected: vec![[0; 64]; TILES as usize],
            finished: Vec::new(),
            reads: 0,
            writes: 0,
        }
    }

    /// Accumulates the oldest copy once its slot is ready.
    fn retire(&mut self, slot_ready: u64) -> Option<Slot> {
        let &(slot, tile, pixels) = self.copies.front().filter(|(slot, ..)| slot_ready >> slot & 1 == 1)?;
        let held = &mut self.held[usize::from(slot)];
        for (index, pixel) in self.slots[usize::from(slot)].iter_mut().enumerate() {
            let place = u64::from(tile) << 6 | index as u64;
            if held.written >> index & 1 == 0 {
                *pixel = Pixel::default();
            }
            assert!(pixel.weight == 0 || pixel.depth == place, "slot {slot} holds another tile than {tile}");
            if pixels >> index & 1 == 1 {
                (pixel.weight, pixel.depth) = (pixel.weight + 1, place);
                self.expected[tile as usize][index] += 1;
            }
        }
        (held.written, held.dirty) = (held.written | pixels, held.dirty | pixels);
        self.copies.pop_front();
        Some(Slot { slot })
    }

    /// A cycle of the cache with what it offers and asks for. Returns whether the copy was accepted and the frame ended.
    fn step(&mut self, cache: &mut TileCache, input: Option<TileCopy>, random: &mut Rng) -> (bool, bool) {
        let out = cache.outputs();
        let retire = if random.bool() { self.retire(out.slot_ready) } else { None };
        let frame_end = self.frame_ends && self.copies.is_empty() && retire.is_none();
        self.frame_ends &= !frame_end;
        let sample_writes = std::mem::replace(&mut self.sample_writes, random.u32(0..4));
        let inputs = In {
            input,
            out_ready: random.bool(),
            read_ready: self.beats.len() < 100 && random.bool(),
            data: self.beats.front().copied().filter(|_| random.bool()),
            write_ready: random.bool(),
            pixel_ready: random.bool(),
            number: 0,
            retire,
            frame_end,
            masks: self.masks,
            sample_writes: self.sample_writes,
            sample_reads: random.u32(0..4),
            drained: self.drained,
        };
        if let Some(placed) = out.out.filter(|_| inputs.out_ready) {
            self.frame_ends = placed.copy.end;
            if !placed.copy.end {
                let pixels = random.u64(..) & random.u64(..) & random.u64(..);
                self.copies.push_back((placed.slot, placed.copy.tile, pixels));
            }
        }
        if let Some(PixelRun { tile, pixel, count }) = out.read.filter(|_| inputs.read_ready) {
            let run = usize::from(pixel)..usize::from(pixel + count);
            self.beats.extend(&self.memory[tile as usize][run]);
        }
        if inputs.data.is_some() && out.data_ready {
            self.beats.pop_front();
            self.reads += 1;
        }
        if let Some(placed) = out.write.filter(|_| inputs.write_ready) {
            self.memory[placed.tile as usize][usize::from(placed.pixel)] = placed.value;
            self.writes += 1;
        }
        self.move_slots(&out, &inputs, sample_writes);
        let pixel = out.pixel.filter(|_| inputs.pixel_ready);
        let ended = pixel.is_some_and(|pixel| pixel.end);
        self.finished.extend(pixel.filter(|_| !ended).map(|pixel| pixel.placed));
        cache.clock(&inputs);
        (out.in_ready, ended)
    }

    /// What the cache does to the slots, in the banks that are left to it.
    fn move_slots(&mut self, out: &Out, inputs: &In, sample_writes: u32) {
        let unused = |slot: u8| assert!(out.slot_ready >> slot & 1 == 0, "slot {slot} is in use");
        self.drained = self.read.take();
        if let Some(SlotPixel { slot, pixel }) = out.drain.filter(|drain| inputs.sample_reads & bank(drain.pixel) == 0)
        {
            unused(slot);
            self.read = Some(DrainedPixel { pixel, value: self.slots[usize::from(slot)][usize::from(pixel)] });
        }
        if let Some(Fill { place: SlotPixel { slot, pixel }, value }) =
            out.fill.filter(|fill| sample_writes & bank(fill.place.pixel) == 0)
        {
            unused(slot);
            self.slots[usize::from(slot)][usize::from(pixel)] = value;
        }
        if let Some(SlotChange { slot, banks, held }) = out.change {
            unused(slot);
            let masks = &mut self.held[usize::from(slot)];
            let pixels = (0..64).filter(|pixel| u32::from(banks) & !inputs.sample_reads & bank(*pixel) != 0);
            let changed = pixels.fold(0, |all, pixel| all | 1 << pixel);
            let new = |old: u64, new: u64| old & !changed | new & changed;
            self.masks.written = new(self.masks.written, masks.written);
            self.masks.dirty = new(self.masks.dirty, masks.dirty);
            *masks = SlotMasks { written: new(masks.written, held), dirty: new(masks.dirty, 0) };
        }
    }
}

#[test]
fn every_copy_reaches_its_tile_and_every_tile_comes_out() {
    for_each_seed("tile_cache", |random| {
        let config = Config { width: 64, height: 64, tile_slots: random.u32(2..6), ..Config::default() };
        let mut cache = TileCache::new(&config);
        let mut around = Surroundings::new(&config);
        for _frame in 0..3 {
            around.expected.fill([0; 64]);
            around.finished.clear();
            // Runs of a tile, as the reorder stage makes them; few tiles, so that evicted ones come back.
            let copy = |tile| TileCopy { tile: tile * 5, ..TileCopy::default() };
            let mut copies: VecDeque<_> =
                (0..100).flat_map(|_| vec![copy(random.u32(0..10)); random.usize(1..5)]).collect();
            copies.push_back(TileCopy { end: true, ..TileCopy::default() });
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
            let places = (0..TILES).flat_map(|tile| (0..64).map(move |pixel| (tile, pixel)));
            let expected = |(tile, pixel): (u32, u8)| around.expected[tile as usize][usize::from(pixel)];
            let places: Vec<_> = places.filter(|place| expected(*place) > 0).collect();
            assert_eq!(places, around.finished.iter().map(|placed| (placed.tile, placed.pixel)).collect::<Vec<_>>());
            for PlacedPixel { tile, pixel, value } in &around.finished {
                assert_eq!(value.weight, expected((*tile, *pixel)), "tile {tile}");
                assert_eq!(value.depth, u64::from(*tile) << 6 | u64::from(*pixel));
            }
        }
        let Surroundings { reads, writes, .. } = around;
        assert!(reads > 500 && writes > 500, "{reads} pixels were read and {writes} written");
    });
}
