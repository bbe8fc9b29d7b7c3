//! What came in while the shutter was open.

use super::{Place, Shade};
use crate::reference::Frame;
use pointcore_contract::Rendering;
use rayon::prelude::*;

/// What one sample saw.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exposed {
    /// Linear light of all surfaces, each times the share of the exposure for which it was seen.
    pub light: [f64; 3],
    /// The share of the exposure for which any surface was seen; the background's is the rest.
    pub coverage: f64,
}

impl Exposed {
    /// Adds a surface of a color, seen for a share of the exposure.
    pub fn add(&mut self, color: [f64; 3], share: f64) {
        self.light.iter_mut().zip(color).for_each(|(sum, component)| *sum += share * component);
        self.coverage += share;
    }

    /// Linear light over a background.
    #[must_use]
    pub fn over(&self, background: [f64; 3]) -> [f64; 3] {
        let rest = 1.0 - self.coverage;
        [0, 1, 2].map(|component| self.light[component] + rest * background[component])
    }
}

/// An exposed image, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Exposure {
    /// Samples a row.
    pub width: usize,
    /// Rows of samples.
    pub height: usize,
    /// What each sample saw.
    pub samples: Vec<Exposed>,
}

impl Exposure {
    /// Nothing seen so far.
    #[must_use]
    pub fn dark(rendering: &Rendering) -> Self {
        let (width, height) = (rendering.width, rendering.height);
        Self { width, height, samples: vec![Exposed::default(); width * height] }
    }

    /// Adds a still frame that stands for a share of the exposure: temporal supersampling is the sum of many.
    pub fn add(&mut self, frame: &Frame, share: f64, rendering: &Rendering, shade: &Shade) {
        let width = self.width;
        self.samples.par_iter_mut().zip(&frame.pixels).enumerate().for_each(|(index, (sample, fragment))| {
            if let Some(fragment) = fragment {
                let place = Place::new(index % width, index / width, rendering);
                sample.add(shade(fragment, place.position), share);
            }
        });
    }
}
