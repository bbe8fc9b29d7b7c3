//! Units that hold items of a stream.

mod fifo;
mod half_buffer;
mod skid;

pub use fifo::Fifo;
pub use half_buffer::HalfBuffer;
pub use skid::Skid;
