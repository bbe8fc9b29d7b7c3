//! Payloads in a memory on the chip.

use super::Arriving;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{Payload, TileCopy};

/// The copy that arrived last.
#[derive(Clone, Copy, Debug)]
struct Arrived {
    copy: TileCopy,
    /// Words of its payload that are written.
    written: u32,
}

/// The memory, and what is on its way there.
#[derive(Clone, Debug)]
pub(super) struct Chip {
    /// Words of a payload.
    beats: u32,
    payloads: Vec<Payload>,
    arrived: Option<Arrived>,
}

impl Chip {
    /// The memory after reset.
    pub fn new(config: &Config) -> Self {
        let payloads = vec![Payload::default(); config.splats_held() as usize];
        Self { beats: config.payload_beats, payloads, arrived: None }
    }

    /// A copy can be taken.
    pub const fn has_room(&self) -> bool {
        self.arrived.is_none()
    }

    /// The copy that may go on: its payload is written, or its last word is in this cycle.
    pub fn shown(&self) -> Option<TileCopy> {
        self.arrived.filter(|arrived| arrived.written + 1 >= self.beats).map(|arrived| arrived.copy)
    }

    /// What a place holds.
    pub fn payload(&self, place: u16) -> Payload {
        self.payloads[usize::from(place)]
    }

    /// A cycle, in which a copy may come.
    pub fn step(&mut self, arriving: Option<Arriving>, copy_ready: bool) {
        let shown = self.shown().is_some();
        if let Some(arrived) = &mut self.arrived {
            arrived.written = self.beats.min(arrived.written + 1);
            if shown && copy_ready {
                self.arrived = None;
            }
        }
        if let Some(Arriving { copy, payload }) = arriving {
            if let Some(payload) = payload {
                self.payloads[usize::from(copy.splat)] = payload;
            }
            self.arrived = Some(Arrived { copy, written: if payload.is_some() { 1 } else { self.beats } });
        }
    }
}
