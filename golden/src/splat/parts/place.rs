//! Where samples lie.

use crate::number::Number;
use pointcore_contract::{Format, Sampling};

/// Where the sample of a column and a row lies, px.
pub(crate) fn position(format: Format, sampling: Sampling, sample: [u32; 2]) -> [Number; 2] {
    const POSITION_BITS: u32 = 16;
    const FRACTION_BITS: u32 = 3;
    eighths(sampling, sample).map(|place| Number::from_fixed(format, u64::from(place), POSITION_BITS, FRACTION_BITS))
}

/// The same in eighths of a pixel.
pub(crate) const fn eighths(sampling: Sampling, [column, row]: [u32; 2]) -> [u32; 2] {
    match sampling {
        Sampling::Center => [column * 8 + 4, row * 8 + 4],
        Sampling::Flipquad => {
            let pixel = column / 2;
            let is_even = (pixel + row) % 2 == 0;
            match (column % 2 == 1, is_even) {
                (false, true) => [pixel * 8, row * 8 + 5],
                (false, false) => [pixel * 8, row * 8 + 3],
                (true, true) => [pixel * 8 + 3, row * 8],
                (true, false) => [pixel * 8 + 5, row * 8],
            }
        }
    }
}
