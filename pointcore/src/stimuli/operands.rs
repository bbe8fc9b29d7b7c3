//! Operands that floating-point operators tend to get wrong.

use crate::number::{decode, encode};
use pointcore_contract::Format;
use pointcore_golden::float::mul;

/// Of so many operands the one is taken whose result is nearest to a tie.
const TIES: usize = 64;

/// A function of one number.
type Function = fn(f64) -> f64;

/// What an operand is for a result, and the result for an operand: of a root, a reciprocal and a reciprocal root.
const UNARY: [[Function; 2]; 3] =
    [[|y| y * y, f64::sqrt], [f64::recip, f64::recip], [|y| (y * y).recip(), |x| x.sqrt().recip()]];

/// Formats up to this width have all their numbers among the first operands.
const EXHAUSTIVE_WIDTH: u32 = 16;

/// An endless stream of operand triples `[a, b, c]` of one format, the same for the same seed.
///
/// First all values of `a` if the format is small, then all pairs of special values, then a random mixture: any bits;
/// special values; near cancellation of `a + b` and `a·b + c`; exponents that nearly meet; significands that lead to
/// halfway cases; exponents at which products and quotients under- or overflow; small integers and their products; roots and
/// reciprocals next to a tie.
#[derive(Clone, Debug)]
pub struct FloatCases {
    format: Format,
    random: fastrand::Rng,
    specials: Vec<u64>,
    produced: u64,
}

impl FloatCases {
    /// The stream of that seed.
    #[must_use]
    pub fn new(format: Format, seed: u64) -> Self {
        Self { format, random: fastrand::Rng::with_seed(seed), specials: specials(format), produced: 0 }
    }

    /// How many triples come before the random mixture.
    #[must_use]
    pub fn directed(&self) -> u64 {
        self.exhaustive() + (self.specials.len() * self.specials.len()) as u64
    }

    fn exhaustive(&self) -> u64 {
        if self.format.width() <= EXHAUSTIVE_WIDTH { 1 << self.format.width() } else { 0 }
    }

    fn special(&mut self) -> u64 {
        self.specials[self.random.usize(..self.specials.len())]
    }

    fn any(&mut self) -> u64 {
        self.random.u64(..=mask(self.format.width()))
    }

    /// A number of that biased exponent, moved into range, and a significand of any kind.
    fn with_exponent(&mut self, exponent: i64) -> u64 {
        let exponent = exponent.clamp(0, self.format.exponent_max() as i64) as u64;
        let sign = if self.random.bool() { self.format.sign_mask() } else { 0 };
        sign | exponent << self.format.mantissa | self.fraction()
    }

    /// A random fraction, often one of few ones or few zeros.
    fn fraction(&mut self) -> u64 {
        let bits = self.format.mantissa;
        let all = mask(bits);
        let place = self.random.u32(..=bits);
        let other = self.random.u32(..=bits);
        match self.random.u8(..8) {
            0 => mask(place) & all,
            1 => !mask(place) & all,
            2 => (1 << place) & all,
            3 => !(1 << place) & all,
            4 => (1 << place | 1 << other) & all,
            _ => self.random.u64(..=all),
        }
    }

    fn exponent(&mut self) -> i64 {
        self.random.i64(0..=self.format.exponent_max() as i64)
    }

    /// `value` with its lowest places, or nothing, or its exponent changed a little, and the sign flipped.
    fn opposite(&mut self, value: u64) -> u64 {
        let flipped = value ^ self.format.sign_mask();
        match self.random.u8(..4) {
            0 => flipped,
            1 => flipped ^ 1 << self.random.u32(..self.format.mantissa),
            2 => flipped ^ self.random.u64(..4),
            _ => flipped ^ 1 << self.format.mantissa,
        }
    }

    /// The two numbers with significands `2 − 2k·2^−mantissa` and `1 + k·2^−mantissa`, whose product rounds up to 2.
    fn rounds_up_to_two(&mut self, a: u64, b: u64) -> [u64; 2] {
        let all = mask(self.format.mantissa);
        let small = self.random.u64(1..=mask(self.format.mantissa / 2 - 1));
        [a & !all | (all + 1 - 2 * small), b & !all | small]
    }

    /// The encodings of a positive integer and its square.
    fn integer(&mut self) -> (u64, u64) {
        let bits = self.format.mantissa.div_ceil(2);
        let value = self.random.u64(1..=mask(bits));
        (self.encode(value), self.encode(value * value))
    }

    /// The encoding of an integer of at most `mantissa + 1` bits.
    fn encode(&self, value: u64) -> u64 {
        let top = value.ilog2();
        let exponent = self.format.bias() as u64 + u64::from(top);
        exponent << self.format.mantissa | (value << (self.format.mantissa - top) & mask(self.format.mantissa))
    }

    /// An operand whose result lies next to the middle of two numbers: few do so closely.
    fn next_to_a_tie(&mut self) -> u64 {
        let [operand_of, result_of] = UNARY[self.random.usize(..UNARY.len())];
        let middles = 1 << (self.format.mantissa + 1);
        let candidate = |_| {
            let tie = f64::from(middles + (self.random.u32(..middles) | 1)) / f64::from(middles);
            // In either half of the exponents.
            let tie = if self.random.bool() { tie } else { 2.0 * tie };
            let operand = encode(self.format, operand_of(tie) as f32);
            let distance = result_of(decode(self.format, operand).into()) / tie - 1.0;
            (distance.abs(), u64::from(operand))
        };
        let nearest = (0..TIES).map(candidate).min_by(|(one, _), (other, _)| one.total_cmp(other));
        nearest.expect("there are some").1
    }

    fn mixture(&mut self) -> [u64; 3] {
        let (bias, near) = (i64::from(self.format.bias()), i64::from(self.format.mantissa) + 4);
        match self.random.u8(..11) {
            0 => [self.any(), self.any(), self.any()],
            1 => [self.special(), self.any(), self.special()],
            10 => [self.next_to_a_tie(), self.any(), self.any()],
            2 => [self.any(), self.special(), self.special()],
            3 => {
                let a = self.any();
                [a, self.opposite(a), self.any()]
            }
            4 => {
                let (exponent, middle) = (self.exponent(), bias);
                let exponent = (exponent + middle) / 2;
                let distance = self.random.i64(-2..=2);
                let (a, b) = (self.with_exponent(exponent), self.with_exponent(bias + distance));
                let product = mul(self.format, a, b);
                [a, b, self.opposite(product)]
            }
            5 | 6 => {
                let (exponent, of_b) = (self.exponent(), self.random.i64(-near..=near));
                let of_c = self.random.i64(-2 * near..=2 * near);
                [
                    self.with_exponent(exponent),
                    self.with_exponent(exponent + of_b),
                    self.with_exponent(2 * exponent + of_b - bias + of_c),
                ]
            }
            7 => {
                let (exponent, distance) = (self.exponent(), self.random.i64(-near..=near));
                let border = if self.random.bool() { 0 } else { self.format.exponent_max() as i64 };
                let of_c = self.random.i64(0..=2 * near);
                let a = self.with_exponent(exponent);
                let b = self.with_exponent(border + bias - exponent + distance);
                let [a, b] = if self.random.bool() { [a, b] } else { self.rounds_up_to_two(a, b) };
                [a, b, self.with_exponent((border - of_c).abs())]
            }
            8 => {
                let (exponent, distance) = (self.exponent(), self.random.i64(-near..=near));
                let border = if self.random.bool() { 0 } else { self.format.exponent_max() as i64 };
                let b = self.with_exponent(exponent - border + bias + distance);
                [self.with_exponent(exponent), b, self.with_exponent(exponent)]
            }
            _ => {
                let ((root, square), (other, other_square)) = (self.integer(), self.integer());
                if self.random.bool() { [square, root, other] } else { [root, other, other_square] }
            }
        }
    }
}

impl Iterator for FloatCases {
    type Item = [u64; 3];

    fn next(&mut self) -> Option<[u64; 3]> {
        let index = self.produced;
        self.produced += 1;
        if index < self.exhaustive() {
            return Some([index, self.any(), self.any()]);
        }
        let index = (index - self.exhaustive()) as usize;
        let count = self.specials.len();
        if index < count * count {
            return Some([self.specials[index / count], self.specials[index % count], self.special()]);
        }
        Some(self.mixture())
    }
}

/// Numbers at the ends of every range, with both signs.
fn specials(format: Format) -> Vec<u64> {
    let (one, ulp) = (format.one(), 1_u64);
    let smallest_normal = 1 << format.mantissa;
    let binade = 1 << format.mantissa;
    let largest = format.infinity() - 1;
    let positive = [
        0,
        ulp,
        2,
        smallest_normal / 2,
        smallest_normal - 1,
        smallest_normal,
        smallest_normal + 1,
        2 * smallest_normal - 1,
        2 * smallest_normal,
        one - 1,
        one,
        one + 1,
        one - binade,
        one + binade,
        one + binade - 1,
        one + binade / 2,
        one + binade + binade / 2,
        one + u64::from(format.mantissa) * binade,
        one + u64::from(format.mantissa + 1) * binade,
        largest - 1,
        largest,
        largest - binade + 1,
        format.infinity(),
        format.infinity() + 1,
        format.quiet_nan(),
        format.quiet_nan() | 1,
    ];
    positive.iter().flat_map(|&value| [value, value | format.sign_mask()]).collect()
}

/// The low `bits` bits set.
const fn mask(bits: u32) -> u64 {
    (1 << bits) - 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_formats_are_covered_exhaustively() {
        let cases = FloatCases::new(Format::F16, 1);
        assert!(cases.take(1 << 16).map(|[a, ..]| a).eq(0..1 << 16));
    }

    #[test]
    fn operands_fit_their_format_and_repeat_with_the_seed() {
        for format in [Format::F32, Format::F24, Format::F16, Format::BF16] {
            let first: Vec<_> = FloatCases::new(format, 7).skip(1 << 16).take(20_000).collect();
            let second: Vec<_> = FloatCases::new(format, 7).skip(1 << 16).take(20_000).collect();
            assert_eq!(first, second);
            assert!(first.iter().flatten().all(|operand| operand >> format.width() == 0));
        }
    }
}
