//! What each unit does in a cycle, as its streams and events tell.

use super::timeline::{Counts, State, Unit};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::Uniforms;
use pointcore_contract::splat::units::Events;
use pointcore_golden::splat::lane;
use pointcore_golden::splat::top::{In, Out, Shown};

/// Cycles that a copy is under way in the tile cache without anything moving, unless it waits for a slot.
const TILE_CACHE_TRANSIT_CYCLES: u32 = 2;

/// The two sides of a stream.
#[derive(Clone, Copy)]
struct Stream {
    valid: bool,
    ready: bool,
}

impl Stream {
    const fn new<T>(offer: Option<&T>, ready: bool) -> Self {
        Self { valid: offer.is_some(), ready }
    }

    const fn moves(self) -> bool {
        self.valid && self.ready
    }

    /// What is offered is not taken.
    const fn is_held(self) -> bool {
        self.valid && !self.ready
    }
}

/// A compiled datapath takes an item every few cycles and works on it for as many.
#[derive(Clone, Copy, Debug)]
struct Datapath {
    interval: u32,
    left: u32,
}

impl Datapath {
    const fn new(interval: u32) -> Self {
        Self { interval, left: 0 }
    }

    const fn see(&mut self, input: Stream, output: Stream) -> State {
        if input.moves() {
            self.left = self.interval;
        }
        if self.left > 0 {
            self.left -= 1;
            State::Busy
        } else if output.is_held() {
            State::Held
        } else if input.valid {
            State::Other
        } else {
            State::Starved
        }
    }
}

/// A unit that hands on all that it takes, in its own time.
#[derive(Clone, Copy, Debug, Default)]
struct Passage {
    /// Items within.
    held: u64,
    /// Cycles since something moved.
    still: u32,
}

impl Passage {
    /// Counts what moves, and says whether something does.
    fn moves(&mut self, input: Stream, output: Stream) -> bool {
        self.held += u64::from(input.moves());
        self.held = self.held.saturating_sub(u64::from(output.moves()));
        let moves = input.moves() || output.moves();
        self.still = if moves { 0 } else { self.still + 1 };
        moves
    }

    /// As a unit that is at work as long as there is something in it.
    fn see(&mut self, input: Stream, output: Stream) -> State {
        if self.moves(input, output) {
            State::Busy
        } else if output.is_held() {
            State::Held
        } else if self.held > 0 || !input.ready {
            State::Busy
        } else {
            State::Starved
        }
    }
}

/// What is to be remembered of the cycles before.
#[derive(Clone, Debug)]
pub(super) struct States {
    transform: Datapath,
    setup: Datapath,
    normalizers: Vec<Datapath>,
    lanes: Vec<Lane>,
}

impl States {
    pub(super) fn new(config: &Config) -> Self {
        Self {
            transform: Datapath::new(config.transform_interval),
            setup: Datapath::new(config.setup_interval),
            normalizers: vec![Datapath::new(1 + u32::from(config.has_motion())); config.memory_ports as usize],
            lanes: vec![Lane::default(); config.rasterizers as usize],
        }
    }

    /// What each unit does in this cycle.
    pub(super) fn see(&mut self, inputs: &In, shown: &Shown) -> Counts {
        let Shown { transform, setup, splitter, lanes, normalizers, .. } = shown;
        let splats = Stream::new(inputs.splat.as_ref(), transform.in_ready);
        let placed = Stream::new(transform.out.as_ref(), setup.in_ready);
        let footprints = Stream::new(setup.out.as_ref(), splitter.in_ready);
        let copies = Stream::new(splitter.out.as_ref(), lanes.in_ready());
        let mut counts = of_rasterizers(&lanes.events(), lanes.lanes.len() as u32);
        for (port, (at_port, (normalizer, shown))) in
            lanes.at_ports().zip(self.normalizers.iter_mut().zip(normalizers)).enumerate()
        {
            let lane::Out { read, data_ready, write, pixel, .. } = at_port;
            counts.add(Unit::Memory, memory(inputs, port, read.is_some(), data_ready, write.is_some()), 1);
            let finished = Stream::new(pixel.as_ref(), shown.in_ready);
            let fragments = Stream::new(shown.out.as_ref(), inputs.fragment_ready[port]);
            counts.add(Unit::Normalizer, normalizer.see(finished, fragments), 1);
        }
        counts.add(Unit::Transform, self.transform.see(splats, placed), 1);
        counts.add(Unit::Setup, self.setup.see(placed, footprints), 1);
        // It makes several copies of a splat, so what is in it cannot be counted.
        counts.add(Unit::Splitter, Passage::default().see(footprints, copies), 1);
        let seen = lanes.seen(splitter.out, &shown.ports_see(inputs, &Uniforms::default()), inputs);
        for ((lane, shown), seen) in self.lanes.iter_mut().zip(&lanes.lanes).zip(&seen[lanes.lanes.len()..]) {
            lane.see(seen, shown, &mut counts);
        }
        counts
    }
}

/// What is to be remembered of a lane.
#[derive(Clone, Debug)]
struct Lane {
    payloads: Passage,
    reorder: Passage,
    tile_cache: Passage,
    weighting: Datapath,
}

impl Default for Lane {
    fn default() -> Self {
        Self {
            payloads: Passage::default(),
            reorder: Passage::default(),
            tile_cache: Passage::default(),
            weighting: Datapath::new(1),
        }
    }
}

impl Lane {
    /// What its units do, but for those that its events tell of.
    fn see(&mut self, inputs: &lane::In, shown: &lane::Shown, counts: &mut Counts) {
        let lane::Shown { payloads, reorder, prefetch, tile_cache, rasterizer, occlusion, weighting, accumulator } =
            shown;
        let light = Stream::new(payloads.copy.as_ref(), reorder.in_ready);
        let in_slots = Stream::new(tile_cache.out.as_ref(), payloads.placed_ready);
        let complete = Stream::new(payloads.out.as_ref(), rasterizer.in_ready);
        let (to_tiles, takes_ordered) = match prefetch {
            Some(prefetch) => (prefetch.out, prefetch.in_ready),
            None => (reorder.out, tile_cache.in_ready),
        };
        let ordered = Stream::new(reorder.out.as_ref(), takes_ordered);
        let seen = occlusion.as_ref().map_or(&rasterizer.out, |occlusion| &occlusion.out);
        let samples = Stream::new(seen.as_ref(), weighting.in_ready);
        let weighted = Stream::new(weighting.out.as_ref(), accumulator.in_ready);
        let finished = Stream::new(tile_cache.pixel.as_ref(), inputs.pixel_ready);
        // What is on its way between its two sides is not its work.
        counts.add(Unit::Payloads, self.payloads.see(in_slots, complete), 1);
        counts.add(Unit::Reorder, self.reorder.see(light, ordered), 1);
        // An end stays there.
        let copies = Stream::new(to_tiles.as_ref().filter(|copy| !copy.end), tile_cache.in_ready);
        counts.add(Unit::TileCache, self.tile_cache(copies, in_slots, finished), 1);
        counts.add(Unit::Weighting, self.weighting.see(samples, weighted), 1);
    }

    fn tile_cache(&mut self, copies: Stream, placed: Stream, finished: Stream) -> State {
        let moves = self.tile_cache.moves(copies, placed) || finished.moves();
        if moves {
            State::Busy
        } else if placed.is_held() || finished.is_held() {
            State::Held
        } else if self.tile_cache.held == 0 {
            State::Starved
        } else if self.tile_cache.still > TILE_CACHE_TRANSIT_CYCLES {
            State::Tile
        } else {
            State::Busy
        }
    }
}

/// Whether pixels move at a port to the reconstruction buffer, or are wanted: whether the core asks for some, takes one, writes one.
const fn memory(inputs: &In, port: usize, reads: bool, takes: bool, writes: bool) -> State {
    let data = Stream::new(inputs.data[port].as_ref(), takes);
    let write = Stream { valid: writes, ready: inputs.write_ready[port] };
    let read = Stream { valid: reads, ready: inputs.read_ready[port] };
    if data.moves() || write.moves() {
        State::Busy
    } else if write.is_held() || read.is_held() {
        State::Held
    } else if data.ready {
        State::Tile
    } else {
        State::Starved
    }
}

/// What the core's ports tell, with nothing of the units behind them.
pub(super) fn at_ports(config: &Config, inputs: &In, outputs: &Out) -> Counts {
    let Out { read, data_ready, write, events, .. } = outputs;
    let mut counts = of_rasterizers(events, config.rasterizers);
    for port in 0..config.memory_ports as usize {
        let state = memory(inputs, port, read[port].is_some(), data_ready[port], write[port].is_some());
        counts.add(Unit::Memory, state, 1);
    }
    counts
}

/// What events tell of rasterizers and accumulators.
fn of_rasterizers(events: &Events, rasterizers: u32) -> Counts {
    let Events { sample, starved, blocked, accumulate, hazard, slot_wait, hidden: _ } = *events;
    let mut counts = Counts::default();
    // Without an event no sample inside a splat is at the head of an accumulator.
    let rasterizer = [(State::Busy, sample), (State::Starved, starved), (State::Held, blocked)];
    let accumulator = [(State::Busy, accumulate), (State::Pixel, hazard), (State::Tile, slot_wait)];
    for (unit, states, otherwise) in
        [(Unit::Rasterizer, rasterizer, State::Other), (Unit::Accumulator, accumulator, State::Starved)]
    {
        let told = states.map(|(_, count)| u32::from(count));
        states.iter().zip(told).for_each(|((state, _), count)| counts.add(unit, *state, count));
        counts.add(unit, otherwise, rasterizers - told.iter().sum::<u32>());
    }
    counts
}
