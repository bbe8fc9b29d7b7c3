//! Motion blur in f64 (thesis ch. 4): splats that move while the shutter is open.
//!
//! The exposure is the time `τ` from −1 to 1. A splat moves along a line in it, or along several that follow each other, with tangents that do not
//! change on the way. What a sample sees of one is an integral over time in closed form ([`distance`]); what hides what is settled by one of several
//! [`Method`]s. What a sample sees is shaded for each surface and each time that a method tells apart, and only then added up, with the time for
//! which anything was there as coverage.

mod a_buffer;
mod background;
mod bins;
mod disc;
pub mod distance;
mod exposure;
mod footprint;
mod interval;
mod kernel;
mod method;
mod passes;
pub mod quadrature;
mod shutter;

pub use exposure::{Exposed, Exposure};
pub use footprint::{Met, MovingFootprint};
pub use interval::Interval;
pub use kernel::{Hit, Kernel, Piece, Way};
pub use method::{COUNT_LIMIT, Method, UnknownMethod};
pub use shutter::Shutter;

use super::sampling;
use super::{BAND_ROWS, Fragment};
use glam::DVec3;
use pointcore_contract::{Camera, Rendering, Splat};
use rayon::prelude::*;

/// A splat that moves along a line.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingSplat {
    /// The splat in the middle of its part of the exposure.
    pub splat: Splat,
    /// `m`, the way of its center in a unit of `τ`: half of that in the whole exposure. In the splat's own space.
    pub motion: DVec3,
    /// The part of the exposure for which it is there.
    pub part: Interval,
}

impl MovingSplat {
    /// A splat that does not move.
    #[must_use]
    pub const fn still(splat: Splat) -> Self {
        Self { splat, motion: DVec3::ZERO, part: Interval::EXPOSURE }
    }

    /// Whether it is where it is for all of the exposure.
    #[must_use]
    pub fn is_still(&self) -> bool {
        self.motion == DVec3::ZERO && self.part == Interval::EXPOSURE
    }
}

/// A sample's place.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Its column.
    pub column: usize,
    /// Its row.
    pub row: usize,
    /// `[x, y]`, px.
    pub position: [f64; 2],
}

impl Place {
    /// The place of the sample in a column and a row.
    #[must_use]
    pub fn new(column: usize, row: usize, rendering: &Rendering) -> Self {
        Self { column, row, position: sampling::position(rendering.sampling, column, row) }
    }

    /// The viewing ray through it in camera space, at a distance of one.
    #[must_use]
    pub fn ray(&self, camera: &Camera) -> DVec3 {
        let [x, y] = self.position;
        DVec3::new((x - camera.center_x) / camera.scale_x, (y - camera.center_y) / camera.scale_y, 1.0)
    }
}

/// Linear color of a fragment that is seen at `[x, y]`, px.
pub type Shade<'a> = dyn Fn(&Fragment, [f64; 2]) -> [f64; 3] + Sync + 'a;

/// What all samples of an exposure share.
pub struct Setting<'a> {
    /// The camera, where it is in the middle of the exposure.
    pub camera: &'a Camera,
    /// Image, kernel, tolerance in depth.
    pub rendering: &'a Rendering,
    /// How light counts over the exposure.
    pub shutter: Shutter,
    /// Colors of fragments.
    pub shade: &'a Shade<'a>,
    /// Called whenever a row of samples is done.
    pub row_done: &'a (dyn Fn() + Sync),
}

/// Exposes `splats`, which reach every sample in their order.
#[must_use]
pub fn expose(splats: &[MovingSplat], method: Method, setting: &Setting) -> Exposure {
    let rendering = setting.rendering;
    let kernels: Vec<_> =
        splats.par_iter().filter_map(|splat| Kernel::new(splat, setting.camera, rendering).ok()).collect();
    let mut bands = vec![Vec::new(); rendering.height.div_ceil(BAND_ROWS)];
    for kernel in &kernels {
        let rows = &kernel.bounds.rows;
        bands[rows.start / BAND_ROWS..=(rows.end - 1) / BAND_ROWS].iter_mut().for_each(|band| band.push(kernel));
    }
    let row = |row: usize| {
        let mut hits = vec![Vec::new(); rendering.width];
        for &kernel in bands[row / BAND_ROWS].iter().filter(|kernel| kernel.bounds.rows.contains(&row)) {
            for column in kernel.bounds.columns.clone() {
                let pieces = kernel.pieces(&Place::new(column, row, rendering), setting.camera);
                if !pieces.is_empty() {
                    hits[column].push(Hit { kernel, pieces });
                }
            }
        }
        let exposed = |(column, hits): (usize, &Vec<Hit>)| {
            let place = Place::new(column, row, rendering);
            match method {
                Method::Exact => a_buffer::resolve(hits, &place, setting),
                Method::Bins(bins) => bins::resolve(hits, &place, setting, bins),
                Method::Passes(parts) => passes::resolve(hits, &place, setting, parts),
            }
        };
        let exposed: Vec<_> = hits.iter().enumerate().map(exposed).collect();
        (setting.row_done)();
        exposed
    };
    let samples = (0..rendering.height).into_par_iter().flat_map_iter(row).collect();
    Exposure { width: rendering.width, height: rendering.height, samples }
}

#[cfg(test)]
mod tests;
