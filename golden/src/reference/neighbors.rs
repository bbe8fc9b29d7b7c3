//! Neighbor search by brute force: in the hardware's arithmetic, whose distances core B equals bit for bit, and in f64.
//!
//! Of all points nearer than the radius the k nearest, in order of distance and then of index. Points with NaN coordinates,
//! which fill up beats in the point memory, are never neighbors.

use crate::core_b::leaf::squared_distance;
use crate::core_b::records::Point;
use pointcore_spec::Format;
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

/// Neighbors in f64.
#[must_use]
pub fn nearest_f64(points: &[[f64; 3]], query: [f64; 3], k: usize, radius2: f64) -> Vec<Neighbor<f64>> {
    let distance2 = |point: &[f64; 3]| point.iter().zip(query).map(|(a, b)| (a - b) * (a - b)).sum();
    select(points.iter().map(distance2), k, radius2)
}

fn select<D: Copy + PartialOrd>(distances: impl Iterator<Item = D>, k: usize, radius2: D) -> Vec<Neighbor<D>> {
    let all = distances.enumerate().map(|(index, distance2)| Neighbor { index, distance2 });
    let mut neighbors: Vec<_> = all.filter(|neighbor| neighbor.distance2 < radius2).collect();
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
