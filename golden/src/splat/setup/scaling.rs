//! One power of two for `A`, `B`, `Δ` and `m`: `ρ²` does not depend on it, and with it no square of a visible sample's overflows or vanishes,
//! whatever the splat's size is.
//!
//! Only exponents change, so that every product and sum rounds as it would without. `Δ` and `m` are made of tangents that have been scaled
//! already, each to about one, and then take what is missing. `D` at the near plane comes to about one, since a visible sample's is not
//! far from it.

use crate::number::Number;

/// Biased exponent of one.
const ONE: i64 = 127;
/// `Δ` comes to about one, unless lengths or `m` were more than this power of two then: their products with offsets must stay finite.
const FARTHEST: i64 = 100;
/// A tangent with a smaller biased exponent has terms that vanished.
const VANISHING: i64 = 32;
/// Tangents that are longer than this power of two, measured in the centre's depth, are made shorter first: what they would overflow into
/// has no bounds in pixels.
const LONGEST: i64 = 60;

/// The coefficients of a footprint in the geometry format, times one power of two.
#[derive(Clone, Copy, Debug)]
pub struct Coefficients {
    /// `A_x`, `A_y`.
    pub a: [Number; 2],
    /// `B_x`, `B_y`.
    pub b: [Number; 2],
    /// `Δ`.
    pub delta: Number,
    /// `m_x`, `m_y`.
    pub m: [Number; 2],
    /// `Δ` as it comes from tangents of about one, and its first term: what tells a splat seen edge-on.
    pub unscaled: [Number; 2],
    /// A tangent is so short that it has lost digits to the range of exponents.
    pub is_vanishing: bool,
}

impl Coefficients {
    /// Of tangents in pixels and their depths relative to the centre's, all of them `2^lowered` times too short. What comes to about
    /// one is `Δ/scale`, which is `D` near the near plane.
    pub fn new(a: [Number; 2], b: [Number; 2], [alpha, beta]: [Number; 2], lowered: i64, scale: Number) -> Self {
        let [of_a, of_b] = [a, b].map(|pair| exponent(pair[0]).max(exponent(pair[1])));
        let [a_one, b_one] = [(a, of_a), (b, of_b)].map(|(pair, of)| pair.map(|length| length.raised(ONE - of)));
        let diagonal = a_one[0] * b_one[1];
        let delta = diagonal - b_one[0] * a_one[1];

        // Of the larger of both terms of `m`.
        let of_m = (of_a + exponent(beta)).max(of_b + exponent(alpha));
        let (beta, alpha) = (beta.raised(of_a + ONE - of_m), alpha.raised(of_b + ONE - of_m));
        let m = [beta * a_one[1] - alpha * b_one[1], alpha * b_one[0] - beta * a_one[0]];

        // Behind the products: what the scaled numbers lack. `Δ` and `m` have two tangents' factors in them.
        let (area, slope) = (of_a + of_b - ONE + lowered, of_m - ONE + lowered);
        let of_delta = area - ONE + exponent(delta);
        let of_near = of_delta + ONE - exponent(scale);
        let largest = of_near.max(of_delta.max(of_a).max(of_b).max(slope) - FARTHEST);
        Self {
            a: a.map(|length| length.raised(ONE - largest)),
            b: b.map(|length| length.raised(ONE - largest)),
            delta: delta.raised(area - largest),
            m: m.map(|m| m.raised(slope - largest)),
            unscaled: [delta, diagonal],
            is_vanishing: of_a.min(of_b) < VANISHING,
        }
    }
}

/// Tangents times a power of two such that none is more than about `2^LONGEST` times as long as the centre is deep, and by how many places
/// they have become shorter.
pub fn lowered(center_depth: Number, tangents: [[Number; 3]; 2]) -> ([[Number; 3]; 2], i64) {
    let longest = tangents.iter().flatten().map(|&part| exponent(part)).fold(0, i64::max);
    let places = (longest - exponent(center_depth) - LONGEST).max(0);
    (tangents.map(|tangent| tangent.map(|part| part.raised(-places))), places)
}

fn exponent(number: Number) -> i64 {
    number.exponent_field() as i64
}
