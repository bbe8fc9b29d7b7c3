//! What the operations of a script are about.

/// Channels whose pauses a script sets by name, by their numbers in the bench.
#[derive(Clone, Copy, Debug)]
pub enum Channel {
    /// Addresses of registers to be written.
    WriteAddress = 0,
    /// What is written to them.
    WriteValue = 1,
    /// Answers to that.
    Written = 2,
    /// Addresses of registers to be read.
    ReadAddress = 3,
    /// What is read from them.
    ReadValue = 4,
    /// Packets from the core.
    Receive = 6,
    /// Bursts wanted of memory.
    ReadBurst = 7,
    /// Beats of memory.
    ReadData = 8,
    /// Data through the window.
    WindowData = 10,
    /// Bursts that are written.
    WriteBurst = 16,
    /// Their beats.
    WriteData = 17,
    /// Answers to them.
    WriteAnswer = 18,
}

impl Channel {
    /// Those of packets and memory, each of which may be narrower than all others.
    pub const NARROW: [Self; 6] =
        [Self::Receive, Self::ReadBurst, Self::ReadData, Self::WriteBurst, Self::WriteData, Self::WriteAnswer];
}

/// How often channels pause.
#[derive(Clone, Copy, Debug)]
pub enum Pauses {
    /// Never.
    None,
    /// Each in a share of the cycles of its own.
    Some,
}

/// Why an access is refused.
#[derive(Clone, Copy, Debug)]
pub enum Refusal {
    /// For what it is.
    Access,
    /// Because a run is under way.
    Busy,
}

/// What the bench counts itself.
#[derive(Clone, Copy, Debug)]
pub enum Counted {
    /// Cycles of the run.
    Cycles,
    /// Packets that came in the run.
    Packets,
    /// Answers of memory that were errors.
    MemoryErrors,
    /// Bursts and beats of memory that were misshapen.
    Misplaced,
    /// Cycles of the run with an event, by its place.
    Event(u32),
}

impl Counted {
    /// Its number in the bench.
    pub const fn number(self) -> u32 {
        match self {
            Self::Cycles => 0,
            Self::Packets => 1,
            Self::MemoryErrors => 2,
            Self::Misplaced => 3,
            Self::Event(place) => 4 + place,
        }
    }
}

/// A burst through the window.
#[derive(Clone, Debug)]
pub struct Burst {
    /// Its first byte.
    pub address: u32,
    /// Its words, lower half first.
    pub data: Vec<u32>,
    /// One less than its beats.
    pub length: u32,
    /// The binary logarithm of a beat's bytes.
    pub size: u32,
    /// How the address goes on.
    pub kind: u32,
    /// Beats whose strobes are others, a bit each, and those strobes.
    pub strobes: (u32, u32),
    /// Beats whose `wlast` is wrong, a bit each.
    pub misplaced: u32,
}
