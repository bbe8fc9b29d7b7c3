//! Models of the bus units (`docs/interfaces.md`), transaction by transaction: what moves and what is refused, not when. Time is
//! the protocol's business, which proofs and the tests under stalls hold; only `abort` and `frames` have their own.

pub mod abort;
pub mod frames;
pub mod packet_in;
pub mod packet_out;
pub mod reader;
pub mod registers;
pub mod window;
pub mod writer;

pub use abort::Abort;
pub use frames::{Frames, FramesIn};
pub use packet_in::{PacketIn, Verdict};
pub use packet_out::PacketOut;
pub use reader::Reader;
pub use registers::{Registers, Response};
pub use window::Window;
pub use writer::Writer;

/// A burst of a memory port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Burst {
    /// Its first byte.
    pub address: u32,
    /// Its beats.
    pub beats: u32,
}
