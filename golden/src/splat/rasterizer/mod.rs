//! Rasterizer: intersects the viewing ray of every pixel in a copy's bounds with the splat's plane (thesis 5.4.2, table 5.2).
//!
//! A pixel a cycle, in the rasterizer's format, floating or fixed point; samples outside the splat are dropped, but for a copy's last. Depth band and
//! attributes wait in a queue beside the datapath and meet each of their samples at its end.

mod fixed_distance;
mod motion;
mod scan;
#[cfg(test)]
mod tests;

use super::parts::division::squared_ratio;
use super::parts::place;
use crate::datapath::{self, Datapath, Token};
use crate::float::{Table, kernel_table};
use crate::number::Number;
use crate::stream::Fifo;
use crate::unit::Model;
use fixed_distance::Distance;
pub use motion::MotionRasterizer;
use pointcore_contract::splat::config::DEPTH_BITS;
use pointcore_contract::splat::records::{Attributes, Band, DepthPlane, Footprint, Sample, SamplePlace};
use pointcore_contract::splat::units::RasterizerEvents;
pub use pointcore_contract::splat::units::rasterizer::{In, Out};
use pointcore_contract::splat::{Config, Division, Feature, RasterFormat};
use pointcore_contract::{Format, Sampling};
pub use scan::columns;
use scan::{Scan, Scanner};
use std::sync::Arc;

/// The rasterizer.
#[derive(Clone, Debug)]
pub struct Rasterizer {
    format: Format,
    /// In fixed point, in the place of a format.
    fixed: Option<Distance>,
    sampling: Sampling,
    eye_plane: Feature,
    division: Division,
    has_depth_plane: bool,
    has_screen_filter: bool,
    config: Config,
    kernel: Arc<Table>,
    /// Bits of `ρ²` that the kernel sees.
    kernel_bits: u32,
    scanner: Scanner,
    copies: Fifo<(Band, Attributes)>,
    /// Samples, with their depth band where their splat has none.
    datapath: Datapath<(SamplePlace, Option<Band>)>,
    events: RasterizerEvents,
}

impl Rasterizer {
    /// The unit with a pipeline of `latency` stages.
    #[must_use]
    pub fn new(config: &Config, latency: u32) -> Self {
        let kernel_bits = config.kernel_index_bits + config.kernel_fraction_bits;
        let (format, fixed) = match config.raster_format() {
            RasterFormat::Float(format) => (format, None),
            RasterFormat::Fixed(coefficient) => {
                let (eye_plane, screen_filter) = (config.eye_plane, config.screen_filter);
                (config.geometry, Some(Distance { coefficient, kernel_bits, eye_plane, screen_filter }))
            }
        };
        Self {
            format,
            fixed,
            sampling: config.sampling,
            eye_plane: config.eye_plane,
            division: config.division,
            has_depth_plane: config.has_depth_plane(),
            has_screen_filter: config.screen_filter.is_on(),
            config: config.clone(),
            kernel: Arc::new(kernel_table(config.kernel_gamma, config.kernel_table())),
            kernel_bits,
            scanner: Scanner::new(config),
            copies: Fifo::new(datapath::tokens(latency, 1) as usize + 1),
            datapath: Datapath::new(latency, 1),
            events: RasterizerEvents::default(),
        }
    }

    fn in_ready(&self) -> bool {
        self.datapath.in_ready() && self.scanner.is_idle()
    }

    /// The sample at the scan's pixel; `None` if it lies outside the splat and nothing hangs on it.
    fn sample(&self, scan: &Scan, filter_scale: u32) -> Option<(SamplePlace, Option<Band>)> {
        let copy = &scan.copy;
        let [column, row] = scan.place(&self.config);
        let squared = self.squared_distance(&copy.footprint, [column, row], filter_scale);
        let inside = Self::is_inside(squared);
        let last = scan.is_last();
        (inside || last).then(|| {
            let place =
                SamplePlace { last, inside, slot: copy.slot, pixel: scan.pixel(), weight: self.weight(squared) };
            let has_plane = self.has_depth_plane;
            (place, has_plane.then(|| self.depth_band(&copy.footprint, [column, row])))
        })
    }

    /// Depth of the splat's plane at a sample, within the splat's range, and the ends of its ε-band.
    fn depth_band(&self, footprint: &Footprint, sample: [u32; 2]) -> Band {
        let number = |bits| Number::new(self.format, bits);
        let DepthPlane { center, slope, range, epsilon } = footprint.plane;
        let [x, y] = self.offset(footprint, sample);
        let [near, far] = range.map(number);
        let depth = (number(center) + x * number(slope[0]) + y * number(slope[1])).max(near).min(far);
        let fixed = |depth: Number| depth.max(number(0)).to_fixed(DEPTH_BITS, DEPTH_BITS) as u32;
        Band { depth: fixed(depth), low: fixed(depth - number(epsilon)), high: fixed(depth + number(epsilon)) }
    }

    /// From the splat's projected centre to a sample, px.
    fn offset(&self, footprint: &Footprint, sample: [u32; 2]) -> [Number; 2] {
        let [x, y] = place::position(self.format, self.sampling, sample);
        let [center_x, center_y] = footprint.center.map(|bits| Number::new(self.format, bits));
        [x - center_x, y - center_y]
    }

    /// Whether a sample at `ρ²` lies inside its splat; a NaN does not.
    #[must_use]
    pub fn is_inside(squared: Number) -> bool {
        squared.is_below(squared.of(1.0))
    }

    /// Kernel weight at `ρ²`.
    #[must_use]
    pub fn weight(&self, squared: Number) -> u16 {
        self.kernel.interpolate(squared.to_fixed(self.kernel_bits, self.kernel_bits)) as u16
    }

    /// `ρ²` at the sample of a pixel, given by column and row of the image; in fixed point its leading bits, infinite outside.
    #[must_use]
    pub fn squared_distance(&self, footprint: &Footprint, pixel: [u32; 2], filter_scale: u32) -> Number {
        if let Some(fixed) = &self.fixed {
            return fixed.squared(footprint, place::eighths(self.sampling, pixel), filter_scale);
        }
        let number = |bits| Number::new(self.format, bits);
        let [x, y] = self.offset(footprint, pixel);
        let [ax, ay] = [footprint.ax, footprint.ay].map(number);
        let [bx, by] = [footprint.bx, footprint.by].map(number);
        let [mx, my] = [footprint.mx, footprint.my].map(number);
        let delta = number(footprint.delta);

        let determinant = delta + x * mx + y * my;
        let along = [x * ay - y * ax, x * by - y * bx];
        let sight = &footprint.sight;
        let (across, determinant) = if sight.turned { (determinant, along[0]) } else { (along[0], determinant) };
        let is_seen = !self.eye_plane.is_on() || {
            let (near, far) = (sight.near, sight.far);
            determinant.is_negative() == sight.negative && (far..=near).contains(&determinant.abs().bits())
        };
        let on_splat = if is_seen {
            squared_ratio(self.division, [across, along[1]], determinant)
        } else {
            number(self.format.infinity() as u32)
        };
        let has_disc = self.has_screen_filter && (sight.disc || !self.eye_plane.is_on());
        if has_disc { on_splat.min((x * x + y * y) * number(filter_scale)) } else { on_splat }
    }
}

impl Model for Rasterizer {
    type Config = Config;
    type In = In;
    type Out = Out;

    fn outputs(&self) -> Out {
        let out = self.datapath.out().map(|&(place, own_band)| {
            let (band, attributes) = self.copies.out().copied().unwrap_or_default();
            Sample { place, band: own_band.unwrap_or(band), attributes, ..Sample::default() }
        });
        Out { in_ready: self.in_ready(), out, events: self.events }
    }

    fn clock(&mut self, inputs: &In) {
        let advances = self.datapath.in_ready();
        let taken = inputs.input.filter(|_| self.in_ready());
        let sample = self.scanner.current().filter(|_| advances);
        let sample = sample.map(|scan| Token::from(self.sample(scan, inputs.filter_scale)));
        self.events = self.scanner.clock(advances, taken);
        let left = self.datapath.step(sample, inputs.out_ready);
        let copy = taken.map(|copy| (copy.footprint.band, copy.attributes));
        self.copies.step(copy, left.is_some_and(|(place, _)| place.last));
    }
}
