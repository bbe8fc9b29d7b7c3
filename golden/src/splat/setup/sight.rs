//! Which of a splat's samples are seen, as its footprint says it to the rasterizer.

use crate::number::Number;
use pointcore_contract::Format;
use pointcore_contract::splat::records::Sight;

/// What decides of a sample, in the geometry format.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// `D` is negative before the eye.
    pub is_negative: bool,
    /// `D` at near and far plane; none where no sample lies beyond.
    pub planes: [Option<Number>; 2],
    /// The origin is a tangent's vanishing point.
    pub is_turned: bool,
    /// The filter's disc is drawn.
    pub has_disc: bool,
}

impl Limits {
    /// With limits in the rasterizer's terms.
    pub fn sight(&self, [near, far]: [u32; 2]) -> Sight {
        Sight { negative: self.is_negative, near, far, turned: self.is_turned, disc: self.has_disc }
    }

    /// In a floating-point format: magnitudes, and all ones for none.
    pub fn floating(&self, format: Format) -> Sight {
        let none = [(format.sign_mask() - 1) as u32, 0];
        let limits = [0, 1].map(|i| self.planes[i].map_or(none[i], |limit| limit.convert(format).abs().bits()));
        self.sight(limits)
    }
}
