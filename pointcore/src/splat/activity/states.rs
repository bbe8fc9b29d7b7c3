//! What each unit does in a cycle, as its streams and events tell.

use super::timeline::{State, Unit};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::PlacedPixel;
use pointcore_contract::splat::units::{AccumulatorEvents, RasterizerEvents};
use pointcore_golden::splat::top::{In, Shown};

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
    weighting: Datapath,
    normalizer: Datapath,
    reorder: Passage,
    tile_cache: Passage,
    /// The tile cache sends what it has to normalization.
    is_flushing: bool,
}

impl States {
    pub(super) fn new(config: &Config) -> Self {
        Self {
            transform: Datapath::new(config.transform_interval),
            setup: Datapath::new(config.setup_interval),
            weighting: Datapath::new(1),
            normalizer: Datapath::new(1),
            reorder: Passage::default(),
            tile_cache: Passage::default(),
            is_flushing: false,
        }
    }

    /// What each unit does in this cycle, in the order of [`Unit::ALL`].
    pub(super) fn see(&mut self, inputs: &In, shown: &Shown) -> [State; Unit::ALL.len()] {
        let Shown { transform, setup, splitter, reorder, tile_cache, rasterizer, weighting, accumulator, normalizer } =
            shown;
        let splats = Stream::new(inputs.splat.as_ref(), transform.in_ready);
        let placed = Stream::new(transform.out.as_ref(), setup.in_ready);
        let footprints = Stream::new(setup.out.as_ref(), splitter.in_ready);
        let copies = Stream::new(splitter.out.as_ref(), reorder.in_ready);
        let ordered = Stream::new(reorder.out.as_ref(), tile_cache.in_ready);
        let samples = Stream::new(rasterizer.out.as_ref(), weighting.in_ready);
        let weighted = Stream::new(weighting.out.as_ref(), accumulator.in_ready);
        let finished = Stream::new(tile_cache.pixel.as_ref(), normalizer.in_ready);
        let fragments = Stream::new(normalizer.out.as_ref(), inputs.fragment_ready);

        let write = tile_cache.write.as_ref();
        let memory =
            MemoryPort { inputs, is_reading: tile_cache.read.is_some(), data_ready: tile_cache.data_ready, write };
        let mut states = at_ports(&memory, &rasterizer.events, &accumulator.events);
        let mut set = |unit: Unit, state| states[unit as usize] = state;
        set(Unit::Transform, self.transform.see(splats, placed));
        set(Unit::Setup, self.setup.see(placed, footprints));
        // It makes several copies of a splat, so what is in it cannot be counted.
        set(Unit::Splitter, Passage::default().see(footprints, copies));
        set(Unit::Reorder, self.reorder.see(copies, ordered));
        set(Unit::TileCache, self.tile_cache(ordered, finished, shown));
        set(Unit::Weighting, self.weighting.see(samples, weighted));
        set(Unit::Normalizer, self.normalizer.see(finished, fragments));
        states
    }

    fn tile_cache(&mut self, ordered: Stream, finished: Stream, shown: &Shown) -> State {
        let placed = Stream::new(shown.tile_cache.out.as_ref(), shown.rasterizer.in_ready);
        let is_end = shown.tile_cache.pixel.as_ref().is_some_and(|pixel| pixel.end);
        self.is_flushing = (self.is_flushing || shown.accumulator.frame_end) && !(is_end && finished.moves());
        let moves = self.tile_cache.moves(ordered, placed) || finished.moves();
        if moves {
            State::Busy
        } else if placed.is_held() || finished.is_held() {
            State::Held
        } else if self.is_flushing {
            State::Busy
        } else if self.tile_cache.held == 0 {
            State::Starved
        } else if self.tile_cache.still > TILE_CACHE_TRANSIT_CYCLES {
            State::Tile
        } else {
            State::Busy
        }
    }
}

/// The port to the reconstruction buffer.
pub(super) struct MemoryPort<'a> {
    /// What the core sees of it.
    pub inputs: &'a In,
    /// A tile is requested.
    pub is_reading: bool,
    /// A pixel is wanted.
    pub data_ready: bool,
    /// A pixel is written.
    pub write: Option<&'a PlacedPixel>,
}

impl MemoryPort<'_> {
    /// Whether pixels move, or are wanted.
    const fn state(&self) -> State {
        let Self { inputs, .. } = self;
        let data = Stream::new(inputs.data.as_ref(), self.data_ready);
        let write = Stream { valid: self.write.is_some(), ready: inputs.write_ready };
        let read = Stream { valid: self.is_reading, ready: inputs.read_ready };
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
}

/// What the core's ports tell, with nothing of the units behind them.
pub(super) fn at_ports(
    memory: &MemoryPort,
    rasterizer: &RasterizerEvents,
    accumulator: &AccumulatorEvents,
) -> [State; Unit::ALL.len()] {
    let mut states = [State::Other; Unit::ALL.len()];
    states[Unit::Memory as usize] = memory.state();
    states[Unit::Rasterizer as usize] = if rasterizer.sample {
        State::Busy
    } else if rasterizer.starved {
        State::Starved
    } else if rasterizer.blocked {
        State::Held
    } else {
        State::Other
    };
    // Without an event no sample inside a splat is at its head.
    states[Unit::Accumulator as usize] = if accumulator.accumulate {
        State::Busy
    } else if accumulator.hazard {
        State::Pixel
    } else if accumulator.slot_wait {
        State::Tile
    } else {
        State::Starved
    };
    states
}
