//! Where a splat's footprint has its origin: its projected centre, or the vanishing point of a tangent.
//!
//! A centre before the near plane has no projection to speak of, and one far beside the image none that is known to a pixel. The tangent that
//! leads away from the eye then takes the centre's place and the centre a tangent's: the plane is the same, `s1` and `D` change places.

use crate::number::Number;
use pointcore_contract::Format;
use pointcore_contract::splat::records::Splat;

/// A centre that lies so many powers of two farther aside than away is no origin, in a format as precise as `f32`.
const ASIDE: u64 = 10;
/// The same in less precise ones.
const COARSE_ASIDE: u64 = 4;
/// Fraction bits of `f32`.
const FINE_MANTISSA_BITS: u32 = 23;

/// What is projected in the place of centre and tangents.
#[derive(Clone, Copy, Debug)]
pub(super) struct Origin {
    pub center: [Number; 3],
    pub tangents: [[Number; 3]; 2],
    /// The centre itself lies beyond the near plane.
    pub is_beyond_near: bool,
    /// A tangent has taken the centre's place.
    pub is_turned: bool,
    /// It was the second one.
    pub is_swapped: bool,
}

/// A splat's box in camera space, from its centre to both sides: no less than the splat, and without any rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub center: [Number; 3],
    pub reach: [Number; 3],
}

fn vectors(geometry: Format, splat: &Splat) -> ([Number; 3], [[Number; 3]; 2]) {
    let vector = |bits: [u32; 3]| bits.map(|bits| Number::new(geometry, bits));
    (vector(splat.center), splat.tangents.map(vector))
}

impl Origin {
    /// The origin of a splat in camera space, seen from beyond `near`; its centre where there is no near plane to see to.
    pub fn of(geometry: Format, splat: &Splat, near: Option<Number>) -> Self {
        let (center, tangents) = vectors(geometry, splat);
        let itself = Self { center, tangents, is_beyond_near: true, is_turned: false, is_swapped: false };
        let Some(near) = near else { return itself };
        let is_beyond_near = near.is_below(center[2]);
        let [first, second] = tangents;
        let is_swapped = first[2].abs().is_below(second[2].abs());
        let deepest = first[2].abs().max(second[2].abs());
        let aside = if geometry.mantissa >= FINE_MANTISSA_BITS { ASIDE } else { COARSE_ASIDE };
        let farthest = center[0].exponent_field().max(center[1].exponent_field());
        let is_aside = center[2].exponent_field() + aside < farthest;
        if center[2].is_below(deepest) && (!is_beyond_near || is_aside) {
            let (leading, other) = if is_swapped { (second, first) } else { (first, second) };
            return Self { center: leading, tangents: [other, center], is_beyond_near, is_turned: true, is_swapped };
        }
        Self { is_beyond_near, ..itself }
    }
}

impl Origin {
    /// Whether the origin is the centre, and lies beyond the near plane.
    pub fn is_centered(&self) -> bool {
        self.is_beyond_near && !self.is_turned
    }
}

impl Extent {
    pub fn of(geometry: Format, splat: &Splat) -> Self {
        let (center, [first, second]) = vectors(geometry, splat);
        // Both tangents together reach no farther than √2 times the longer one.
        Self { center, reach: [0, 1, 2].map(|i| first[i].abs().max(second[i].abs()).raised(1)) }
    }

    /// Its farthest place along an axis.
    pub fn high(&self, axis: usize) -> Number {
        self.center[axis] + self.reach[axis]
    }

    /// Its nearest.
    pub fn low(&self, axis: usize) -> Number {
        self.center[axis] - self.reach[axis]
    }
}
