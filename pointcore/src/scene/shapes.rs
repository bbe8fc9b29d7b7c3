//! Procedural point sets with exact normals, sampled by golden-ratio lattices: even, and neighbors in space are near
//! in order.

use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// A sample of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceSample {
    /// Where it lies.
    pub point: DVec3,
    /// Outward unit normal.
    pub normal: DVec3,
    /// Where it lies on the surface's own map, each coordinate in `0..1`.
    pub parameters: DVec2,
}

/// The `index`-th point of a lattice of `count` points in the unit square. The golden ratio, being worst approximable,
/// keeps it even however the square is stretched.
pub fn lattice(index: usize, count: usize) -> DVec2 {
    let inverse_golden_ratio = (5_f64.sqrt() - 1.0) / 2.0;
    DVec2::new((index as f64 + 0.5) / count as f64, (index as f64 * inverse_golden_ratio).fract())
}

/// A sphere around the origin, from pole to pole along y; equal areas of it get equally many points.
pub fn sphere(count: usize, radius: f64) -> Vec<SurfaceSample> {
    let sample = |index| {
        let parameters = lattice(index, count);
        let y = 1.0 - 2.0 * parameters.x;
        let (sin, cos) = (TAU * parameters.y).sin_cos();
        let around = (1.0 - y * y).sqrt();
        let normal = DVec3::new(around * cos, y, around * sin);
        // The map's first coordinate is the latitude, for checks of equal height.
        let parameters = DVec2::new(y.acos() / PI, parameters.y);
        SurfaceSample { point: radius * normal, normal, parameters }
    };
    (0..count).map(sample).collect()
}

/// A closed tube whose center line winds around a torus about the z axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube {
    /// Radius of the torus' center circle.
    pub outer_radius: f64,
    /// Radius of the torus that the center line lies on; zero lays it on the circle itself.
    pub knot_radius: f64,
    /// Radius of the tube.
    pub tube_radius: f64,
    /// How often the center line runs around the axis, and around the torus' center circle.
    pub windings: [u32; 2],
}

impl Tube {
    /// Position, unit tangent and a unit normal of the center line, `t` in `0..1`.
    fn center_line(&self, t: f64) -> (DVec3, DVec3, DVec3) {
        let [around_axis, around_circle] = self.windings.map(|turns| TAU * f64::from(turns));
        let (sin, cos) = (around_axis * t).sin_cos();
        let (sin_circle, cos_circle) = (around_circle * t).sin_cos();
        let (radial, tangential) = (DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0));
        // The torus' normal is orthogonal to every curve on it.
        let normal = cos_circle * radial + sin_circle * DVec3::Z;
        let point = self.outer_radius * radial + self.knot_radius * normal;
        let along_circle = -sin_circle * radial + cos_circle * DVec3::Z;
        let velocity = around_axis * (self.outer_radius + self.knot_radius * cos_circle) * tangential
            + around_circle * self.knot_radius * along_circle;
        (point, velocity.normalize(), normal)
    }

    /// Samples the tube evenly along and around its center line.
    pub fn sample(&self, count: usize) -> Vec<SurfaceSample> {
        let arc_length = self.arc_lengths();
        let sample = |index| {
            let parameters = lattice(index, count);
            let (center, tangent, first) = self.center_line(parameter_at(&arc_length, parameters.x));
            let (sin, cos) = (TAU * parameters.y).sin_cos();
            let normal = cos * first + sin * tangent.cross(first);
            SurfaceSample { point: center + self.tube_radius * normal, normal, parameters }
        };
        (0..count).map(sample).collect()
    }

    /// Length of the center line up to equally spaced parameters, as a share of the whole.
    fn arc_lengths(&self) -> Vec<f64> {
        // Chords of a thousandth of a turn are a millionth shorter than their arcs.
        const STEPS_PER_TURN: u32 = 1000;
        let steps = STEPS_PER_TURN * self.windings.iter().sum::<u32>();
        let mut lengths = vec![0.0];
        let (mut length, mut previous) = (0.0, self.center_line(0.0).0);
        for step in 1..=steps {
            let point = self.center_line(f64::from(step) / f64::from(steps)).0;
            length += point.distance(previous);
            lengths.push(length);
            previous = point;
        }
        lengths.iter().map(|partial| partial / length).collect()
    }
}

/// The curve parameter at a share of the curve's length, by linear interpolation.
fn parameter_at(arc_lengths: &[f64], share: f64) -> f64 {
    let after = arc_lengths.partition_point(|length| *length < share).clamp(1, arc_lengths.len() - 1);
    let (low, high) = (arc_lengths[after - 1], arc_lengths[after]);
    ((after - 1) as f64 + (share - low) / (high - low)) / (arc_lengths.len() - 1) as f64
}

/// Points of a trefoil knot in `[-1.7, 1.7]³`, that of scenes/knot.toml.
#[must_use]
pub fn trefoil(count: usize) -> Vec<DVec3> {
    let knot = Tube { outer_radius: 1.0, knot_radius: 0.45, tube_radius: 0.22, windings: [2, 3] };
    knot.sample(count).iter().map(|sample| sample.point).collect()
}

/// A square of the xz plane around the origin that faces y, row by row. Of `count` points, the largest square number
/// is used.
pub fn plane(count: usize, size: f64) -> Vec<SurfaceSample> {
    let side = count.isqrt();
    let sample = |index| {
        let cell = DVec2::new((index % side) as f64, (index / side) as f64);
        let parameters = (cell + 0.5) / side as f64;
        let place = size * (parameters - 0.5);
        SurfaceSample { point: DVec3::new(place.x, 0.0, place.y), normal: DVec3::Y, parameters }
    };
    (0..side * side).map(sample).collect()
}
