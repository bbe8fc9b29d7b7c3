//! Prefetch: asks memory for the payload of copies before they are drawn, and lets them wait meanwhile.

use crate::stream::{Fifo, Skid};
use crate::unit::Model;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::{PayloadPlace, TileCopy};
pub use pointcore_contract::splat::units::prefetch::{In, Out};

/// The unit.
#[derive(Clone, Debug)]
pub struct Prefetch {
    /// The most copies whose payload may be asked for.
    ahead: u32,
    copies: Fifo<TileCopy>,
    reads: Skid<PayloadPlace>,
    /// Copies whose payload was asked for, and has not left where it came to.
    asked: u32,
}

impl Prefetch {
    /// The unit after reset.
    #[must_use]
    pub fn new(config: &Config) -> Self {
        let ahead = config.payload_ahead;
        Self { ahead, copies: Fifo::new(ahead.max(2) as usize), reads: Skid::default(), asked: 0 }
    }

    fn in_ready(&self) -> bool {
        self.copies.in_ready() && self.reads.in_ready() && self.asked < self.ahead
    }
}

impl Model for Prefetch {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        Out { in_ready: self.in_ready(), out: self.copies.out().copied(), read: self.reads.out().copied() }
    }

    fn clock(&mut self, inputs: &In) {
        let taken = inputs.input.filter(|_| self.in_ready());
        let asked = taken.filter(|copy| !copy.end).map(|copy| PayloadPlace { splat: copy.splat });
        self.copies.step(taken, inputs.out_ready);
        self.reads.step(asked, inputs.read_ready);
        self.asked = self.asked + u32::from(asked.is_some()) - u32::from(inputs.left);
    }
}
