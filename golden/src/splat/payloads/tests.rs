use super::*;
use crate::testing::for_each_seed;
use fastrand::Rng;
use pointcore_contract::splat::config::PayloadStore;
use pointcore_contract::splat::records::{PayloadWord, StoredWord};
use std::collections::{HashMap, VecDeque};

/// Cycles without a transfer after which nothing is on its way.
const QUIET_CYCLES: u32 = 60;

/// What lies between the two sides: copies leave it in any order, and ends do not. Words of their payloads are asked for then.
struct Between {
    copies: Vec<TileCopy>,
    room: usize,
    offer: Option<PlacedCopy>,
    /// What memory holds, by place.
    words: HashMap<u16, Vec<PayloadWord>>,
    data: VecDeque<PayloadWord>,
}

impl Between {
    fn takes(&self, random: &mut Rng) -> bool {
        self.copies.len() < self.room && random.u8(..4) > 0
    }

    /// What is offered to the way out.
    fn offer(&mut self, random: &mut Rng) -> Option<PlacedCopy> {
        if self.offer.is_none() && !self.copies.is_empty() && random.bool() {
            let TileCopy { bounds, diagonals, tile, splat, .. } = self.copies.remove(random.usize(..self.copies.len()));
            self.offer = Some(PlacedCopy { bounds, diagonals, tile, splat, slot: 3 });
            self.data.extend(self.words.get(&splat).into_iter().flatten());
        }
        self.offer
    }

    /// Memory takes a word; a payload begins with its first.
    fn write(&mut self, StoredWord { splat, word, value }: StoredWord) {
        let words = self.words.entry(splat).or_default();
        words.truncate(word.into());
        words.push(value);
    }
}

/// Splats of a few copies or of one for each tile, their number in an attribute and their copies' in the bounds; an end here and there.
fn copies(random: &mut Rng, tiles: u32, splats: u32) -> Vec<SplatCopy> {
    let mut copies = Vec::new();
    for splat in 0..splats {
        let count = if random.u8(..8) == 0 { tiles } else { random.u32(1..4) };
        for number in 0..count {
            let mut copy = SplatCopy { first: number == 0, tile: number, ..SplatCopy::default() };
            copy.attributes[0] = splat;
            copies.push(copy);
        }
        if random.u8(..8) == 0 {
            copies.push(SplatCopy { end: true, first: random.bool(), ..SplatCopy::default() });
        }
    }
    copies.push(SplatCopy { end: true, ..SplatCopy::default() });
    copies
}

/// Sends copies through; returns what left, and the most copies between.
fn run(payloads: &mut Payloads, sent: &[SplatCopy], room: usize, random: &mut Rng) -> (Vec<CompleteCopy>, usize) {
    let (words, data) = (HashMap::new(), VecDeque::new());
    let mut between = Between { copies: Vec::new(), room, offer: None, words, data };
    let (mut received, mut most, mut quiet, mut ends) = (Vec::new(), 0, 0, 0);
    let mut input = None;
    let mut rest = sent.iter().copied();
    while quiet < QUIET_CYCLES {
        let out = payloads.outputs();
        input = input.or_else(|| if random.u8(..4) > 0 { rest.next() } else { None });
        let (copy_ready, placed) = (between.takes(random), between.offer(random));
        let data = between.data.front().copied().filter(|_| random.bool());
        let inputs = In { input, copy_ready, placed, out_ready: random.bool(), write_ready: random.bool(), data };
        if data.is_some() && out.data_ready {
            between.data.pop_front();
        }
        if let Some(word) = out.write.filter(|_| inputs.write_ready) {
            between.write(word);
        }
        payloads.clock(&inputs);
        let before = (received.len(), between.copies.len(), input.is_some());
        received.extend(out.out.filter(|_| inputs.out_ready));
        between.copies.extend(out.copy.filter(|copy| copy_ready && !copy.end));
        ends += usize::from(copy_ready && out.copy.is_some_and(|copy| copy.end));
        between.offer = between.offer.filter(|_| !out.placed_ready);
        input = input.filter(|_| !out.in_ready);
        most = most.max(between.copies.len());
        quiet = if before == (received.len(), between.copies.len(), input.is_some()) { quiet + 1 } else { 0 };
    }
    assert!(input.is_none() && rest.next().is_none() && between.copies.is_empty(), "everything went through");
    assert_eq!(ends, sent.iter().filter(|copy| copy.end).count());
    (received, most)
}

#[test]
fn every_copy_gets_its_payload_and_every_place_is_free_again() {
    for_each_seed("payloads", |random| {
        let mut filled = 0;
        for _ in 0..20 {
            let config = Config {
                width: 32,
                height: 16,
                splat_levels: random.u32(0..=3),
                payload_beats: random.u32(1..=8),
                payload: if random.bool() { PayloadStore::Chip } else { PayloadStore::Memory },
                payload_ahead: random.u32(1..=8),
                ..Config::default()
            };
            let mut payloads = Payloads::new(&config);
            let sent = copies(random, 1 << config.tile_bits(), 60);
            let room = random.usize(1..24);
            let (received, most) = run(&mut payloads, &sent, room, random);
            filled += u32::from(most == room);
            let sent = sent.iter().filter(|copy| !copy.end);
            let mut sent: Vec<_> = sent.map(|copy| (copy.attributes[0], copy.tile)).collect();
            let mut left: Vec<_> = received.iter().map(|copy| (copy.attributes[0], copy.tile)).collect();
            sent.sort_unstable();
            left.sort_unstable();
            assert_eq!(left, sent, "{config:?}");
            assert!(received.iter().all(|copy| copy.slot == 3));
            assert_eq!(payloads.places.released(), config.splats_held() as usize, "{config:?}");
        }
        assert!((1..20).contains(&filled), "what lies between was full in {filled} of 20 runs, places in others");
    });
}

/// A copy every second cycle, as they arrive, or as often as its payload moves.
#[test]
fn copies_follow_each_other_as_fast_as_their_words() {
    for (payload_beats, interval) in [(1, 2), (2, 2), (3, 3), (8, 8)] {
        let config = Config { payload_beats, splat_levels: 4, ..Config::default() };
        let mut payloads = Payloads::new(&config);
        let copy = SplatCopy { first: true, ..SplatCopy::default() };
        let (mut placed, mut left) = (None, Vec::new());
        for cycle in 0..400_u32 {
            let out = payloads.outputs();
            payloads.clock(&In {
                input: Some(copy),
                copy_ready: placed.is_none(),
                placed,
                out_ready: true,
                ..In::default()
            });
            if placed.is_none() {
                placed = out.copy.map(|TileCopy { splat, .. }| PlacedCopy { splat, ..PlacedCopy::default() });
            } else if out.placed_ready {
                placed = None;
            }
            left.extend(out.out.map(|_| cycle));
        }
        let last = left.windows(2).skip(10).map(|pair| pair[1] - pair[0]);
        assert!(
            last.clone().all(|distance| distance == interval),
            "{payload_beats} words: {:?}",
            last.collect::<Vec<_>>()
        );
    }
}
