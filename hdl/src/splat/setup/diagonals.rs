//! A splat along the diagonals of the image: sums and differences of columns and rows within its bounds.

use super::axes::{Axis, Frame};
use crate::compiler::{Type, Value, name};
use crate::units::values::Values;
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::ImageDiagonals;
use pointcore_contract::{Fixed, Format, Sampling, Signedness};

/// No less than `√2`, in seven bits.
const DIAGONAL: f64 = 91.0 / 64.0;
/// Roundings of squares take no more bits.
const SLACK_BITS: u32 = 4;
/// Biased exponent of what is too far from the image's origin, 2^13 px.
const FAR_EXPONENT: u64 = 140;
/// Distances from the centre, and the centre, in 1/256 px.
const DISTANCE: Fixed = Fixed { width: 23, fraction: 8, signed: Signedness::Unsigned };
const CENTER: Fixed = Fixed { width: 22, fraction: 8, signed: Signedness::Signed };
/// Of a distance beyond all others, in px.
const FARTHEST: f64 = 32768.0;
/// Bits of a limit in 1/256 px, with its sign.
const LIMIT_BITS: u32 = 27;
/// By how many 1/256 px limits are wider than they come out.
const MARGIN: i64 = 8;

/// Distances from the centre are made wider by this power of ½.
const WIDER_BITS: u32 = 7;

/// Of sums and of differences, in 1/256 px: what rounds the first limit up and the last one down to a pixel that has a sample there.
const fn offsets(sampling: Sampling) -> [[i64; 2]; 2] {
    let [sum, difference] = match sampling {
        // A sample's coordinates add up to one more than its pixel's.
        Sampling::Center => [[256, 256], [0, 0]],
        // To ⅜ to ⅝ more, and differ by ⅝ at most to either side.
        Sampling::Flipquad => [[160, 96], [160, -160]],
    };
    [[255 - MARGIN - sum[0], MARGIN - sum[1]], [255 - MARGIN - difference[0], MARGIN - difference[1]]]
}

/// The limits, and whether they leave a pixel.
pub(super) struct Limits {
    pub record: ImageDiagonals<Values>,
    pub occupied: Value,
}

impl Limits {
    /// Less precise formats than `f24` know too little of a splat's edge for any limit. `shown` says whether the filter's disc is drawn, where that is a question.
    pub fn new(frame: &Frame, axes: [&Axis; 2], shown: Option<Value>) -> Self {
        let Frame { config, program, .. } = *frame;
        if config.geometry.mantissa < Format::F24.mantissa {
            let place = |value| program.lit(config.diagonal_bits(), value);
            let (first, last) = (place(0), place((1 << config.diagonal_bits()) - 1));
            let record =
                ImageDiagonals { first_sum: first, last_sum: last, first_difference: first, last_difference: last };
            return Self { record, occupied: program.lit(1, 1) };
        }
        let integer = |value: i64| program.constant(Type::Signed(LIMIT_BITS), value as u64 & ((1 << LIMIT_BITS) - 1));
        let [(sum_before, sum_after), (difference_before, difference_after)] = distances(frame, axes, shown);
        let [x, y] = axes.map(|axis| axis.center.to_fixed(CENTER).resize(LIMIT_BITS));
        let near = |axis: &Axis| frame.exponents().of(axis.center).lt(frame.exponents().lit(FAR_EXPONENT));
        let mut known = near(axes[0]) & near(axes[1]);
        if let Some(whole) = frame.whole {
            known = known & whole;
        }
        let (zero, largest) = (integer(0), integer((1 << config.diagonal_bits()) - 1));
        let [of_sum, of_difference] = offsets(config.sampling);
        let limits = |center: Value, before: Value, after: Value, [up, down]: [i64; 2], from: i64| {
            let first = ((center - before + integer(up)) >> DISTANCE.fraction) + integer(from);
            let last = ((center + after + integer(down)) >> DISTANCE.fraction) + integer(from);
            [known.mux(first.max(zero), zero), known.mux(last.min(largest), largest)]
        };
        let [first_sum, last_sum] = limits(x + y, sum_before, sum_after, of_sum, 0);
        let below = (1 << config.row_bits()) - 1;
        let [first_difference, last_difference] =
            limits(x - y, difference_before, difference_after, of_difference, below);
        name!(first_sum, last_sum, first_difference, last_difference);
        let occupied = first_sum.le(last_sum) & first_difference.le(last_difference);
        let place = |limit: Value| limit.bits(config.diagonal_bits() - 1, 0);
        let record = ImageDiagonals {
            first_sum: place(first_sum),
            last_sum: place(last_sum),
            first_difference: place(first_difference),
            last_difference: place(last_difference),
        };
        Self { record, occupied }
    }
}

/// How far the splat reaches before and behind its centre, along sum and difference.
fn distances(frame: &Frame, [x, y]: [&Axis; 2], shown: Option<Value>) -> [(Value, Value); 2] {
    let Config { geometry, .. } = *frame.config;
    let slack = frame.constant(1.0 + 0.5_f64.powi((geometry.mantissa + 1 - SLACK_BITS) as i32));
    let both = (x.squared + y.squared) * slack;
    let half_product = x.middle * y.middle + (x.a * y.a + x.b * y.b) * frame.f;
    let product = half_product + half_product;
    let disc = frame.filter_radius.map(|radius| radius * frame.constant(DIAGONAL));
    let farthest = frame.constant(FARTHEST);
    let distance = |reach: Value| {
        let with_disc = disc.map_or(reach, |disc| reach.max(disc));
        let reach = shown.map_or(with_disc, |shown| shown.mux(with_disc, reach));
        let distance = reach.min(farthest).to_fixed(DISTANCE).resize(LIMIT_BITS);
        (distance + (distance >> WIDER_BITS)).reinterpret(Type::Signed(LIMIT_BITS))
    };
    [(both + product, x.middle + y.middle), (both - product, x.middle - y.middle)].map(|(squared, middle)| {
        let half = frame.sqrt(squared);
        (distance(half + middle), distance(half - middle))
    })
}
