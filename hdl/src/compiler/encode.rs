//! Constants of a floating-point format from the host's `f64`.

use pointcore_contract::Format;

const F64_MANTISSA: u32 = 52;
const F64_BIAS: i64 = 1023;

/// The number of `format` nearest to `value`, ties to even. A result below the smallest normal number becomes zero of its
/// sign, whatever the format does with subnormal numbers: a constant that small is a mistake or a zero.
pub(super) fn encode(format: Format, value: f64) -> u64 {
    let sign = if value.is_sign_negative() { format.sign_mask() } else { 0 };
    let magnitude = value.abs().to_bits();
    if value.is_nan() {
        return format.quiet_nan();
    }
    // Exponent and mantissa form one integer, in which rounding up carries into the exponent as it should.
    let dropped = F64_MANTISSA - format.mantissa;
    let half = (1_u64 << dropped) / 2;
    let odd = magnitude >> dropped & 1;
    let rounded = if dropped == 0 { magnitude } else { (magnitude + half - 1 + odd) >> dropped };
    let biased = rounded as i64 - ((F64_BIAS - i64::from(format.bias())) << format.mantissa);
    if biased < 1 << format.mantissa {
        return sign;
    }
    sign | (biased as u64).min(format.infinity())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_host() {
        for value in [0.0, -0.0, 1.0, -1.5, 0.1, 1e30, 3.4e38, 3.5e38, -1e300, 1.2e-38, f64::INFINITY] {
            assert_eq!(encode(Format::F32, value), u64::from((value as f32).to_bits()), "{value}");
        }
        assert_eq!(encode(Format::F32, f64::NAN), Format::F32.quiet_nan());
        assert_eq!(encode(Format::F16, 65504.0), 0x7bff);
        assert_eq!(encode(Format::F16, 65520.0), Format::F16.infinity());
        assert_eq!(encode(Format::BF16, 1.0 + 1.0 / 256.0), Format::BF16.one(), "a tie goes to even");
        assert_eq!(encode(Format::BF16, 1.0 + 3.0 / 256.0), Format::BF16.one() + 2);
        assert_eq!(encode(Format::F16, 1e-6), 0, "no subnormal constants");
    }
}
