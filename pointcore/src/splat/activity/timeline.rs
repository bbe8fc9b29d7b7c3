//! What units did over a run, slice by slice.

use serde::Serialize;

/// Slices of a timeline at most; a run of some length has half as many at least.
const SLICES: usize = 200;
/// Cycles of a slice at first. Whenever there would be too many slices, two become one.
const FIRST_SLICE_CYCLES: u64 = 16;

/// A unit of the renderer, or its memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Unit {
    /// The transform unit.
    Transform,
    /// The setup unit.
    Setup,
    /// The splitter.
    Splitter,
    /// The payloads, where copies get theirs back.
    Payloads,
    /// The reorder stage.
    Reorder,
    /// The tile cache.
    TileCache,
    /// The ports to the reconstruction buffer.
    Memory,
    /// The rasterizer.
    Rasterizer,
    /// The weighting unit.
    Weighting,
    /// The accumulator.
    Accumulator,
    /// The normalizer.
    Normalizer,
}

impl Unit {
    /// All, in the order in which a splat meets them.
    pub const ALL: [Self; UNITS] = [
        Self::Transform,
        Self::Setup,
        Self::Splitter,
        Self::Payloads,
        Self::Reorder,
        Self::TileCache,
        Self::Memory,
        Self::Rasterizer,
        Self::Weighting,
        Self::Accumulator,
        Self::Normalizer,
    ];

    /// Those of which the core's ports tell.
    pub const AT_PORTS: [Self; 3] = [Self::Memory, Self::Rasterizer, Self::Accumulator];

    /// What it is called.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Transform => "transform",
            Self::Setup => "setup",
            Self::Splitter => "splitter",
            Self::Payloads => "payloads",
            Self::Reorder => "reorder",
            Self::TileCache => "tile cache",
            Self::Memory => "reconstruction buffer",
            Self::Rasterizer => "rasterizer",
            Self::Weighting => "weighting",
            Self::Accumulator => "accumulator",
            Self::Normalizer => "normalizer",
        }
    }
}

const UNITS: usize = 11;

impl Unit {
    /// There are as many of it as rasterizers.
    const fn is_in_lane(self) -> bool {
        matches!(
            self,
            Self::Payloads | Self::Reorder | Self::TileCache | Self::Rasterizer | Self::Weighting | Self::Accumulator
        )
    }
}

/// What a unit does in a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// It works.
    Busy,
    /// It has nothing to work on.
    Starved,
    /// What follows does not take what it offers.
    Held,
    /// It waits for a tile, or for a slot to put one in.
    Tile,
    /// It waits for an earlier sample of the same pixel.
    Pixel,
    /// None of these: a datapath between two of its phases, the end of a frame on its way.
    Other,
}

impl State {
    /// All.
    pub const ALL: [Self; STATES] = [Self::Busy, Self::Starved, Self::Held, Self::Tile, Self::Pixel, Self::Other];
}

const STATES: usize = 6;

/// Cycles of each unit in each state; those of all rasterizers together.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts([[u32; STATES]; UNITS]);

impl Counts {
    /// So many of a unit were in a state in a cycle.
    pub const fn add(&mut self, unit: Unit, state: State, count: u32) {
        self.0[unit as usize][state as usize] += count;
    }

    fn add_all(&mut self, other: &Self) {
        self.0.iter_mut().flatten().zip(other.0.iter().flatten()).for_each(|(count, other)| *count += other);
    }
}

/// What units did, in slices of equal length but for the last.
#[derive(Clone, Debug)]
pub struct Timeline {
    slice_cycles: u64,
    /// Cycles still missing in the last slice.
    missing: u64,
    slices: Vec<Counts>,
    rasterizers: u32,
    memory_ports: u32,
}

impl Timeline {
    /// An empty one, of a core of so many rasterizers and ports to memory.
    pub(super) fn new(rasterizers: u32, memory_ports: u32) -> Self {
        let slices = Vec::with_capacity(SLICES);
        Self { slice_cycles: FIRST_SLICE_CYCLES, missing: 0, slices, rasterizers, memory_ports }
    }

    /// Adds a cycle.
    pub(super) fn push(&mut self, counts: &Counts) {
        if self.missing == 0 {
            if self.slices.len() == SLICES {
                self.merge();
            }
            self.slices.push(Counts::default());
            self.missing = self.slice_cycles;
        }
        self.missing -= 1;
        self.slices.last_mut().expect("one was pushed at the first cycle").add_all(counts);
    }

    fn merge(&mut self) {
        let merge = |pair: &[Counts]| {
            let mut sum = pair[0];
            pair[1..].iter().for_each(|other| sum.add_all(other));
            sum
        };
        let merged: Vec<Counts> = self.slices.chunks(2).map(merge).collect();
        self.slices.clear();
        self.slices.extend(merged);
        self.slice_cycles *= 2;
    }

    /// Cycles of a slice; the last may have fewer.
    #[must_use]
    pub const fn slice_cycles(&self) -> u64 {
        self.slice_cycles
    }

    /// Cycles of all slices.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        self.slices.len() as u64 * self.slice_cycles - self.missing
    }

    /// How many there are of a unit.
    #[must_use]
    pub const fn count(&self, unit: Unit) -> u32 {
        match unit {
            Unit::Memory | Unit::Normalizer => self.memory_ports,
            unit if unit.is_in_lane() => self.rasterizers,
            _ => 1,
        }
    }

    /// Cycles of a unit in a state, slice by slice; those of all where there are [several](Self::count).
    pub fn row(&self, unit: Unit, state: State) -> impl Iterator<Item = u32> + '_ {
        self.slices.iter().map(move |slice| slice.0[unit as usize][state as usize])
    }

    /// Cycles of a unit in a state over the whole run.
    #[must_use]
    pub fn total(&self, unit: Unit, state: State) -> u64 {
        self.row(unit, state).map(u64::from).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slices_grow_and_no_cycle_is_lost() {
        for cycles in [1_u64, 16, 3_200, 3_201, 12_345, 100_000] {
            let mut timeline = Timeline::new(1, 1);
            for cycle in 0..cycles {
                let state = if cycle % 3 == 0 { State::Busy } else { State::Held };
                let mut counts = Counts::default();
                Unit::ALL.into_iter().for_each(|unit| counts.add(unit, state, 1));
                timeline.push(&counts);
            }
            let busy: u64 = timeline.total(Unit::Normalizer, State::Busy);
            assert_eq!((timeline.cycles(), busy), (cycles, cycles.div_ceil(3)), "{cycles}");
            assert_eq!(timeline.total(Unit::Transform, State::Held), cycles - busy);
            let slices = timeline.slices.len();
            assert!(slices <= SLICES && (cycles <= 3_200 || slices > SLICES / 2), "{cycles}: {slices}");
            let full = timeline.row(Unit::Setup, State::Busy).zip(timeline.row(Unit::Setup, State::Held));
            let sums: Vec<u64> = full.map(|(busy, held)| u64::from(busy + held)).collect();
            assert!(sums[..slices - 1].iter().all(|sum| *sum == timeline.slice_cycles()), "{sums:?}");
        }
    }
}
