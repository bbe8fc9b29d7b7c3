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
    /// One of the others after the other, each for a while: streams meet at all combinations of paces.
    Varied,
}

impl Stall {
    /// The patterns of [`Stall::Varied`]: free, hardly held, mostly held, hardly free, in turns.
    const VARIETY: [Self; 6] =
        [Self::Never, Self::Never, Self::Random(0.3), Self::Random(0.8), Self::Random(0.97), Self::Bursts(30)];
    /// Cycles for which one of them holds, at most.
    const LONGEST: u32 = 400;
}

/// A pattern in progress.
#[derive(Debug, Clone)]
pub struct Stalls {
    pattern: Stall,
    random: fastrand::Rng,
    idle: bool,
    remaining: u32,
    /// Of patterns that vary, the one that holds, and for how many more cycles.
    varied: Option<(Box<Self>, u32)>,
}

impl Stalls {
    /// A pattern from its beginning; `random` decides what is random in it.
    #[must_use]
    pub fn new(pattern: Stall, random: fastrand::Rng) -> Self {
        Self { pattern, random, idle: false, remaining: 0, varied: None }
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
            Stall::Varied => {
                if self.varied.as_ref().is_none_or(|(_, remaining)| *remaining == 0) {
                    let pattern = Stall::VARIETY[self.random.usize(..Stall::VARIETY.len())];
                    let cycles = self.random.u32(1..=Stall::LONGEST);
                    self.varied = Some((Box::new(Self::new(pattern, self.random.fork())), cycles));
                }
                let (stalls, remaining) = self.varied.as_mut().expect("it was chosen just now");
                *remaining -= 1;
                stalls.stalled()
            }
        }
    }
}
