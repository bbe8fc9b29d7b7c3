//! `HalfBuffer`: one item, at half rate.
//!
//! Shape: at most one item of type `T`. It is taken in cycles in which there is none at the start, so an item moves every second cycle
//! at most.

/// Cycle-accurate model of `stream_half_buffer`.
#[derive(Clone, Debug)]
pub struct HalfBuffer<T> {
    item: Option<T>,
}

impl<T> Default for HalfBuffer<T> {
    fn default() -> Self {
        Self { item: None }
    }
}

impl<T> HalfBuffer<T> {
    /// `in_ready` in this cycle.
    #[must_use]
    pub const fn in_ready(&self) -> bool {
        self.item.is_none()
    }

    /// What the output shows in this cycle; `None` while `out_valid` is low.
    #[must_use]
    pub const fn out(&self) -> Option<&T> {
        self.item.as_ref()
    }

    /// The clock edge: `input` is the item shown at the input, taken if [`HalfBuffer::in_ready`].
    pub fn step(&mut self, input: Option<T>, out_ready: bool) {
        self.item = match self.item.take() {
            None => input,
            held => held.filter(|_| !out_ready),
        };
    }
}
