//! Splats that move while the shutter is open: what hardware makes of a sample, beside f64 with a bound, beside quadrature, and cycle by cycle.

pub mod bound;
pub mod check;
pub mod depth;
pub mod lockstep;
pub mod setup;

use pointcore_contract::splat::{Config, Division, Feature};
use pointcore_contract::{Format, FragmentDepth, Sampling};

/// What is measured: `f32` as it comes, `f24` with Newton steps, and all else that changes what is computed.
#[must_use]
pub fn configurations() -> [Config; 3] {
    let image = Config {
        width: 64,
        height: 48,
        time_bins: 4,
        kernel_index_bits: 10,
        screen_filter: Feature::Off,
        ..Config::default()
    };
    let coarse = Config {
        geometry: Format::F24.flushed(),
        division: Division::Newton,
        time_bins: 8,
        kernel_index_bits: 6,
        ..image.clone()
    };
    let other = Config {
        time_bins: 1,
        kernel_gamma: 4.0,
        sampling: Sampling::Flipquad,
        depth: FragmentDepth::Plane,
        division: Division::Newton,
        ..image.clone()
    };
    [image, coarse, other]
}

#[cfg(test)]
mod tests;
