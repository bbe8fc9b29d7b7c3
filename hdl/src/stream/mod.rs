//! Library units that hold items of a stream: input stream `in`, output stream `out`, each with all fields in one port `…_data`, the
//! first on top. So there is one module for all records of a width.

mod fifo;
mod half_buffer;
mod skid;

pub use fifo::{fifo, fifo_distributed};
pub use half_buffer::half_buffer;
pub use skid::skid;

/// Bits of an item.
fn item_width(layout: &[(impl AsRef<str>, u32)]) -> u32 {
    layout.iter().map(|(_, width)| width).sum()
}
