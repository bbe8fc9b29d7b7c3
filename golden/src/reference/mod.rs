//! The f64 reference renderer: the algorithm of the hardware (thesis 5.4) without its number formats, and the affine
//! forward mapping of ch. 3 beside it; [`neighbors`] and [`operators`] in f64.
//!
//! Splats reach every pixel in input order, which makes a frame a function of its input alone; rows are grouped into
//! bands that run in parallel.

mod footprint;
pub mod motion;
pub mod neighbors;
pub mod operators;
mod projection;
mod reconstruction;
pub mod sampling;

pub use footprint::{Footprint, Mapping};
pub use projection::{Bounds, Culled, Projection};
pub use reconstruction::{Band, Decision, Decisions, Fragment, Margins, Pixel};

use pointcore_contract::{Camera, Rendering, Splat};
use rayon::prelude::*;

/// Rows that one task renders: few enough for a small frame to use every core, enough to visit a splat rarely twice.
const BAND_ROWS: usize = 8;

/// A reconstructed frame, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Samples a row.
    pub width: usize,
    /// Rows of samples.
    pub height: usize,
    /// Normalized fragments (eq. 5.13); `None` where no splat fell.
    pub pixels: Vec<Option<Fragment>>,
    /// How each pixel's ternary depth tests went.
    pub decisions: Vec<Decisions>,
    /// How near each pixel's tests came to another outcome.
    pub margins: Vec<Margins>,
    /// What became of the splats and samples.
    pub statistics: Statistics,
}

/// Work counters of one frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Splats handed in.
    pub splats: usize,
    /// Splats culled since they face away from the eye.
    pub back_facing: usize,
    /// Splats culled since all of them lies before the near or behind the far plane.
    pub outside_depth: usize,
    /// Splats culled since no pixel's sample lies in their bounds.
    pub outside_viewport: usize,
    /// Drawn splats that cross the eye plane and so have the whole viewport for bounds.
    pub crossing: usize,
    /// Samples in the bounds of drawn splats.
    pub samples: u64,
    /// Samples inside their splat, which reach the depth test.
    pub inside: u64,
}

impl Statistics {
    /// Splats that reached the rasterizer.
    #[must_use]
    pub fn drawn(&self) -> usize {
        self.splats - self.back_facing - self.outside_depth - self.outside_viewport
    }
}

impl std::ops::Add for Statistics {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            splats: self.splats + other.splats,
            back_facing: self.back_facing + other.back_facing,
            outside_depth: self.outside_depth + other.outside_depth,
            outside_viewport: self.outside_viewport + other.outside_viewport,
            crossing: self.crossing + other.crossing,
            samples: self.samples + other.samples,
            inside: self.inside + other.inside,
        }
    }
}

/// Renders `splats` in their order.
#[must_use]
pub fn render(splats: &[Splat], camera: &Camera, rendering: &Rendering, mapping: Mapping) -> Frame {
    let prepared: Vec<_> = splats
        .par_iter()
        .map(|splat| {
            let projection = Projection::new(splat, camera)?;
            let footprint = Footprint::new(&projection, rendering, mapping)?;
            Ok((splat, projection, footprint))
        })
        .collect();

    let mut statistics = Statistics { splats: splats.len(), ..Statistics::default() };
    let mut bands = vec![Vec::new(); rendering.height.div_ceil(BAND_ROWS)];
    for result in &prepared {
        match result {
            Err(Culled::BackFacing) => statistics.back_facing += 1,
            Err(Culled::OutsideDepth) => statistics.outside_depth += 1,
            Err(Culled::OutsideViewport) => statistics.outside_viewport += 1,
            Ok(drawn @ (_, projection, footprint)) => {
                statistics.crossing += usize::from(projection.crosses_eye_plane());
                let rows = footprint.bounds.rows.clone();
                for band in &mut bands[rows.start / BAND_ROWS..=(rows.end - 1) / BAND_ROWS] {
                    band.push(drawn);
                }
            }
        }
    }

    let mut pixels = vec![Pixel::default(); rendering.width * rendering.height];
    let (samples, inside) = pixels
        .par_chunks_mut(rendering.width * BAND_ROWS)
        .zip(bands)
        .enumerate()
        .map(|(index, (band, drawn))| {
            let first_row = index * BAND_ROWS;
            let last_row = first_row + band.len() / rendering.width;
            let (mut samples, mut inside) = (0, 0);
            for (splat, projection, footprint) in drawn {
                let rows = &footprint.bounds.rows;
                for row in rows.start.max(first_row)..rows.end.min(last_row) {
                    for column in footprint.bounds.columns.clone() {
                        samples += 1;
                        let pixel = &mut band[(row - first_row) * rendering.width + column];
                        let squared_distance = footprint.squared_distance(column, row);
                        pixel.margins.note_edge(footprint.edge(column, row, squared_distance));
                        if let Some(weight) = footprint.weight_at(squared_distance) {
                            inside += 1;
                            let depth = footprint.depth(projection, rendering, column, row);
                            pixel.add(splat, Band::around(depth, projection, rendering), weight);
                        }
                    }
                }
            }
            (samples, inside)
        })
        .reduce(|| (0, 0), |a, b| (a.0 + b.0, a.1 + b.1));

    Frame {
        width: rendering.width,
        height: rendering.height,
        pixels: pixels.iter().map(Pixel::normalized).collect(),
        decisions: pixels.iter().map(|pixel| pixel.decisions).collect(),
        margins: pixels.iter().map(|pixel| pixel.margins).collect(),
        statistics: Statistics { samples, inside, ..statistics },
    }
}

#[cfg(test)]
mod tests;
