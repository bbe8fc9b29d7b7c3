//! A case through the arithmetic of the golden models.

use super::case::{Case, IMAGE_EDGE_PX};
use pointcore_contract::Format;
use pointcore_contract::splat::records::{Footprint, Pixel, Sample, SamplePlace, SetupSplat};
use pointcore_contract::splat::{Config, Division, Feature};
use pointcore_golden::number::Number;
use pointcore_golden::splat::{Accumulator, Dropped, Rasterizer, Setup, Transform, Weighting};

/// `e` at or below which setup takes a splat for one that crosses the eye plane.
#[must_use]
pub fn crossing_clearance(format: Format) -> f64 {
    if format.mantissa + 1 >= 24 { 1.0 / 4096.0 } else { 1.0 / 32.0 }
}

/// What became of a splat.
#[derive(Clone, Debug, PartialEq)]
pub enum Fate {
    /// It was left out.
    Dropped(Dropped),
    /// It is drawn.
    Drawn(Box<SetupSplat>),
}

/// The units, with and without a screen filter.
pub struct Units {
    /// How they divide.
    pub division: Division,
    transform: Transform,
    setup: [Setup; 2],
    rasterizer: [Rasterizer; 2],
    weighting: Weighting,
    accumulator: Accumulator,
}

impl Units {
    /// The units of a number format, dividing as the default configuration does.
    #[must_use]
    pub fn new(format: Format) -> Self {
        Self::with_division(format, Config::default().division)
    }

    /// The units of a number format that divide in one way or the other.
    #[must_use]
    pub fn with_division(format: Format, division: Division) -> Self {
        let config = |screen_filter| Config {
            width: IMAGE_EDGE_PX,
            height: IMAGE_EDGE_PX,
            geometry: format,
            division,
            screen_filter,
            culling: Feature::On,
            transform_interval: 1,
            setup_interval: 1,
            ..Config::default()
        };
        let features = [Feature::Off, Feature::On];
        let [off, on] = features.map(config);
        Self {
            division,
            transform: Transform::new(&on, 1),
            setup: features.map(|filter| Setup::new(&config(filter), 1)),
            rasterizer: [Rasterizer::new(&off, 1), Rasterizer::new(&on, 1)],
            weighting: Weighting::new(&on, 1),
            accumulator: Accumulator::new(&on),
        }
    }

    /// Transform and setup.
    #[must_use]
    pub fn fate(&self, case: &Case) -> Fate {
        let Some(splat) = self.transform.transform(&case.splat, &case.transform_uniforms()) else {
            return Fate::Dropped(Dropped::Near);
        };
        let setup = &self.setup[usize::from(case.filter.is_on())];
        match setup.outcome(&splat, &case.setup_uniforms()) {
            Ok(drawn) => Fate::Drawn(Box::new(drawn)),
            Err(dropped) => Fate::Dropped(dropped),
        }
    }

    /// The rasterizer's `ρ²` at a pixel.
    #[must_use]
    pub fn squared_distance(&self, case: &Case, footprint: &Footprint, pixel: [u32; 2]) -> Number {
        self.rasterizer[usize::from(case.filter.is_on())].squared_distance(footprint, pixel, case.filter_scale())
    }

    /// The kernel's weight there; `None` outside the splat.
    #[must_use]
    pub fn weight(&self, squared: Number) -> Option<u16> {
        Rasterizer::is_inside(squared).then(|| self.rasterizer[0].weight(squared))
    }

    /// What a pixel holds after so many samples of one splat.
    #[must_use]
    pub fn accumulated(&self, drawn: &SetupSplat, weight: u16, samples: u32) -> Pixel {
        let place = SamplePlace { inside: true, weight, ..SamplePlace::default() };
        let sample = Sample { place, band: drawn.footprint.band, attributes: drawn.attributes, ..Sample::default() };
        let weighted = self.weighting.weigh(&sample);
        let mut pixel = Pixel::default();
        for _ in 0..samples {
            pixel = self.accumulator.accumulate(&pixel, &weighted).unwrap_or(pixel);
        }
        pixel
    }
}
