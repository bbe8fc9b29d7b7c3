//! Limits of a splat along the image's diagonals, which cut the corners of its rectangle.
//!
//! Half of what its ellipse spans there follows from what it spans along both axes and a product of both: no tangent is projected anew.
//! Where most of that cancels, `SLACK_BITS` less than a number has are sure, and so much is added. Limits are counted from the centre that the rasterizer
//! counts from, in integers, so that a place far from the image's origin costs no digits.

use super::super::parts::division::sqrt;
use super::bounds::{BOUND_FRACTION_BITS, PIXEL, Shadow, Span};
use crate::number::Number;
use pointcore_contract::splat::records::ImageDiagonals;
use pointcore_contract::splat::{Config, Division};
use pointcore_contract::{Format, Sampling};

/// `√2` from above, in seven bits, which every format has.
const DIAGONAL: (u64, u32) = (91, 6);
/// Bits that roundings of squares may take.
const SLACK_BITS: u32 = 4;
/// A limit's distance from the centre is wider by this power of ½, for what its formula magnifies near the eye plane.
const WIDER_BITS: u32 = 7;
/// Fraction bits of `f24`; less precise formats do not know a splat's edge well enough for limits.
const FINE_MANTISSA_BITS: u32 = 15;
/// Distances from the centre, in px, are below this power of two.
const DISTANCE_INTEGER_BITS: u32 = 15;
/// Centres, in px, are, else there are no limits.
const CENTER_INTEGER_BITS: u32 = 13;
/// Biased exponent of one.
const ONE: u64 = 127;
/// More than what limits lose by truncation, in units of [`BOUND_FRACTION_BITS`].
const MARGIN: i64 = 8;

/// What limits follow from.
pub(super) struct Corners {
    pub shadows: [Shadow; 2],
    pub spans: [Span; 2],
    /// `1/e`.
    pub f: Number,
    /// Of the screen filter, where its disc is drawn.
    pub radius: Option<Number>,
}

/// The diagonals of the image.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    format: Format,
    sampling: Sampling,
    row_bits: u32,
    bits: u32,
}

impl Grid {
    pub const fn new(config: &Config) -> Self {
        let (row_bits, bits) = (config.row_bits(), config.diagonal_bits());
        Self { format: config.geometry, sampling: config.sampling, row_bits, bits }
    }

    /// The limits, none without `corners`; `None` if they leave no pixel.
    pub fn diagonals(&self, division: Division, corners: Option<Corners>) -> Option<ImageDiagonals> {
        let largest = (1 << self.bits) - 1;
        let open = ImageDiagonals { first_sum: 0, last_sum: largest, first_difference: 0, last_difference: largest };
        let Some(corners) = corners.filter(|_| self.format.mantissa >= FINE_MANTISSA_BITS) else { return Some(open) };
        let Some([x, y]) = self.center(&corners) else { return Some(open) };
        let [sum, difference] = self.distances(division, &corners);
        let (nearest, farthest) = match self.sampling {
            Sampling::Center => ([PIXEL as i64, 0], [PIXEL as i64, 0]),
            Sampling::Flipquad => ([96, -160], [160, 160]),
        };
        let limits = |diagonal: usize, center: i64, [before, after]: [i64; 2], from: i64| {
            let first = center - before - MARGIN + (PIXEL as i64 - 1) - farthest[diagonal];
            let last = center + after + MARGIN - nearest[diagonal];
            let [first, last] = [first, last].map(|limit| (limit >> BOUND_FRACTION_BITS) + from);
            [first.max(0), last.min(largest.into())]
        };
        let sum = limits(0, x + y, sum, 0);
        let difference = limits(1, x - y, difference, (1 << self.row_bits) - 1);
        let is_empty = [sum, difference].iter().any(|[first, last]| first > last);
        let [[first_sum, last_sum], [first_difference, last_difference]] =
            [sum, difference].map(|limits| limits.map(|limit| limit as u16));
        (!is_empty).then_some(ImageDiagonals { first_sum, last_sum, first_difference, last_difference })
    }

    /// The centre, if it lies anywhere near the image.
    fn center(&self, corners: &Corners) -> Option<[i64; 2]> {
        let center = corners.shadows.map(|shadow| shadow.center);
        let width = 1 + CENTER_INTEGER_BITS + BOUND_FRACTION_BITS;
        let is_near = |center: &Number| center.exponent_field() < ONE + u64::from(CENTER_INTEGER_BITS);
        center.iter().all(is_near).then(|| center.map(|center| center.to_signed(width, BOUND_FRACTION_BITS)))
    }

    /// How far the splat reaches along sum and difference, before and behind its centre.
    fn distances(&self, division: Division, corners: &Corners) -> [[i64; 2]; 2] {
        let Corners { shadows: [x, y], spans: [span_x, span_y], f, radius } = *corners;
        let constant = |(value, fraction)| Number::from_fixed(self.format, value, u64::BITS, fraction);
        let slack_bits = self.format.mantissa + 1 - SLACK_BITS;
        let slack = constant(((1 << slack_bits) + 1, slack_bits));
        let both = (span_x.squared + span_y.squared) * slack;
        let half_product = span_x.middle * span_y.middle + (x.a * y.a + x.b * y.b) * f;
        let product = half_product + half_product;
        let halves = [both + product, both - product].map(|squared| sqrt(division, squared));
        let middles = [span_x.middle + span_y.middle, span_x.middle - span_y.middle];
        let disc = radius.map(|radius| radius * constant(DIAGONAL));
        [0, 1].map(|diagonal| {
            let (half, middle) = (halves[diagonal], middles[diagonal]);
            [half + middle, half - middle].map(|reach| self.distance(disc.map_or(reach, |disc| reach.max(disc))))
        })
    }

    /// A distance from the centre in units of [`BOUND_FRACTION_BITS`]; the largest of a NaN.
    fn distance(&self, reach: Number) -> i64 {
        let width = DISTANCE_INTEGER_BITS + BOUND_FRACTION_BITS;
        let farthest = Number::from_fixed(self.format, 1 << DISTANCE_INTEGER_BITS, u64::BITS, 0);
        let distance = reach.min(farthest).to_fixed(width, BOUND_FRACTION_BITS) as i64;
        distance + (distance >> WIDER_BITS)
    }
}
