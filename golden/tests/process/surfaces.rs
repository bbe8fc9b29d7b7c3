//! Points on and off surfaces, rounded to a format.

use super::{Encoded as _, Point};
use fastrand::Rng;
use glam::DVec3;
use pointcore_contract::Format;
use std::f64::consts::TAU;

/// What points are drawn from; lengths are of the order of 1.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// Of radius 1.
    Sphere,
    /// Of radii 1 and 0.4.
    Torus,
    /// Through the origin, inclined.
    Plane,
    /// Through the origin, inclined.
    Line,
    /// A ball.
    Noise,
}

pub const ALL: [Shape; 5] = [Shape::Sphere, Shape::Torus, Shape::Plane, Shape::Line, Shape::Noise];

/// Those with two dimensions.
pub const SURFACES: [Shape; 3] = [Shape::Sphere, Shape::Torus, Shape::Plane];

/// The plane's normal, which is the line's direction, too.
fn inclined() -> DVec3 {
    DVec3::new(0.3, -0.5, 0.8).normalize()
}

fn direction(random: &mut Rng) -> DVec3 {
    loop {
        let vector = DVec3::from_array([(); 3].map(|()| random.f64() * 2.0 - 1.0));
        if (0.1..1.0).contains(&vector.length()) {
            return vector.normalize();
        }
    }
}

impl Shape {
    /// A point and its normal, which of what is no surface is anything.
    fn point(self, random: &mut Rng) -> (DVec3, DVec3) {
        match self {
            Self::Sphere => {
                let normal = direction(random);
                (normal, normal)
            }
            Self::Torus => {
                let ring = DVec3::new(1.0, 0.0, 0.0);
                let turn = glam::DQuat::from_rotation_z(random.f64() * TAU);
                let around = glam::DQuat::from_rotation_y(random.f64() * TAU);
                let normal = turn * (around * ring);
                (turn * ring + 0.4 * normal, normal)
            }
            Self::Plane => {
                let (first, second) = inclined().any_orthonormal_pair();
                ((random.f64() * 2.0 - 1.0) * first + (random.f64() * 2.0 - 1.0) * second, inclined())
            }
            Self::Line => ((random.f64() * 2.0 - 1.0) * inclined(), direction(random)),
            Self::Noise => (direction(random) * random.f64().cbrt(), direction(random)),
        }
    }

    /// Points around one of them that is a query beside the surface, `size` across, at `scale` and `origin`.
    pub fn neighborhood(self, random: &mut Rng, format: Format, place: Place) -> (Point, Vec<Point>) {
        let (center, normal) = self.point(random);
        let mut points = vec![];
        while points.len() < place.points {
            let (point, normal) = self.point(random);
            if point.distance(center) < place.size {
                points.push((point, normal));
            }
        }
        let off = (random.f64() - 0.5) * 0.2 * place.size;
        let at = |point: DVec3| place.origin + place.scale * point;
        let query = Point { position: at(center + off * normal), attributes: vec![] }.rounded(format);
        let point = |(point, normal): (DVec3, DVec3)| Point::with_normal(at(point), normal).rounded(format);
        (query, points.into_iter().map(point).collect())
    }
}

/// Where a neighborhood lies.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub points: usize,
    /// Largest distance of a neighbor before scaling.
    pub size: f64,
    pub scale: f64,
    pub origin: DVec3,
}

/// Coordinates a million times the spacing of points, which is a tenth: points lie on the lattice of last places of `f32`.
pub fn far() -> Place {
    Place { points: 24, size: 0.5, scale: 1.0, origin: DVec3::new(1e5, -1e5, 1e5) }
}

/// Near the origin, at three scales.
pub fn places() -> Vec<Place> {
    let place = |points, size, scale| Place { points, size, scale, origin: DVec3::ZERO };
    vec![place(24, 0.5, 1.0), place(9, 0.4, 1000.0), place(61, 0.6, 1e-3)]
}
