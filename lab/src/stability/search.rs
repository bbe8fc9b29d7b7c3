//! Samples of a splat that are not where the hardware looks for them.

use super::analysis::Analysis;
use super::case::IMAGE_EDGE_PX;
use super::truth::Truth;
use fastrand::Rng;
use pointcore_contract::splat::records::{ImageDiagonals, SetupSplat};

/// Columns or rows tried beyond each edge.
const LINES: u32 = 48;
/// Rows tried within the bounds.
const ROWS: usize = 4;
/// Samples tried anywhere.
const ANYWHERE: usize = 24;

/// How well `ρ²` is known where only its side of [`RIM`](super::check::RIM) matters.
pub const ROUGHLY: f64 = 1e-6;

/// A rectangle of pixels, inclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelArea {
    /// Its first column and row.
    pub first: [u32; 2],
    /// Its last ones.
    pub last: [u32; 2],
}

impl PixelArea {
    /// One of its pixels, often at a corner.
    pub fn pixel(&self, random: &mut Rng) -> [u32; 2] {
        [0, 1].map(|axis| match random.u8(0..8) {
            0 => self.first[axis],
            1 => self.last[axis],
            _ => random.u32(self.first[axis]..=self.last[axis]),
        })
    }

    /// Whether a pixel lies in it.
    #[must_use]
    pub fn holds(&self, pixel: [u32; 2]) -> bool {
        [0, 1].into_iter().all(|axis| (self.first[axis]..=self.last[axis]).contains(&pixel[axis]))
    }

    /// The pixels about a rectangle in f64, within the image.
    #[must_use]
    pub fn about(low: [f64; 2], high: [f64; 2]) -> Option<Self> {
        let edge = f64::from(IMAGE_EDGE_PX - 1);
        let is_seen = [0, 1].into_iter().all(|axis| low[axis] <= edge + 2.0 && high[axis] >= -1.0);
        is_seen.then(|| Self {
            first: low.map(|low| (low - 1.0).clamp(0.0, edge) as u32),
            last: high.map(|high| (high + 1.0).clamp(0.0, edge) as u32),
        })
    }
}

/// The image.
#[must_use]
pub const fn whole_image() -> PixelArea {
    PixelArea { first: [0; 2], last: [IMAGE_EDGE_PX - 1; 2] }
}

/// Whether a pixel lies within the bounds of a splat.
#[must_use]
pub fn holds(drawn: &SetupSplat, pixel: [u32; 2]) -> bool {
    let ImageDiagonals { first_sum, last_sum, first_difference, last_difference } = drawn.diagonals;
    let [column, row] = pixel;
    let (sum, difference) = (column + row, column + (IMAGE_EDGE_PX - 1 - row));
    area(drawn).holds(pixel)
        && (u32::from(first_sum)..=last_sum.into()).contains(&sum)
        && (u32::from(first_difference)..=last_difference.into()).contains(&difference)
}

/// The rectangle that a splat's bounds begin with.
#[must_use]
pub fn area(drawn: &SetupSplat) -> PixelArea {
    let bounds = &drawn.bounds;
    PixelArea { first: [bounds.left, bounds.top].map(u32::from), last: [bounds.right, bounds.bottom].map(u32::from) }
}

/// A search for samples that lie exactly inside a splat.
pub struct InsideSearch<'a> {
    /// The splat.
    pub truth: &'a Truth,
    /// Where it lies, roughly.
    pub analysis: &'a Analysis,
    /// What need not be searched.
    pub bounds: Option<&'a SetupSplat>,
    /// The rectangle of the bounds is known to hold the splat; their cut corners may not.
    pub is_closed: bool,
}

impl InsideSearch<'_> {
    /// Samples inside the splat, with their `ρ²`. Those of a splat before the eye are found along lines beyond the bounds; others, and those
    /// of a filter's disc, where chance has it.
    pub fn samples(&self, random: &mut Rng) -> impl Iterator<Item = ([u32; 2], f64)> {
        let mut pixels: Vec<_> = (0..ANYWHERE).map(|_| self.around().pixel(random)).collect();
        pixels.extend(self.disc());
        if self.truth.is_whole() {
            let axes = if self.is_closed { 0..0 } else { 0..2 };
            for axis in axes {
                for line in self.lines(axis) {
                    pixels.extend(self.on_line(axis, line));
                }
            }
            // Where corners are cut, a row's first or last sample is what may be missing.
            if let Some(PixelArea { first: [_, top], last: [_, bottom] }) = self.bounds.map(area) {
                let rows = [top, bottom].into_iter().chain((2..ROWS).map(|_| random.u32(top..=bottom)));
                pixels.extend(rows.flat_map(|row| self.on_line(1, row)));
            }
        }
        pixels.retain(|&pixel| self.bounds.is_none_or(|drawn| !holds(drawn, pixel)));
        let hits = pixels.into_iter().map(|pixel| (pixel, self.truth.hit(pixel, ROUGHLY)));
        let inside = hits.filter(|(_, hit)| hit.is_inside);
        inside.map(|(pixel, hit)| (pixel, hit.squared_distance)).collect::<Vec<_>>().into_iter()
    }

    /// Where samples are likely.
    fn around(&self) -> PixelArea {
        let [[low_x, high_x], [low_y, high_y]] = self.analysis.bounds.map(|ends| ends.map(|bound| bound.value));
        let known = [low_x, high_x, low_y, high_y].iter().all(|end| end.is_finite()) && self.truth.is_whole();
        let about = known.then(|| PixelArea::about([low_x, low_y], [high_x, high_y])).flatten();
        about.unwrap_or(whole_image())
    }

    /// Pixels about the projected centre.
    fn disc(&self) -> Vec<[u32; 2]> {
        let [x, y] = self.analysis.center().map(|center| center.floor());
        let offsets = [-1.0, 0.0, 1.0];
        let pixels = offsets.into_iter().flat_map(|dx| offsets.map(|dy| [x + dx, y + dy]));
        let seen = 0.0..f64::from(IMAGE_EDGE_PX);
        pixels.filter(|pixel| pixel.iter().all(|x| seen.contains(x))).map(|pixel| pixel.map(|x| x as u32)).collect()
    }

    /// Columns (axis 0) or rows to look along.
    fn lines(&self, axis: usize) -> Vec<u32> {
        let around = self.around();
        match self.bounds.map(area) {
            Some(bounds) => {
                let below = (around.first[axis]..bounds.first[axis]).rev().take(LINES as usize);
                below.chain((bounds.last[axis] + 1..=around.last[axis]).take(LINES as usize)).collect()
            }
            None => (around.first[axis]..=around.last[axis]).take(LINES as usize).collect(),
        }
    }

    /// Both ends and the middle of a line's chord.
    fn on_line(&self, axis: usize, line: u32) -> Vec<[u32; 2]> {
        let Some(chord) = self.truth.chord(axis, line) else { return Vec::new() };
        let (start, end) = chord.into_inner();
        let edge = i64::from(IMAGE_EDGE_PX - 1);
        if end < 0 || start > edge {
            return Vec::new();
        }
        let (start, end) = (start.clamp(0, edge), end.clamp(0, edge));
        let mut places = vec![start, start + 1, (start + end) / 2, end - 1, end];
        places.retain(|place| (start..=end).contains(place));
        places.dedup();
        places.into_iter().map(|place| if axis == 0 { [line, place as u32] } else { [place as u32, line] }).collect()
    }
}
