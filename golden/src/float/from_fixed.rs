//! Conversion from fixed point, correctly rounded. Zero becomes +0.

use super::encoding::{Finite, Value};
use pointcore_contract::{Fixed, Format, Signedness};

/// The number that the low `fixed.width` bits of `bits` stand for, rounded to `f`.
#[must_use]
pub fn from_fixed(f: Format, bits: u64, fixed: Fixed) -> u64 {
    let unused = 64 - fixed.width;
    let (negative, significand) = match fixed.signed {
        Signedness::Signed => {
            let value = (bits << unused) as i64 >> unused;
            (value < 0, value.unsigned_abs())
        }
        Signedness::Unsigned => (false, bits << unused >> unused),
    };
    if significand == 0 {
        return Value::Zero { negative }.encode(f);
    }
    Finite { negative, exponent: -(fixed.fraction as i32), significand }.round(f)
}
