//! Library units that hold items of a stream: input stream `in`, output stream `out`, each with all fields in one port `…_data`, the
//! first on top. So there is one module for all records of a width.

mod fifo;
mod half_buffer;
mod skid;

pub use fifo::{fifo, fifo_distributed};
pub use half_buffer::{half_buffer, tentative_half_buffer};
pub use skid::{skid, tentative_skid};

use rtl::{Expr, Module, bit};

/// Whether what is pushed stays.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pushes {
    /// It does.
    ForGood,
    /// In the cycle after the one in which an item was pushed, input `in_kept` says so; else it is as if there had been none. In other
    /// cycles it is set.
    Tentative,
}

impl Pushes {
    /// The item that was pushed in the cycle before is none.
    fn taken_back(self, m: &mut Module) -> Expr {
        match self {
            Self::ForGood => bit(false),
            Self::Tentative => {
                m.variant("pushes", "tentative");
                !m.input("in_kept", 1)
            }
        }
    }
}

/// Bits of an item.
fn item_width(layout: &[(impl AsRef<str>, u32)]) -> u32 {
    layout.iter().map(|(_, width)| width).sum()
}
