//! Floating-point operators on encoded values.
//!
//! Every operator takes and returns the low [`Format::width`](pointcore_contract::Format::width) bits of a `u64`. It rounds
//! to nearest, ties to even, once; returns the canonical quiet NaN whenever its result is a NaN; and follows the
//! format's rule for subnormal operands and results. It decodes, computes an exact or sticky-terminated raw value, and
//! leaves range, rounding and subnormals to one shared rounder.
//!
//! Formats may have up to 11 exponent bits and from 2 to 28 mantissa bits (25 for the Newton variants); other formats
//! and operand bits beyond the width are caught by debug assertions.

mod add;
mod compare;
mod convert;
mod div;
mod encoding;
mod erf;
mod exp_neg;
mod fma;
mod from_fixed;
mod minmax;
mod mul;
mod newton;
mod recip_newton;
mod rsqrt;
mod rsqrt_newton;
mod sqrt;
mod table;
mod to_fixed;

pub use add::{add, sub};
pub use compare::{eq, le, lt};
pub use convert::convert;
pub use div::{div, recip};
pub use erf::{erf_table, kernel_integral_table};
pub use exp_neg::kernel_table;
pub use fma::fma;
pub use from_fixed::from_fixed;
pub use minmax::{max, min};
pub use mul::mul;
pub use recip_newton::recip_newton;
pub use rsqrt::rsqrt;
pub use rsqrt_newton::rsqrt_newton;
pub use sqrt::sqrt;
pub use table::Table;
pub use to_fixed::{to_fixed, to_fixed_checked};
