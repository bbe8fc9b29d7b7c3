//! Projection onto algebraic spheres: spheres come back, and every iteration is that of f64.

use super::surfaces::{Place, SURFACES, Shape, far, places};
use super::weights::{Sums, theta};
use super::{FORMATS, Format, Operator, Point, random, rounded, unit};
use glam::DVec3;

/// A sphere `u0 + g·x + u4 x²` fitted around a query, and the sums that it is made of.
struct Fit {
    mean: DVec3,
    /// Σ θ d² / W.
    square: f64,
    /// Σ θ ⟨d, n⟩ − ⟨Σ θ d, Σ θ n⟩/W, and Σ θ d² − |Σ θ d|²/W.
    ratio: [f64; 2],
    u0: f64,
    g: DVec3,
    u4: f64,
}

impl Fit {
    /// As of Guennebaud and Gross 2007, positions relative to the query.
    fn new(query: DVec3, cloud: &[Point], inverse_radius2: f64, half_beta: f64) -> Self {
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
    fn step(&self) -> f64 {
        2.0 * self.u0 / (self.g.length() + self.root())
    }

    /// By what the foot may be off, each term as the program computes it: the errors of sums, of their quotient u4, of
    /// g and u0, of the root, of the step.
    fn error(&self, query: DVec3, sums: &Sums, half_beta: f64, u: f64) -> f64 {
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
        let of_root = under / root + u * root;
        let (reach, step) = (g + root, self.step().abs());
        let of_step = (2.0 * of_u0 + step * (of_g + of_root + 3.0 * u * reach)) / reach + 2.0 * u * step;
        of_step + step * (2.0 * of_g / g + 4.0 * u) + 2.0 * u * query.length()
    }
}

#[test]
fn every_iteration_is_that_of_f64() {
    let mut random = random();
    let mut compared = 0;
    for format in FORMATS {
        let u = unit(format);
        let far = (format.mantissa == Format::F32.mantissa).then(far);
        for place in places().into_iter().chain(far) {
            let radius = 1.3 * place.size * place.scale;
            for half_beta in [0.5, 0.25, 0.0] {
                let operator = Operator::new("apss", format, &[1.0 / (radius * radius), half_beta, 0.0]);
                for shape in SURFACES {
                    for _ in 0..5 {
                        let (start, cloud) = shape.neighborhood(&mut random, format, place);
                        let mut query = start.position;
                        for count in 1..=3 {
                            let outputs = operator.run(&start, &cloud, count);
                            if outputs.outcome.iterations < count {
                                break;
                            }
                            let fit = Fit::new(query, &cloud, operator.setting(0), half_beta);
                            let sums = Sums::new(query, &cloud, operator.setting(0));
                            let foot = query - fit.step() * fit.g.normalize();
                            let bound = fit.error(query, &sums, half_beta, u);
                            let found = outputs.vector("position");
                            let what = format!("{shape:?} at {place:?} in {format}, iteration {count}");
                            assert!(outputs.flag("valid"), "{what}");
                            assert!(found.distance(foot) <= bound, "{what}: {found}, not {foot} within {bound}");
                            // Far below what a plane instead of a sphere, or another weight, would make.
                            let own = bound - 2.0 * u * query.length();
                            let share = own / (place.size * place.scale);
                            assert!(share < 65536.0 * u, "{what}: the bound {bound} says little");
                            compared += 1;
                            query = found;
                        }
                    }
                }
            }
        }
    }
    assert!(compared > 900, "only {compared} iterations were compared");
}

/// Of points on a sphere with its normals, half of the last places of points and normals, all their sums, and where the
/// query stands: eight units in the last place of the largest coordinate.
#[test]
fn spheres_come_back_within_eight_units_in_the_last_place() {
    let mut random = random();
    for format in FORMATS {
        for (radius, center) in
            [(1.0, DVec3::ZERO), (0.37, DVec3::new(1.0, -2.0, 0.5)), (4e3, DVec3::new(1e3, 0.0, 9e3))]
        {
            let place = Place { points: 30, size: 0.6, scale: radius, origin: center };
            let inverse_radius2 = 1.0 / (0.8 * radius).powi(2);
            let operator = Operator::new("apss", format, &[inverse_radius2, 0.5, 0.0]);
            for _ in 0..100 {
                let (query, cloud) = Shape::Sphere.neighborhood(&mut random, format, place);
                let outputs = operator.run(&query, &cloud, 5);
                assert!(outputs.flag("valid"));
                let position = outputs.vector("position");
                let largest = (position.abs().max_element()).max(radius);
                let last_place = 2.0 * unit(format) * largest.log2().floor().exp2();
                let off = ((position - center).length() - radius).abs() / last_place;
                assert!(off <= 8.0, "{off} units in the last place off a sphere of radius {radius} in {format}");
                let normal = (position - center) / radius;
                let turn = outputs.vector("normal").distance(normal);
                assert!(turn < 1e3 * last_place / radius, "the normal is off by {turn} in {format}");
            }
        }
    }
}

#[test]
fn neighbors_at_one_place_have_no_curvature() {
    let operator = Operator::new("apss", Format::F32, &[1.0, 0.5, 1e-6]);
    let query = Point { position: DVec3::new(0.5, 0.5, 0.5), attributes: vec![] };
    let place = rounded(Format::F32, DVec3::new(0.75, 0.5, 0.5));
    let cloud = vec![Point::with_normal(place, DVec3::X); 5];
    let outputs = operator.run(&query, &cloud, 9);
    assert!(outputs.flag("valid"));
    assert_eq!((outputs.vector("position"), outputs.number("curvature")), (place, 0.0));
}
