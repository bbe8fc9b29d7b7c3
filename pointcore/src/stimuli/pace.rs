//! How the streams around a core are held back: by chance, in bursts, or each in its turn for a long time.

use super::one_of;
use fastrand::Rng;
use pointcore_tb::lockstep::{Stall, Stalls};

/// The longest of the bursts, in cycles.
const BURST_CYCLES: u32 = 300;
/// A share of idle cycles such that hardly anything moves.
const HARDLY: f64 = 0.97;
/// No silence of a stream that is free in one of 33 cycles is as long: one of 10²⁶ is.
const LONGEST_CHANCE: u64 = 2000;

/// A stream after the other is held for a long time, with time to recover in between.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turns {
    /// Cycles in which one stream does not move.
    pub held: u64,
    /// Cycles in which none is held, after each.
    pub free: u64,
}

/// When each of the streams around a core is idle.
#[derive(Clone, Debug)]
pub struct Paces {
    streams: Vec<Stalls>,
    turns: Option<Turns>,
    /// A stream that does not move in the first cycles.
    first: Option<(usize, u64)>,
}

impl Turns {
    /// Whether the turn is a stream's.
    const fn hold(self, stream: u64, streams: u64, cycle: u64) -> bool {
        let period = self.held + self.free;
        cycle / period % streams == stream && cycle % period < self.held
    }
}

impl Paces {
    /// So many streams, each with a pattern of its own or all without any, and perhaps turns.
    #[must_use]
    pub fn random(random: &mut Rng, streams: usize) -> Self {
        let is_free = random.u8(..4) == 0;
        let hold = random.u8(..4) == 0;
        let turns = hold.then(|| Turns { held: random.u64(50..2000), free: random.u64(200..2000) });
        let mut pattern = || match random.u8(..8) {
            _ if is_free => Stall::Never,
            0 | 1 => Stall::Never,
            2 | 3 => Stall::Random(one_of(random, &[0.05, 0.3, 0.5])),
            4 => Stall::Random(0.8),
            5 => Stall::Random(HARDLY),
            6 => Stall::Bursts(8),
            _ => Stall::Bursts(BURST_CYCLES),
        };
        let patterns: Vec<_> = (0..streams).map(|_| pattern()).collect();
        let streams = patterns.into_iter().map(|pattern| Stalls::new(pattern, random.fork())).collect();
        Self { streams, turns, first: None }
    }

    /// So many streams that move whenever it is nobody's turn to be held.
    #[must_use]
    pub fn in_turns(streams: usize, turns: Option<Turns>) -> Self {
        let free = || Stalls::new(Stall::Never, Rng::with_seed(0));
        Self { streams: (0..streams).map(|_| free()).collect(), turns, first: None }
    }

    /// So many streams, each with the same pattern of its own.
    #[must_use]
    pub fn alike(streams: usize, pattern: Stall, random: &mut Rng) -> Self {
        let streams = (0..streams).map(|_| Stalls::new(pattern, random.fork())).collect();
        Self { streams, turns: None, first: None }
    }

    /// The same, but one stream hardly moves.
    #[must_use]
    pub fn hardly(mut self, stream: usize, random: &mut Rng) -> Self {
        self.streams[stream] = Stalls::new(Stall::Random(HARDLY), random.fork());
        self
    }

    /// The same, but one stream does not move in the first cycles.
    #[must_use]
    pub const fn after(mut self, stream: usize, cycles: u64) -> Self {
        self.first = Some((stream, cycles));
        self
    }

    /// Whether a stream is idle in this cycle; asked once a cycle and stream.
    pub fn idle(&mut self, stream: usize, cycle: u64) -> bool {
        let streams = self.streams.len() as u64;
        let is_held = self.turns.is_some_and(|turns| turns.hold(stream as u64, streams, cycle));
        let is_first = self.first.is_some_and(|(first, cycles)| first == stream && cycle < cycles);
        self.streams[stream].stalled() | is_held | is_first
    }

    /// Cycles that a stream is idle at most.
    #[must_use]
    pub fn longest(&self) -> u64 {
        LONGEST_CHANCE + self.turns.map_or(0, |turns| turns.held) + self.first.map_or(0, |(_, cycles)| cycles)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_stream_has_its_turn_and_all_recover() {
        let mut paces = Paces::in_turns(3, Some(Turns { held: 4, free: 2 }));
        let idle: Vec<Vec<bool>> =
            (0..18).map(|cycle| (0..3).map(|stream| paces.idle(stream, cycle)).collect()).collect();
        for (cycle, idle) in idle.iter().enumerate() {
            let expected: Vec<_> = (0..3).map(|stream| cycle / 6 == stream && cycle % 6 < 4).collect();
            assert_eq!(*idle, expected, "cycle {cycle}");
        }
    }

    #[test]
    fn no_stream_is_idle_for_longer_than_said() {
        for seed in 0..40 {
            let mut paces = Paces::random(&mut Rng::with_seed(seed), 3);
            let (mut quiet, mut longest, mut moved) = ([0; 3], 0, 0);
            for cycle in 0..30_000 {
                for (stream, quiet) in quiet.iter_mut().enumerate() {
                    *quiet = if paces.idle(stream, cycle) { *quiet + 1 } else { 0 };
                    moved += u64::from(*quiet == 0);
                    longest = longest.max(*quiet);
                }
            }
            assert!(longest <= paces.longest() && moved > 0, "seed {seed}: {longest}");
        }
    }
}
