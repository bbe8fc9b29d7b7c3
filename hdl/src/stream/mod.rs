//! Library units that hold items of a stream: input stream `in`, output stream `out`, fields as given.

mod fifo;
mod half_buffer;
mod skid;

pub use fifo::{fifo, fifo_distributed};
pub use half_buffer::half_buffer;
pub use skid::skid;

use rtl::{Expr, Stream, cat};

/// An item's fields side by side, the first in the most significant bits.
fn packed(stream: &Stream) -> Expr {
    cat(stream.fields.iter().map(|(_, value)| *value))
}

/// The fields of a packed item by name.
fn unpacked(word: Expr, layout: &[(impl AsRef<str>, u32)]) -> Vec<(String, Expr)> {
    let mut high = word.width();
    let fields = layout.iter().map(|(name, width)| {
        high -= width;
        (name.as_ref().to_string(), word.bits(high + width - 1, high))
    });
    fields.collect()
}

/// Bits of an item.
fn item_width(layout: &[(impl AsRef<str>, u32)]) -> u32 {
    layout.iter().map(|(_, width)| width).sum()
}
