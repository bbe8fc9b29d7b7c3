//! The library's operators in f32 on one core of this machine, behind the neighbor search of a kd-tree library.

use glam::{Mat3, Vec3};
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use pointcore::process::Stage;
use pointcore_contract::process::Layout;
use std::num::NonZero;
use std::time::Instant;

/// Numbers of a point or query behind its position.
type Attributes = [f32];

/// A neighbor: its position and what is behind it.
struct Near<'a> {
    position: Vec3,
    attributes: &'a Attributes,
}

impl Near<'_> {
    fn normal(&self) -> Vec3 {
        Vec3::from_slice(self.attributes)
    }
}

/// What an operator leaves with: its first output, and whether it goes on from another place.
struct Left {
    output: Vec3,
    moves: Option<Vec3>,
}

/// A query in an iteration.
struct Asked<'a> {
    position: Vec3,
    /// Where it began.
    start: Vec3,
    iteration: u32,
    attributes: &'a Attributes,
}

type Operator = fn(&Asked<'_>, &[Near<'_>], &Settings) -> Left;

/// The settings by name.
struct Settings {
    layout: Layout,
    words: Vec<f32>,
}

impl Settings {
    fn number(&self, name: &str) -> f32 {
        self.words[self.layout.find(name).expect("the program has the setting").first]
    }

    fn vector(&self, name: &str) -> Vec3 {
        Vec3::from_slice(&self.words[self.layout.find(name).expect("the program has the setting").first..])
    }
}

/// What ran on the processor: the first output of each query, and the seconds that it took without building the tree.
type OnProcessor = (Vec<Vec3>, f64);

/// The operators of the library by their programs' names.
const OPERATORS: [(&str, Operator); 8] = [
    ("covariance", mean),
    ("normals", normal),
    ("mls", plane),
    ("apss", sphere),
    ("smooth", prediction),
    ("resample", resampled),
    ("sph_density", density),
    ("sph_forces", forces),
];

/// Seconds that the operator of a stage takes over its queries, of so many iterations at most, without building the tree.
///
/// # Panics
/// When the program is none of the library's.
pub fn seconds(stage: &Stage, iterations: u32) -> f64 {
    run(stage, iterations).1
}

fn run(stage: &Stage, iterations: u32) -> OnProcessor {
    let name = stage.program.name();
    let (_, operator) = OPERATORS.iter().find(|(known, _)| *known == name).expect("it is one of the library's");
    let floats = |words: &Vec<u32>| words.iter().map(|word| f32::from_bits(*word)).collect::<Vec<f32>>();
    let points: Vec<Vec<f32>> = stage.points.iter().map(floats).collect();
    let queries: Vec<Vec<f32>> = stage.queries.iter().map(floats).collect();
    let settings = Settings { layout: stage.program.settings.clone(), words: floats(&stage.settings) };
    let positions: Vec<[f32; 3]> = points.iter().map(|point| [point[0], point[1], point[2]]).collect();
    let tree = ImmutableKdTree::<f32, 3>::new_from_slice(&positions);
    let k = NonZero::new(stage.neighborhoods.k() as usize).expect("neighbors are asked for");
    let radius2 = stage.neighborhoods.radius().map(|radius| radius * radius);

    let started = Instant::now();
    let mut near = Vec::with_capacity(k.get());
    let mut outputs = Vec::with_capacity(queries.len());
    for query in &queries {
        let start = Vec3::from_slice(query);
        let mut asked = Asked { position: start, start, iteration: 0, attributes: &query[3..] };
        loop {
            let place = asked.position.to_array();
            let found = match radius2 {
                Some(radius2) => tree.nearest_n_within::<SquaredEuclidean>(&place, radius2, k, false),
                None => tree.nearest_n::<SquaredEuclidean>(&place, k),
            };
            near.clear();
            near.extend(found.iter().map(|found| {
                let point = &points[found.item as usize];
                Near { position: Vec3::from_slice(point), attributes: &point[3..] }
            }));
            let left = operator(&asked, &near, &settings);
            asked.iteration += 1;
            match left.moves.filter(|_| asked.iteration < iterations) {
                Some(place) => asked.position = place,
                None => {
                    outputs.push(left.output);
                    break;
                }
            }
        }
    }
    (outputs, started.elapsed().as_secs_f64())
}

/// The weight θ of equation 6.4.
fn theta(d: Vec3, inverse_radius2: f32) -> f32 {
    let falloff = (1.0 - d.length_squared() * inverse_radius2).max(0.0);
    falloff.powi(4)
}

/// The weighted mean, and the weighted covariance about it.
fn covariance(query: Vec3, near: &[Near<'_>], inverse_radius2: f32) -> (Vec3, Mat3) {
    let (mut weight, mut sum, mut squares) = (0.0, Vec3::ZERO, Mat3::ZERO);
    for point in near {
        let d = point.position - query;
        let p = d * theta(d, inverse_radius2);
        weight += theta(d, inverse_radius2);
        sum += p;
        squares += Mat3::from_cols(p * d.x, p * d.y, p * d.z);
    }
    let mean = sum / weight;
    (mean, squares - Mat3::from_cols(sum * mean.x, sum * mean.y, sum * mean.z))
}

fn mean(asked: &Asked<'_>, near: &[Near<'_>], settings: &Settings) -> Left {
    let (mean, matrix) = covariance(asked.position, near, settings.number("inverse_radius2"));
    std::hint::black_box(smallest(matrix));
    Left { output: asked.position + mean, moves: None }
}

fn normal(asked: &Asked<'_>, near: &[Near<'_>], settings: &Settings) -> Left {
    let (_, matrix) = covariance(asked.position, near, settings.number("inverse_radius2"));
    let normal = smallest(matrix);
    let away = normal.dot(settings.vector("viewpoint") - asked.position) < 0.0;
    Left { output: if away { -normal } else { normal }, moves: None }
}

/// The eigenvector of the smallest eigenvalue of a symmetric matrix, by the roots of its characteristic polynomial.
fn smallest(matrix: Mat3) -> Vec3 {
    let trace = matrix.x_axis.x + matrix.y_axis.y + matrix.z_axis.z;
    let mean = trace / 3.0;
    let centered = matrix - Mat3::from_diagonal(Vec3::splat(mean));
    let norm2 = centered.x_axis.length_squared() + centered.y_axis.length_squared() + centered.z_axis.length_squared();
    let spread = (norm2 / 6.0).sqrt();
    let half = (centered.determinant() / (2.0 * spread.powi(3))).clamp(-1.0, 1.0);
    let angle = half.acos() / 3.0 + std::f32::consts::TAU / 3.0;
    let value = mean + 2.0 * spread * angle.cos();
    let shifted = matrix - Mat3::from_diagonal(Vec3::splat(value));
    let [a, b, c] = [shifted.x_axis, shifted.y_axis, shifted.z_axis];
    let candidates = [a.cross(b), b.cross(c), c.cross(a)];
    let longest = |one: Vec3, other: Vec3| if one.length_squared() < other.length_squared() { other } else { one };
    candidates.into_iter().fold(Vec3::ZERO, longest).normalize_or_zero()
}

/// The weighted mean relative to the query, and the weighted normal.
fn fitted(asked: &Asked<'_>, near: &[Near<'_>], inverse_radius2: f32) -> (Vec3, Vec3) {
    let (mut weight, mut points, mut normals) = (0.0, Vec3::ZERO, Vec3::ZERO);
    for point in near {
        let d = point.position - asked.position;
        let theta = theta(d, inverse_radius2);
        weight += theta;
        points += d * theta;
        normals += point.normal() * theta;
    }
    (points / weight, normals.normalize_or_zero())
}

fn plane(asked: &Asked<'_>, near: &[Near<'_>], settings: &Settings) -> Left {
    let (mean, normal) = fitted(asked, near, settings.number("inverse_radius2"));
    let foot = asked.start + normal * normal.dot(asked.position - asked.start + mean);
    let is_done = normal.dot(mean).abs() <= settings.number("tolerance") || !foot.is_finite();
    Left { output: foot, moves: (!is_done).then_some(foot) }
}

fn resampled(asked: &Asked<'_>, near: &[Near<'_>], settings: &Settings) -> Left {
    let (mean, normal) = fitted(asked, near, settings.number("inverse_radius2"));
    let residual = normal.dot(mean);
    let begins = asked.iteration == 0;
    let (first, second) = normal.any_orthonormal_pair();
    let offset = if begins { first * asked.attributes[0] + second * asked.attributes[1] } else { Vec3::ZERO };
    let place = asked.position + normal * residual + offset;
    let is_done = (residual.abs() <= settings.number("tolerance") && !begins) || !place.is_finite();
    Left { output: place, moves: (!is_done).then_some(place) }
}

fn sphere(asked: &Asked<'_>, near: &[Near<'_>], settings: &Settings) -> Left {
    let (mut weight, mut points, mut normals, mut along, mut squares) = (0.0, Vec3::ZERO, Vec3::ZERO, 0.0, 0.0);
    for point in near {
        let d = point.position - asked.position;
        let theta = theta(d, settings.number("inverse_radius2"));
        weight += theta;
        points += d * theta;
        normals += point.normal() * theta;
        along += theta * d.dot(point.normal());
        squares += theta * d.length_squared();
    }
    let (m, n) = (points / weight, normals / weight);
    let u4 = settings.number("half_beta") * (along - points.dot(n)) / (squares - points.dot(m));
    let g = n - 2.0 * u4 * m;
    let u0 = -(m.dot(g) + u4 * squares / weight);
    let root = (g.length_squared() - 4.0 * u4 * u0).max(0.0).sqrt();
    let step = -2.0 * u0 / (g.length() + root);
    let foot = asked.position + g.normalize_or_zero() * step;
    let is_done = step.abs() <= settings.number("tolerance") || !foot.is_finite();
    Left { output: foot, moves: (!is_done).then_some(foot) }
}

fn prediction(asked: &Asked<'_>, near: &[Near<'_>], settings: &Settings) -> Left {
    let (spatial, influence) = (settings.number("spatial"), settings.number("influence"));
    let (mut weight, mut steps) = (0.0, Vec3::ZERO);
    for point in near {
        let d = point.position - asked.position;
        let height = point.normal().dot(d);
        let w = point.attributes[3] * (-spatial * d.length_squared() - influence * height * height).exp();
        weight += w;
        steps += point.normal() * (w * height);
    }
    Left { output: asked.position + steps / weight, moves: None }
}

fn density(asked: &Asked<'_>, near: &[Near<'_>], settings: &Settings) -> Left {
    let inverse_radius2 = settings.number("inverse_radius2");
    let share = |point: &Near<'_>| {
        let falloff = (1.0 - (point.position - asked.position).length_squared() * inverse_radius2).max(0.0);
        falloff.powi(3) * point.attributes[0]
    };
    let density = settings.number("normalization") * near.iter().map(share).sum::<f32>();
    Left { output: Vec3::splat(density), moves: None }
}

fn forces(asked: &Asked<'_>, near: &[Near<'_>], settings: &Settings) -> Left {
    let (radius, velocity) = (settings.number("radius"), Vec3::from_slice(asked.attributes));
    let (density, pressure) = (asked.attributes[3], asked.attributes[4]);
    let (mut repulsions, mut drags) = (Vec3::ZERO, Vec3::ZERO);
    for point in near {
        let d = point.position - asked.position;
        let inverse_distance = d.length_squared().max(1e-30).sqrt().recip();
        let reach = (radius - d.length()).max(0.0);
        let weight = reach * point.attributes[5] / point.attributes[3];
        let mean_pressure = 0.5 * (pressure + point.attributes[4]);
        repulsions += d * (weight * reach * mean_pressure * inverse_distance);
        drags += (point.normal() - velocity) * weight;
    }
    let force = drags * settings.number("viscosity") - repulsions;
    let factor = settings.number("normalization") / density;
    Left { output: force * factor + settings.vector("gravity"), moves: None }
}

#[cfg(test)]
mod tests {
    use super::super::{Asked, FORMAT, fluid, queries};
    use super::*;
    use pointcore::process::{Cloud, Operation, Simulation};
    use pointcore::scene::{InvalidPoints, NormalSource};
    use pointcore::search::{PointSource, SearchEngine};

    /// The processor is given the same work: what comes out is the same but for rounding, and for iterations that end early.
    #[test]
    fn operators_do_what_the_programs_do() {
        for name in Operation::names() {
            let operation = Operation::named(name).unwrap_or_else(|error| panic!("{error}"));
            let cloud = if operation.stages().len() > 1 {
                fluid::particles()
            } else {
                let surface = PointSource::Surface(2000);
                Cloud::load(FORMAT, &surface, InvalidPoints::Refuse, NormalSource::Auto).map_err(Into::into)
            };
            let cloud = cloud.unwrap_or_else(|error| panic!("{error}"));
            let asked = Asked { operation: &operation, k: 16, radius: None, iterations: 3 };
            let processed = asked.run(&cloud, &queries(&cloud, &operation, 400), Simulation::of(SearchEngine::Golden));
            for stage in &processed.unwrap_or_else(|error| panic!("{name}: {error}")).stages {
                let (ours, _) = run(stage, 3);
                let theirs = stage.answers.iter().map(|answer| {
                    let word = |place: usize| f32::from_bits(answer.outputs[place]);
                    let is_vector = stage.program.outputs.fields()[0].ty.words() == 3;
                    if is_vector { Vec3::new(word(0), word(1), word(2)) } else { Vec3::splat(word(0)) }
                });
                let theirs: Vec<Vec3> = theirs.collect();
                assert_eq!(ours.len(), theirs.len());
                let close = |(ours, theirs): (&Vec3, &Vec3)| ours.distance(*theirs) <= 1e-3 * theirs.length().max(1e-3);
                let same = ours.iter().zip(&theirs).filter(|pair| close(*pair)).count();
                let program = stage.program.name();
                assert!(same * 100 >= 98 * theirs.len(), "{program}: {same} of {} are the same", theirs.len());
            }
        }
    }
}
