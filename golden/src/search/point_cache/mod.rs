//! Point cache: keeps the points of leaves that were fetched (the shared data cache of thesis table 6.3).
//!
//! A slot a leaf, chosen by its first beat's address cut into pieces that are xor-ed. A leaf is served as a whole: from its slot,
//! or from memory in the order in which the memory answers. A leaf from memory takes its slot unless a request that may have
//! found the slot's present leaf is under way.

use crate::stream::Skid;
use crate::unit::Model;
use pointcore_contract::search::Config;
use pointcore_contract::search::records::{Beat, BeatPlace, Fetch, LANES_MAX, Point, Points};
use pointcore_contract::search::units::PointCacheEvents;
pub use pointcore_contract::search::units::point_cache::{In, Out};

/// A leaf's place in the cache.
#[derive(Clone, Debug)]
struct Slot {
    present: bool,
    /// The first beat's address of the leaf it holds or is about to hold.
    tag: u32,
    beats: Vec<[Point; LANES_MAX]>,
}

/// A request with the tag that its slot had when it was taken.
#[derive(Clone, Copy, Debug)]
struct LookedUp {
    fetch: Fetch,
    tag: u32,
}

/// A leaf that is read from its slot.
#[derive(Clone, Copy, Debug)]
struct Run {
    fetch: Fetch,
    beats_read: u8,
}

/// A leaf of which memory has sent some beats.
#[derive(Clone, Copy, Debug)]
struct Filling {
    /// Its slot if it is kept.
    slot: Option<usize>,
    beats_taken: usize,
}

/// The point cache.
#[derive(Clone, Debug)]
pub struct PointCache {
    slots: Vec<Slot>,
    fetch: Skid<Fetch>,
    fill: Skid<Beat>,
    /// The stage l.
    looked_up: Option<LookedUp>,
    run: Option<Run>,
    filling: Option<Filling>,
    /// The slot whose leaf is complete since the cycle before: lookups know of it in the next.
    completed: Option<usize>,
    /// The stages r and s.
    chosen: Option<Beat>,
    read: Option<Beat>,
    miss: Skid<Fetch>,
    beat: Skid<Beat>,
    events: PointCacheEvents,
}

impl PointCache {
    /// The unit after reset, for a configuration with a point cache.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let slot_beats = config.bucket.div_ceil(config.lanes).next_power_of_two() as usize;
        let slot = Slot { present: false, tag: 0, beats: vec![[Point::default(); LANES_MAX]; slot_beats] };
        Self {
            slots: vec![slot; config.point_cache as usize],
            fetch: Skid::default(),
            fill: Skid::default(),
            looked_up: None,
            run: None,
            filling: None,
            completed: None,
            chosen: None,
            read: None,
            miss: Skid::default(),
            beat: Skid::default(),
            events: PointCacheEvents::default(),
        }
    }

    fn slot(&self, address: u32) -> usize {
        slot(address, self.slots.len())
    }

    fn is_hit(&self, request: &LookedUp) -> bool {
        self.slots[self.slot(request.fetch.address)].present && request.tag == request.fetch.address
    }

    fn look_up(&self, fetch: Fetch) -> LookedUp {
        LookedUp { fetch, tag: self.slots[self.slot(fetch.address)].tag }
    }

    /// The next beat of a leaf that is read from its slot, and what is left of the leaf.
    fn read(&self, run: Run) -> (Beat, Option<Run>) {
        let Run { fetch: Fetch { thread, address, beats }, beats_read } = run;
        let points = Points { lane: self.slots[self.slot(address)].beats[usize::from(beats_read)] };
        let last = beats_read + 1 == beats;
        let place = BeatPlace { thread, address: address + u32::from(beats_read), last };
        (Beat { place, points }, (!last).then_some(Run { beats_read: beats_read + 1, ..run }))
    }

    /// Takes a beat from memory; `claimed` are the slots that must not change.
    fn fill(&mut self, beat: &Beat, claimed: [Option<usize>; 2]) {
        let BeatPlace { address, last, .. } = beat.place;
        let mut filling = self.filling.unwrap_or_else(|| {
            let slot = Some(self.slot(address)).filter(|slot| !claimed.contains(&Some(*slot)));
            Filling { slot, beats_taken: 0 }
        });
        if let Some(number) = filling.slot {
            let slot = &mut self.slots[number];
            slot.beats[filling.beats_taken] = beat.points.lane;
            if filling.beats_taken == 0 {
                (slot.tag, slot.present) = (address, false);
            }
            self.completed = last.then_some(number);
        }
        filling.beats_taken += 1;
        self.filling = (!last).then_some(filling);
    }
}

/// The slot of a leaf among `slots`, a power of two.
fn slot(mut address: u32, slots: usize) -> usize {
    let mut slot = 0;
    while address > 0 {
        slot ^= address as usize & (slots - 1);
        address >>= slots.ilog2();
    }
    slot
}

impl Model for PointCache {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out {
            fetch_ready: self.fetch.in_ready(),
            beat: self.beat.out().copied(),
            miss: self.miss.out().copied(),
            fill_ready: self.fill.in_ready(),
            events: self.events,
        }
    }

    fn clock(&mut self, inputs: &In) {
        let hit = self.looked_up.filter(|request| self.is_hit(request) && self.run.is_none());
        let missed = self.looked_up.filter(|request| !self.is_hit(request) && self.miss.in_ready());
        let takes_request = self.looked_up.is_none() || hit.is_some() || missed.is_some();
        let requested = self.fetch.out().copied().filter(|_| takes_request);
        // A run is no concern: while there is one, no leaf from memory begins.
        let next = self.fetch.out().copied();
        let claimed = [self.looked_up.map(|request| request.fetch), next].map(|fetch| Some(self.slot(fetch?.address)));
        if takes_request {
            self.looked_up = requested.map(|fetch| self.look_up(fetch));
        }

        if let Some(slot) = self.completed.take() {
            self.slots[slot].present = true;
        }
        let reads = self.read.is_none() || self.beat.in_ready();
        let chooses = self.chosen.is_none() || reads;
        let shown = if reads { std::mem::replace(&mut self.read, self.chosen.take()) } else { None };
        let mut takes_fill = false;
        match self.run {
            _ if !chooses => {}
            Some(run) if self.filling.is_none() => {
                let (beat, rest) = self.read(run);
                self.chosen = Some(beat);
                self.run = rest;
            }
            _ => {
                takes_fill = true;
                self.chosen = self.fill.out().copied();
                if let Some(beat) = self.chosen {
                    self.fill(&beat, claimed);
                }
            }
        }
        if let Some(LookedUp { fetch, .. }) = hit {
            self.run = Some(Run { fetch, beats_read: 0 });
        }
        self.events = PointCacheEvents { hit: hit.is_some(), miss: missed.is_some() };

        self.beat.step(shown, inputs.beat_ready);
        self.miss.step(missed.map(|request| request.fetch), inputs.miss_ready);
        self.fetch.step(inputs.fetch, takes_request);
        self.fill.step(inputs.fill, takes_fill);
    }
}

#[cfg(test)]
mod tests;
