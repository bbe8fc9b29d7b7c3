//! Conversion between floating-point formats. Each format's own rule for subnormals applies on its side.

use super::encoding::decode;
use pointcore_contract::Format;

/// `a`, a number of `from`, rounded to `to`.
#[must_use]
pub fn convert(from: Format, to: Format, a: u64) -> u64 {
    decode(from, a).encode(to)
}
