//! A slot's pixels on their way to and from the memory.

use super::PIXELS;
use pointcore_contract::splat::records::Pixel;

/// Progress of reading a slot: with each request the pixel asked for before comes to the port, where it stays until it is taken.
#[derive(Clone, Copy, Debug, Default)]
pub struct Drain {
    /// The pixel that is asked for next.
    pub next: u8,
    showing: Option<u8>,
    held: Option<u8>,
}

impl Drain {
    /// Whether the pixels that are held and shown, if any, move on.
    const fn steps(&self, room: bool) -> bool {
        self.held.is_none() || room
    }

    /// The pixel that is asked for in this cycle.
    pub fn request(&self, room: bool) -> Option<u8> {
        self.steps(room).then_some(self.next % PIXELS)
    }

    /// Whether every pixel was taken.
    pub const fn is_done(&self) -> bool {
        self.next == PIXELS && self.showing.is_none() && self.held.is_none()
    }

    /// One clock edge, while the port shows `drained`; returns the pixel that is taken and its value.
    pub fn clock(&mut self, room: bool, drained: Pixel) -> Option<(u8, Pixel)> {
        let taken = self.held.filter(|_| room);
        if self.steps(room) {
            self.held = self.showing.take();
            if self.next < PIXELS {
                self.showing = Some(self.next);
                self.next += 1;
            }
        }
        taken.map(|pixel| (pixel, drained))
    }
}

/// Replacement of a slot's tile.
#[derive(Clone, Copy, Debug)]
pub struct Job {
    /// The slot.
    pub slot: u8,
    /// The tile that comes.
    pub tile: u32,
    /// The tile that goes.
    pub evicted: Option<u32>,
    /// How far it has come.
    pub step: JobStep,
}

/// The steps of a job.
#[derive(Clone, Copy, Debug)]
pub enum JobStep {
    /// The memory of touched tiles is read.
    Read,
    /// It tells whether the tile that comes lies there.
    Lookup,
    /// Pixels go and come; `filled` have come, from memory or cleared.
    Move { load: bool, drain: Drain, filled: u8 },
}

impl Job {
    /// Whether the next pixel may be filled: it was read before.
    pub fn may_fill(&self) -> bool {
        match self.step {
            JobStep::Read | JobStep::Lookup => false,
            JobStep::Move { drain, filled, .. } => filled < PIXELS && (self.evicted.is_none() || filled < drain.next),
        }
    }

    /// Whether the next pixel may come from memory.
    pub fn may_load(&self) -> bool {
        matches!(self.step, JobStep::Move { load: true, .. }) && self.may_fill()
    }

    /// The pixel of the tile that goes that is asked for in this cycle.
    pub fn request(&self, room: bool) -> Option<u8> {
        match self.step {
            JobStep::Move { drain, .. } if self.evicted.is_some() => drain.request(room),
            _ => None,
        }
    }
}
