//! Time in the hardware: an exposure and its bins.

use crate::{Fixed, Signedness};

/// The most parts of one length into which an exposure falls, each with tiles of its own.
pub const TIME_BINS_MAX: usize = 8;
/// Parts of a bin. Of each it is known whether something is seen within it.
pub const BIN_PARTS: u32 = 16;
/// Bits of a time behind the point: a fraction of the exposure.
pub const TIME_FRACTION_BITS: u32 = 16;
/// Bits of a time; the exposure's end is one.
pub const TIME_BITS: u32 = TIME_FRACTION_BITS + 1;
/// Bits of a splat's share of an exposure: a fraction of one, with more bits than a kernel weight has, for a bin sees but a part of that.
pub const SHARE_BITS: u32 = 20;
/// Bits of an argument and of a value of the tables of the kernel and of its integral over `[0, 1)`: differences of the integral are divided by a
/// speed of ⅛ and more.
pub const MOTION_TABLE_BITS: u32 = 24;
/// Format of how much a bin of the exposure counts: 1 where the shutter is a box.
pub const SHUTTER: Fixed = Fixed { width: 16, fraction: 15, signed: Signedness::Unsigned };
