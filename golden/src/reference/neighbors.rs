//! Neighbor search by brute force: in the hardware's arithmetic, whose distances the search core equals bit for bit, and in f64.
//!
//! Of all points nearer than the radius the k nearest, in order of distance and then of index. Points with NaN coordinates,
//! which fill up beats in the point memory, are never neighbors.

use crate::float::convert;
use crate::search::leaf::squared_distance;
use pointcore_contract::Format;
use pointcore_contract::search::records::Point;
use std::cmp::Ordering;

/// A neighbor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neighbor<D> {
    /// Index of the point.
    pub index: usize,
    /// Squared distance to the query.
    pub distance2: D,
}

/// Neighbors in the order of operations and with the roundings of the hardware; numbers are encoded in `geometry`.
#[must_use]
pub fn nearest(geometry: Format, points: &[Point], query: Point, k: usize, radius2: u32) -> Vec<Neighbor<u32>> {
    // Encodings of positive numbers are in the order of the numbers, and NaN is above infinity.
    select(points.iter().map(|point| squared_distance(geometry, *point, query)), k, radius2)
}

/// [`nearest`] over many queries: points that are too far by more than any rounding are told by the host's arithmetic, the
/// hardware's decides among the rest.
#[derive(Clone, Debug)]
pub struct BruteForce<'a> {
    geometry: Format,
    points: &'a [Point],
    /// The points as the host's numbers; those of `geometry` are among them.
    host: Vec<[f32; 3]>,
}

/// Distances are compared in blocks of so many points, so that the bound stays near.
const BLOCK_POINTS: usize = 1024;

impl<'a> BruteForce<'a> {
    /// Prepares for searches among `points`, encoded in `geometry`.
    #[must_use]
    pub fn new(geometry: Format, points: &'a [Point]) -> Self {
        let host = points.iter().map(|point| decode(geometry, *point)).collect();
        Self { geometry, points, host }
    }

    /// As [`nearest`].
    #[must_use]
    pub fn nearest(&self, query: Point, k: usize, radius2: u32) -> Vec<Neighbor<u32>> {
        // The hardware's and the host's distances are within six roundings each of the true one; flushing takes away less than
        // the smallest normal number at each of five operations.
        let slack = 1.0 + 16.0 / (1_u32 << self.geometry.mantissa) as f32;
        let flushed = 8.0 * f32::MIN_POSITIVE;
        let [x, y, z] = decode(self.geometry, query);
        let mut near: Vec<(f32, usize)> = Vec::new();
        let mut bound = f32::INFINITY;
        for (block, points) in self.host.chunks(BLOCK_POINTS).enumerate() {
            for (offset, point) in points.iter().enumerate() {
                let [dx, dy, dz] = [point[0] - x, point[1] - y, point[2] - z];
                let distance2 = dx * dx + dy * dy + dz * dz;
                if distance2 <= bound {
                    near.push((distance2, block * BLOCK_POINTS + offset));
                }
            }
            if k > 0 && near.len() > k {
                near.select_nth_unstable_by(k - 1, |a, b| a.0.total_cmp(&b.0));
                bound = near[k - 1].0 * slack + flushed;
                near.retain(|(distance2, _)| *distance2 <= bound);
            }
        }
        let measure =
            |(_, index)| Neighbor { index, distance2: squared_distance(self.geometry, self.points[index], query) };
        order(near.into_iter().map(measure).filter(|neighbor| neighbor.distance2 < radius2).collect(), k)
    }
}

fn decode(geometry: Format, point: Point) -> [f32; 3] {
    point.map(|bits| f32::from_bits(convert(geometry, Format::F32, bits.into()) as u32))
}

/// Neighbors in f64.
#[must_use]
pub fn nearest_f64(points: &[[f64; 3]], query: [f64; 3], k: usize, radius2: f64) -> Vec<Neighbor<f64>> {
    let distance2 = |point: &[f64; 3]| point.iter().zip(query).map(|(a, b)| (a - b) * (a - b)).sum();
    select(points.iter().map(distance2), k, radius2)
}

fn select<D: Copy + PartialOrd>(distances: impl Iterator<Item = D>, k: usize, radius2: D) -> Vec<Neighbor<D>> {
    let all = distances.enumerate().map(|(index, distance2)| Neighbor { index, distance2 });
    order(all.filter(|neighbor| neighbor.distance2 < radius2).collect(), k)
}

fn order<D: Copy + PartialOrd>(mut neighbors: Vec<Neighbor<D>>, k: usize) -> Vec<Neighbor<D>> {
    if k < neighbors.len() {
        neighbors.select_nth_unstable_by(k, by_distance_and_index);
        neighbors.truncate(k);
    }
    neighbors.sort_unstable_by(by_distance_and_index);
    neighbors
}

fn by_distance_and_index<D: PartialOrd>(a: &Neighbor<D>, b: &Neighbor<D>) -> Ordering {
    let by_distance = a.distance2.partial_cmp(&b.distance2).expect("what is below a radius is not NaN");
    by_distance.then(a.index.cmp(&b.index))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::for_each_seed;

    #[test]
    fn the_nearest_within_the_radius_come_in_order() {
        let points = [4.0, 1.0, f64::NAN, -1.0, 0.5, 3.0].map(|x| [x, 0.0, 0.0]);
        let indices = |k, radius2| -> Vec<_> {
            nearest_f64(&points, [0.0; 3], k, radius2).iter().map(|neighbor| neighbor.index).collect()
        };
        assert_eq!(indices(9, f64::INFINITY), [4, 1, 3, 5, 0]);
        assert_eq!(indices(2, f64::INFINITY), [4, 1]);
        assert_eq!(indices(9, 9.0), [4, 1, 3], "what lies at the radius does not count");
        assert_eq!(indices(0, 9.0), []);
    }

    #[test]
    fn a_prepared_search_finds_the_same() {
        for_each_seed("brute force", |random| {
            for geometry in [Format::F32, Format::F24.flushed()] {
                let scale = 10.0_f32.powi(random.i32(-30..=18));
                let mut coordinate = || {
                    let number = if random.bool() { random.f32() } else { (random.f32() * 4.0).round() };
                    convert(Format::F32, geometry, (number * scale).to_bits().into()) as u32
                };
                let mut points: Vec<Point> = (0..3000).map(|_| [(); 3].map(|()| coordinate())).collect();
                points[7] = [geometry.quiet_nan() as u32; 3];
                let prepared = BruteForce::new(geometry, &points);
                for query in (0..3000).step_by(300) {
                    for (k, radius) in [(1, f32::INFINITY), (20, f32::INFINITY), (5000, scale), (30, scale / 4.0)] {
                        let radius2 = convert(Format::F32, geometry, (radius * radius).to_bits().into()) as u32;
                        let expected = nearest(geometry, &points, points[query], k, radius2);
                        assert_eq!(prepared.nearest(points[query], k, radius2), expected);
                    }
                }
            }
        });
    }

    /// Differences are off by 2^−24, squares by twice that and their own rounding, and two sums round: five roundings in all.
    #[test]
    fn the_hardwares_arithmetic_is_near_f64() {
        const RELATIVE_ERROR: f64 = 5.01 / (1 << 24) as f64;
        for_each_seed("neighbors", |random| {
            let points: Vec<_> = (0..500).map(|_| [(); 3].map(|()| random.f32() - 0.5)).collect();
            let encoded: Vec<_> = points.iter().map(|point| point.map(f32::to_bits)).collect();
            let exact: Vec<_> = points.iter().map(|point| point.map(f64::from)).collect();
            for query in 0..20 {
                let hardware = nearest(Format::F32, &encoded, encoded[query], 30, f32::INFINITY.to_bits());
                let reference = nearest_f64(&exact, exact[query], 30, f64::INFINITY);
                assert_eq!((hardware.len(), hardware[0].index, hardware[0].distance2), (30, query, 0));
                for (hardware, reference) in hardware.iter().zip(&reference) {
                    let error = f64::from(f32::from_bits(hardware.distance2)) - reference.distance2;
                    assert!(error.abs() <= RELATIVE_ERROR * reference.distance2, "{hardware:?} {reference:?}");
                }
            }
        });
    }
}
