//! The algebraic sphere that queries are projected onto (Guennebaud and Gross 2007).

use super::Point;
use super::weights::{Sums, theta};
use glam::DVec3;

/// A sphere `u0 + g·x + u4 x²` fitted around a query, and the sums that it is made of.
pub struct Fit {
    mean: DVec3,
    /// Σ θ d² / W.
    square: f64,
    /// Σ θ ⟨d, n⟩ − ⟨Σ θ d, Σ θ n⟩/W, and Σ θ d² − |Σ θ d|²/W.
    ratio: [f64; 2],
    /// The constant term.
    pub u0: f64,
    /// The gradient at the query.
    pub g: DVec3,
    /// The curvature.
    pub u4: f64,
}

/// By what parts of a fit may be off.
struct Roundings {
    of_g: f64,
    of_u0: f64,
    of_root: f64,
}

impl Fit {
    /// As of Guennebaud and Gross 2007, positions relative to the query.
    #[must_use]
    pub fn new(query: DVec3, cloud: &[Point], inverse_radius2: f64, half_beta: f64) -> Self {
        let sum = |value: &dyn Fn(DVec3, DVec3) -> f64| -> f64 {
            let of = |point: &Point| {
                let d = point.position - query;
                theta(d.length_squared(), inverse_radius2) * value(d, point.normal())
            };
            cloud.iter().map(of).sum()
        };
        let vector = |value: &dyn Fn(DVec3, DVec3) -> DVec3| {
            DVec3::new(sum(&|d, n| value(d, n).x), sum(&|d, n| value(d, n).y), sum(&|d, n| value(d, n).z))
        };
        let weight = sum(&|_, _| 1.0);
        let (points, normals) = (vector(&|d, _| d), vector(&|_, n| n));
        let squares = sum(&|d, _| d.length_squared());
        let numerator = sum(&|d, n| d.dot(n)) - points.dot(normals) / weight;
        let denominator = squares - points.length_squared() / weight;
        let u4 = half_beta * numerator / denominator;
        let g = (normals - 2.0 * u4 * points) / weight;
        let u0 = -(points.dot(g) + u4 * squares) / weight;
        Self { mean: points / weight, square: squares / weight, ratio: [numerator, denominator], u0, g, u4 }
    }

    fn root(&self) -> f64 {
        (self.g.length_squared() - 4.0 * self.u4 * self.u0).sqrt()
    }

    /// Signed length of the way to the surface, along −g.
    #[must_use]
    pub fn step(&self) -> f64 {
        2.0 * self.u0 / (self.g.length() + self.root())
    }

    /// Whether it has a surface for certain, whatever rounding does.
    #[must_use]
    pub fn is_met(&self, sums: &Sums, half_beta: f64, u: f64) -> bool {
        let Roundings { of_g, of_root, .. } = self.roundings(sums, half_beta, u);
        2.0 * of_g < self.g.length() && 2.0 * of_root < self.root()
    }

    /// By what the foot may be off.
    #[must_use]
    pub fn error(&self, query: DVec3, sums: &Sums, half_beta: f64, u: f64) -> f64 {
        let Roundings { of_g, of_u0, of_root } = self.roundings(sums, half_beta, u);
        let (g, root, step) = (self.g.length(), self.root(), self.step().abs());
        let reach = g + root;
        let of_step = (2.0 * of_u0 + step * (of_g + of_root + 3.0 * u * reach)) / reach + 2.0 * u * step;
        of_step + step * (2.0 * of_g / g + 4.0 * u) + 2.0 * u * query.length()
    }

    /// Each term as the program computes it: the errors of sums, of their quotient u4, of g and u0, of the root.
    fn roundings(&self, sums: &Sums, half_beta: f64, u: f64) -> Roundings {
        let (m, g, u4, u0) = (self.mean.length(), self.g.length(), self.u4.abs(), self.u0.abs());
        let mean = u * sums.mean_error();
        let normal = u * (6.0 * sums.error(0) / sums.weight + 2.0);
        let numerator = u * 3.0 * (sums.error(1) + 2.0 * sums.first) + sums.first * normal + u * sums.error(1);
        let denominator = u * (sums.error(2) + sums.error(1) * m + 3.0 * sums.second) + sums.first * mean;
        let [above, below] = self.ratio;
        let quotient = (numerator + (above / below).abs() * denominator) / below;
        let of_u4 = half_beta * quotient + 2.0 * u * u4;
        let of_g = normal + 2.0 * (u4 * mean + of_u4 * m) + 4.0 * u * (1.0 + 2.0 * u4 * m);
        let square = u * (sums.error(2) + self.square * sums.error(0) + 2.0 * sums.second) / sums.weight;
        let of_u0 = mean * g + m * of_g + of_u4 * self.square + u4 * square + 4.0 * u * (m * g + u4 * self.square);
        let root = self.root();
        let under = 2.0 * g * of_g + 4.0 * (of_u4 * u0 + u4 * of_u0) + 8.0 * u * (g * g + 4.0 * u4 * u0);
        Roundings { of_g, of_u0, of_root: under / root + u * root }
    }
}
