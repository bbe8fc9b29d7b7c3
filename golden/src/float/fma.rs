//! Fused multiply-add.
//!
//! The product is exact, in flushing formats too: only the sum is rounded and flushed. Zero times infinity is NaN
//! whatever is added.

use super::add::sum;
use super::encoding::decode;
use super::mul::product;
use pointcore_contract::Format;

/// `a · b + c`, rounded once.
#[must_use]
pub fn fma(f: Format, a: u64, b: u64, c: u64) -> u64 {
    sum(product(decode(f, a), decode(f, b)), decode(f, c)).encode(f)
}
