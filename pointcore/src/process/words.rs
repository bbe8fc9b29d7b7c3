//! Numbers as words of a program, and back.

use crate::number::{decode, encode};
use pointcore_contract::Format;
use pointcore_contract::process::Scalar;

/// The word of a number; what is wrong with it otherwise.
pub fn encode_word(format: Format, ty: Scalar, number: f64) -> Result<u32, String> {
    match ty {
        Scalar::Float => {
            let bits = encode(format, number as f32);
            // Without their sign, infinity and NaN are the greatest.
            let is_finite = u64::from(bits) & !format.sign_mask() < format.infinity();
            if is_finite { Ok(bits) } else { Err(format!("is {number}: expected a number that is finite in {format}")) }
        }
        Scalar::Int if number.fract() == 0.0 && (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&number) => {
            Ok(number as i32 as u32)
        }
        Scalar::Int => Err(format!("is {number}: expected a whole number of 32 bits")),
        Scalar::Bool if number == 0.0 || number == 1.0 => Ok(u32::from(number == 1.0)),
        Scalar::Bool => Err(format!("is {number}: expected 1 for true or 0 for false")),
    }
}

/// The number of a word.
pub fn decode_word(format: Format, ty: Scalar, word: u32) -> f64 {
    match ty {
        Scalar::Float => decode(format, word).into(),
        Scalar::Int => f64::from(word as i32),
        Scalar::Bool => f64::from(word),
    }
}
