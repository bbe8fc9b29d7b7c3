//! Comparisons. NaN compares false with everything; −0 equals +0, and so does a subnormal that the format flushes.

use super::encoding::operand;
use pointcore_contract::Format;

/// `a < b`.
#[must_use]
pub fn lt(f: Format, a: u64, b: u64) -> bool {
    matches!((rank(f, a), rank(f, b)), (Some(a), Some(b)) if a < b)
}

/// `a ≤ b`.
#[must_use]
pub fn le(f: Format, a: u64, b: u64) -> bool {
    matches!((rank(f, a), rank(f, b)), (Some(a), Some(b)) if a <= b)
}

/// `a = b`.
#[must_use]
pub fn eq(f: Format, a: u64, b: u64) -> bool {
    matches!((rank(f, a), rank(f, b)), (Some(a), Some(b)) if a == b)
}

/// An integer in the order of the numbers, the same for both zeros.
#[inline]
fn rank(f: Format, bits: u64) -> Option<i64> {
    let bits = operand(f, bits)?;
    let magnitude = (bits & !f.sign_mask()) as i64;
    Some(if bits & f.sign_mask() != 0 { -magnitude } else { magnitude })
}
