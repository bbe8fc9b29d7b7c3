//! What two sides take turns at.

use crate::stream::Skid;

/// What two sides take turns at.
#[derive(Clone, Debug)]
pub struct Shared<T> {
    /// The side whose turn it is.
    pub turn: usize,
    /// What was taken.
    pub out: Skid<T>,
}

impl<T> Default for Shared<T> {
    fn default() -> Self {
        Self { turn: 0, out: Skid::default() }
    }
}

impl<T> Shared<T> {
    /// Which side something is taken from, if `open`.
    pub fn ready(&self, open: bool) -> [bool; 2] {
        [0, 1].map(|side| side == self.turn && open && self.out.in_ready())
    }

    /// What moves from the sides, of what they offer; the turn passes on where nothing does.
    pub fn take(&mut self, open: bool, offers: [Option<T>; 2]) -> Option<(usize, T)> {
        let ready = self.ready(open);
        let [low, high] = offers;
        let offer = if self.turn == 0 { low } else { high };
        let taken = offer.filter(|_| ready[self.turn]).map(|item| (self.turn, item));
        if taken.is_none() {
            self.turn = 1 - self.turn;
        }
        taken
    }
}
