//! The cache between a memory and an accumulator that adds one to the weight of every pixel of a copy's tile.

use super::*;
use crate::testing::for_each_seed;
use fastrand::Rng;
use pointcore_contract::splat::records::{
    ArrivedCopy, DrainedPixel, Fill, Pixel, PixelRun, PlacedPixel, SlotMasks, SlotPixel, StoredPixel, buffer_tile,
};
use std::collections::VecDeque;

const TILES: u32 = 64;
const FRAMES: usize = 5;

/// What stands around the cache, with each pixel's depth to tell whose it is, and of which frame.
struct Surroundings {
    config: Config,
    /// Copies that come, that have come and are put in order, and those that are in order.
    coming: VecDeque<TileCopy>,
    waiting: Vec<TileCopy>,
    ordered: VecDeque<TileCopy>,
    came: bool,
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
    /// Slots of the copies under way, with their tiles, pixels and frames.
    copies: VecDeque<(u8, u32, u64, usize)>,
    /// By frame: copies accumulated per pixel, and the pixels that came out.
    expected: Vec<Vec<[u32; 64]>>,
    finished: Vec<Vec<PlacedPixel>>,
    /// Pixels that came out while a later frame was drawn, and before their own was.
    early: usize,
    late: usize,
    /// The frame that was drawn last.
    drawn: usize,
    /// Pixels read and written.
    reads: usize,
    writes: usize,
}

impl Surroundings {
    fn new(config: &Config, coming: VecDeque<TileCopy>) -> Self {
        let garbage = [Pixel { weight: 99, depth: 99, ..Pixel::default() }; 64];
        Self {
            config: config.clone(),
            coming,
            waiting: vec![],
            ordered: VecDeque::new(),
            came: false,
            memory: vec![garbage; config.buffer_tiles()],
            beats: VecDeque::new(),
            slots: vec![garbage; config.tile_slots as usize],
            held: vec![SlotMasks { written: 99, dirty: 99 }; config.tile_slots as usize],
            masks: SlotMasks::default(),
            read: None,
            drained: None,
            sample_writes: 0,
            copies: VecDeque::new(),
            expected: vec![vec![[0; 64]; TILES as usize]; FRAMES],
            finished: vec![Vec::new()],
            early: 0,
            late: 0,
            drawn: 0,
            reads: 0,
            writes: 0,
        }
    }

    /// Accumulates the oldest copy once its slot is ready.
    fn retire(&mut self, slot_ready: u64) -> Option<Slot> {
        let &(slot, tile, pixels, frame) = self.copies.front().filter(|(slot, ..)| slot_ready >> slot & 1 == 1)?;
        let held = &mut self.held[usize::from(slot)];
        for (index, pixel) in self.slots[usize::from(slot)].iter_mut().enumerate() {
            let place = (frame as u64) << 12 | u64::from(tile) << 6 | index as u64;
            if held.written >> index & 1 == 0 {
                *pixel = Pixel::default();
            }
            assert!(pixel.weight == 0 || pixel.depth == place, "slot {slot} holds another tile than {tile}");
            if pixels >> index & 1 == 1 {
                (pixel.weight, pixel.depth) = (pixel.weight + 1, place);
                self.expected[frame][tile as usize][index] += 1;
            }
        }
        (held.written, held.dirty) = (held.written | pixels, held.dirty | pixels);
        self.copies.pop_front();
        Some(Slot { slot })
    }

    /// Copies come, and one goes on: any of those that came, but in their order those of a tile, and the end behind them.
    fn order(&mut self, is_full: bool, random: &mut Rng) -> Option<ArrivedCopy> {
        if let Some(&TileCopy { tile, end, .. }) = self.waiting.get(random.usize(0..20)) {
            let place = if end { 0 } else { self.waiting.iter().position(|copy| copy.tile == tile).unwrap_or(0) };
            self.ordered.push_back(self.waiting.remove(place));
        }
        let is_closed = self.waiting.last().is_some_and(|copy| copy.end);
        self.came = !self.came && !is_full && !is_closed && self.waiting.len() < 20 && random.bool();
        let copy = if self.came { self.coming.pop_front() } else { None };
        self.waiting.extend(copy);
        copy.map(|TileCopy { end, tile, splat, .. }| ArrivedCopy { end, tile, splat })
    }

    /// A cycle of the cache with what it offers and asks for.
    fn step(&mut self, cache: &mut TileCache, random: &mut Rng) {
        let out = cache.outputs();
        let arrives = self.order(out.full, random);
        let input = self.ordered.front().copied().filter(|_| random.bool());
        let retire = if random.bool() { self.retire(out.slot_ready) } else { None };
        let sample_writes = std::mem::replace(&mut self.sample_writes, random.u32(0..4));
        let inputs = In {
            input,
            arrives,
            out_ready: random.bool(),
            read_ready: self.beats.len() < 100 && random.bool(),
            data: self.beats.front().copied().filter(|_| random.bool()),
            write_ready: random.bool(),
            pixel_ready: random.bool(),
            number: 0,
            retire,
            frame_sent: false,
            masks: self.masks,
            sample_writes: self.sample_writes,
            sample_reads: random.u32(0..4),
            drained: self.drained,
        };
        if let Some(placed) = out.out.filter(|_| inputs.out_ready) {
            let pixels = random.u64(..) & random.u64(..) & random.u64(..);
            self.drawn = usize::from(placed.splat) / 1000;
            self.copies.push_back((placed.slot, placed.tile, pixels, self.drawn));
        }
        if let Some(PixelRun { surface, tile, pixel, count }) = out.read.filter(|_| inputs.read_ready) {
            let run = usize::from(pixel)..usize::from(pixel + count);
            self.beats.extend(&self.memory[buffer_tile(&self.config, surface, tile)][run]);
        }
        if inputs.data.is_some() && out.data_ready {
            self.beats.pop_front();
            self.reads += 1;
        }
        if let Some(StoredPixel { surface, placed }) = out.write.filter(|_| inputs.write_ready) {
            self.memory[buffer_tile(&self.config, surface, placed.tile)][usize::from(placed.pixel)] = placed.value;
            self.writes += 1;
        }
        self.move_slots(&out, &inputs, sample_writes);
        if let Some(FinishedPixel { end, placed }) = out.pixel.filter(|_| inputs.pixel_ready) {
            let leaves = self.finished.len() - 1;
            self.early += usize::from(!end && (self.drawn < leaves || !self.copies.is_empty() && self.drawn == leaves));
            self.late += usize::from(self.drawn > leaves);
            if end {
                self.finished.push(vec![]);
            } else {
                self.finished[leaves].push(placed);
            }
        }
        cache.clock(&inputs);
        if input.is_some() && out.in_ready {
            self.ordered.pop_front();
        }
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
        // Few tiles, so that evicted ones come back; one frame is empty.
        let empty = random.usize(0..FRAMES);
        let mut coming = VecDeque::new();
        for frame in 0..FRAMES {
            let copies = if frame == empty { 0 } else { random.u16(50..300) };
            let first = frame as u16 * 1000;
            let mut tile = 0;
            coming.extend((first..first + copies).map(|splat| {
                tile = if random.u8(0..3) == 0 { random.u32(0..10) * 5 } else { tile };
                TileCopy { tile, splat, ..TileCopy::default() }
            }));
            coming.push_back(TileCopy { end: true, ..TileCopy::default() });
        }
        let mut around = Surroundings::new(&config, coming);
        while around.finished.len() <= FRAMES {
            around.step(&mut cache, random);
        }
        for (frame, (expected, finished)) in around.expected.iter().zip(&mut around.finished).enumerate() {
            let places = (0..TILES).flat_map(|tile| (0..64).map(move |pixel| (tile, pixel)));
            let expected = |(tile, pixel): (u32, u8)| expected[tile as usize][usize::from(pixel)];
            let places: Vec<_> = places.filter(|place| expected(*place) > 0).collect();
            finished.sort_by_key(|placed| (placed.tile, placed.pixel));
            assert_eq!(places, finished.iter().map(|placed| (placed.tile, placed.pixel)).collect::<Vec<_>>());
            for PlacedPixel { tile, pixel, value } in finished {
                assert_eq!(value.weight, expected((*tile, *pixel)), "tile {tile}");
                assert_eq!(value.depth, (frame as u64) << 12 | u64::from(*tile) << 6 | u64::from(*pixel));
            }
        }
        let Surroundings { reads, writes, early, late, .. } = around;
        assert!(reads > 500 && writes > 500, "{reads} pixels were read and {writes} written");
        assert!(early > 50 && late > 50, "{early} pixels left before their frame was drawn, {late} behind it");
    });
}
