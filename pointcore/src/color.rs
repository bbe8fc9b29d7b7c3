//! sRGB components and the linear intensities they stand for (IEC 61966-2-1).

/// Below this, sRGB is linear.
const SRGB_LINEAR_LIMIT: f64 = 0.040_45;
const SRGB_LINEAR_SLOPE: f64 = 12.92;
const SRGB_OFFSET: f64 = 0.055;
const SRGB_EXPONENT: f64 = 2.4;

/// Linear intensity of an sRGB component in `0..=1`.
#[must_use]
pub fn linear_from_srgb(component: f64) -> f64 {
    if component <= SRGB_LINEAR_LIMIT {
        component / SRGB_LINEAR_SLOPE
    } else {
        ((component + SRGB_OFFSET) / (1.0 + SRGB_OFFSET)).powf(SRGB_EXPONENT)
    }
}

/// sRGB component of a linear intensity; intensities beyond `0..=1` are clipped.
#[must_use]
pub fn srgb_from_linear(intensity: f64) -> f64 {
    let intensity = intensity.clamp(0.0, 1.0);
    if intensity <= SRGB_LINEAR_LIMIT / SRGB_LINEAR_SLOPE {
        intensity * SRGB_LINEAR_SLOPE
    } else {
        (1.0 + SRGB_OFFSET) * intensity.powf(1.0 / SRGB_EXPONENT) - SRGB_OFFSET
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_round_trips_and_knows_middle_gray() {
        for step in 0..=255 {
            let component = f64::from(step) / 255.0;
            assert!((srgb_from_linear(linear_from_srgb(component)) - component).abs() < 1e-6);
        }
        assert!((linear_from_srgb(0.5) - 0.214).abs() < 1e-3);
    }
}
