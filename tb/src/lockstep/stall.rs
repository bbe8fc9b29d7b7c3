//! When a stream's producer has nothing to offer, or its consumer no room.

/// A pattern of idle cycles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stall {
    /// Never idle: full throughput.
    Never,
    /// Idle in each cycle with this probability.
    Random(f64),
    /// Idle and busy in turns, each of random length up to so many cycles: fills and drains every queue.
    Bursts(u32),
}

/// A pattern in progress.
#[derive(Debug, Clone)]
pub struct Stalls {
    pattern: Stall,
    random: fastrand::Rng,
    idle: bool,
    remaining: u32,
}

impl Stalls {
    /// A pattern from its beginning; `random` decides what is random in it.
    #[must_use]
    pub fn new(pattern: Stall, random: fastrand::Rng) -> Self {
        Self { pattern, random, idle: false, remaining: 0 }
    }

    /// Whether the next cycle is idle.
    pub fn stalled(&mut self) -> bool {
        match self.pattern {
            Stall::Never => false,
            Stall::Random(probability) => self.random.f64() < probability,
            Stall::Bursts(longest) => {
                if self.remaining == 0 {
                    self.idle = !self.idle;
                    self.remaining = self.random.u32(1..=longest.max(1));
                }
                self.remaining -= 1;
                self.idle
            }
        }
    }
}
