//! Shapes of which everything is known without a reader of files: points, normals, colors, faces, and where their surface is.

use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Points of a globe's surface: several a pixel.
const GLOBE_POINTS: u32 = 30_000;
/// Seed of noise.
const SEED: u64 = 1;
/// Between neighboring points of a spiral around a sphere, as a share of a turn.
const GOLDEN_SHARE: f64 = 0.618_033_988_749_894_8;

/// A model as it goes into a file.
#[derive(Clone, Debug, Default)]
pub struct Shape {
    /// Points, in the order of the file.
    pub points: Vec<DVec3>,
    /// A normal a point, if the file has them.
    pub normals: Option<Vec<DVec3>>,
    /// An sRGB color a point, if the file has them.
    pub colors: Option<Vec<[u8; 3]>>,
    /// Faces, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Points of the surface, where those of the file do not cover it.
    pub surface: Option<Vec<DVec3>>,
}

impl Shape {
    fn of(points: impl IntoIterator<Item = DVec3>) -> Self {
        Self { points: points.into_iter().collect(), ..Self::default() }
    }

    /// Places that must be seen to be covered.
    pub fn seen(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.surface.as_ref().unwrap_or(&self.points).iter().copied().filter(|point| point.is_finite())
    }

    /// Indices of the points that are numbers.
    pub fn valid(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.points.len()).filter(|index| self.points[*index].is_finite())
    }

    /// Opposite corners of the box around the points.
    #[must_use]
    pub fn bounds(&self) -> [DVec3; 2] {
        let empty = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let valid = self.valid().map(|index| self.points[index]);
        valid.fold(empty, |[low, high], point| [low.min(point), high.max(point)])
    }

    /// The shape moved, and scaled before.
    #[must_use]
    pub fn placed(mut self, scale: f64, origin: DVec3) -> Self {
        let places = self.points.iter_mut().chain(self.surface.iter_mut().flatten());
        places.for_each(|point| *point = scale * *point + origin);
        self
    }

    /// The shape in the coordinates of a file of single precision.
    #[must_use]
    pub fn single(mut self) -> Self {
        self.points.iter_mut().for_each(|point| *point = point.as_vec3().as_dvec3());
        self
    }

    /// The shape without normals.
    #[must_use]
    pub fn bare(self) -> Self {
        Self { normals: None, ..self }
    }

    /// The shape in colors that tell its corners apart.
    #[must_use]
    pub fn colored(mut self) -> Self {
        let [low, high] = self.bounds();
        let size = (high - low).max(DVec3::splat(f64::MIN_POSITIVE));
        let color = |point: &DVec3| ((*point - low) / size).to_array().map(|share| (40.0 + 200.0 * share) as u8);
        self.colors = Some(self.points.iter().map(color).collect());
        self
    }
}

/// A unit sphere of evenly spread points.
#[must_use]
pub fn sphere(count: u32) -> Shape {
    let at = |index| {
        let height = 1.0 - 2.0 * (f64::from(index) + 0.5) / f64::from(count);
        let (sin, cos) = (TAU * GOLDEN_SHARE * f64::from(index)).sin_cos();
        let around = (1.0 - height * height).sqrt();
        DVec3::new(around * cos, height, around * sin)
    };
    let shape = Shape::of((0..count).map(at));
    Shape { normals: Some(shape.points.clone()), ..shape }
}

/// A torus about z, half as thick as it is wide.
#[must_use]
pub fn torus(around: u32, across: u32) -> Shape {
    let at = |index: u32| {
        let [turn, tilt] =
            [(index / across, around), (index % across, across)].map(|(i, n)| TAU * f64::from(i) / f64::from(n));
        let normal = DVec3::new(turn.cos() * tilt.cos(), turn.sin() * tilt.cos(), tilt.sin());
        (DVec3::new(turn.cos(), turn.sin(), 0.0) + 0.4 * normal, normal)
    };
    let (points, normals): (Vec<_>, Vec<_>) = (0..around * across).map(at).unzip();
    Shape { normals: Some(normals), ..Shape::of(points) }
}

/// A hilly square of unit size, up being z; with `relief` 0 a plane.
#[must_use]
pub fn terrain(side: u32, relief: f64) -> Shape {
    let at = |index: u32| {
        let [x, y] = [index % side, index / side].map(|i| f64::from(i) / f64::from(side - 1));
        DVec3::new(x, y, relief * (7.0 * x).sin() * (5.0 * y).cos())
    };
    Shape::of((0..side * side).map(at))
}

/// A unit cube: eight vertices and twelve faces, and its surface as a lattice of so many points along an edge.
#[must_use]
pub fn cube(along: u32) -> Shape {
    let corner = |index: u32| DVec3::new(f64::from(index & 1), f64::from(index >> 1 & 1), f64::from(index >> 2));
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    let cell = |index: u32| (f64::from(index) + 0.5) / f64::from(along);
    let surface = faces.iter().flat_map(|[a, b, _, d]| {
        let [a, b, d] = [*a, *b, *d].map(corner);
        (0..along * along).map(move |index| a + cell(index % along) * (b - a) + cell(index / along) * (d - a))
    });
    Shape { triangles, surface: Some(surface.collect()), ..Shape::of((0..8).map(corner)) }
}

/// A unit sphere as a mesh of so many strips of latitude, with normals.
#[must_use]
pub fn globe(strips: u32) -> Shape {
    let (columns, row) = (2 * strips, 2 * strips + 1);
    let at = |index: u32| {
        let (height, turn) =
            (PI * f64::from(index / row) / f64::from(strips), TAU * f64::from(index % row) / f64::from(columns));
        DVec3::new(height.sin() * turn.cos(), height.cos(), -height.sin() * turn.sin())
    };
    let corners = (0..strips * columns).flat_map(|index| {
        let first = index / columns * row + index % columns;
        [[first, first + row, first + 1], [first + 1, first + row, first + row + 1]]
    });
    let shape = Shape { triangles: corners.collect(), ..Shape::of((0..(strips + 1) * row).map(at)) };
    Shape { normals: Some(shape.points.clone()), surface: Some(sphere(GLOBE_POINTS).points), ..shape }
}

/// A rod a thousand times as long as it is thick.
#[must_use]
pub fn needle(count: u32) -> Shape {
    let at = |index: u32| {
        let (sin, cos) = (TAU * GOLDEN_SHARE * f64::from(index)).sin_cos();
        DVec3::new(f64::from(index) / f64::from(count), 5e-4 * cos, 5e-4 * sin)
    };
    Shape::of((0..count).map(at))
}

/// Points on a line that is oblique to every axis.
#[must_use]
pub fn line(count: u32) -> Shape {
    Shape::of((0..count).map(|index| f64::from(index) * DVec3::new(1.0, 0.5, 0.25)))
}

/// Points anywhere in a unit cube: noise without a surface.
#[must_use]
pub fn cloud(count: u32) -> Shape {
    let mut random = fastrand::Rng::with_seed(SEED);
    Shape::of((0..count).map(|_| DVec3::from_array([(); 3].map(|()| random.f64()))))
}

/// A shape whose points are off by up to so much in every direction, as a scanner leaves them.
#[must_use]
pub fn noisy(mut shape: Shape, noise: f64) -> Shape {
    let mut random = fastrand::Rng::with_seed(SEED);
    let mut off = || noise * (2.0 * random.f64() - 1.0);
    shape.points.iter_mut().for_each(|point| *point += DVec3::new(off(), off(), off()));
    shape
}

/// One place, so many times.
#[must_use]
pub fn repeated(count: usize) -> Shape {
    Shape::of(vec![DVec3::new(1.0, 2.0, 3.0); count])
}
