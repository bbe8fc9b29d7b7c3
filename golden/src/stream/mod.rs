//! Units that hold items of a stream.

mod fifo;
mod skid;

pub use fifo::Fifo;
pub use skid::Skid;
