//! Colors of points as formats of text write them: as shares of one, as bytes, or as words, without saying which.

use crate::color::linear_from_srgb;

/// Components that are full in each of these ways.
const FULL: [f64; 3] = [1.0, u8::MAX as f64, u16::MAX as f64];

/// Linear colors of sRGB ones, of which the greatest component says what is full.
pub(super) fn linear(colors: &[[f64; 3]]) -> Vec<[f32; 3]> {
    let greatest = colors.iter().flatten().copied().fold(0.0, f64::max);
    let full = FULL.into_iter().find(|full| greatest <= *full).unwrap_or(greatest);
    colors.iter().map(|color| of_full(*color, full)).collect()
}

/// The linear color of an sRGB one with this full component; what is no number is black.
pub(super) fn of_full(color: [f64; 3], full: f64) -> [f32; 3] {
    color.map(|value| linear_from_srgb((value / full).clamp(0.0, 1.0).max(0.0)) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_greatest_component_says_what_is_full() {
        for full in FULL {
            assert_eq!(linear(&[[full, 0.0, 0.0], [f64::NAN, -3.0, full]]), [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
        }
        assert!((linear(&[[128.0, 0.0, 0.0]])[0][0] - 0.2158).abs() < 1e-3, "decoded from sRGB");
    }
}
