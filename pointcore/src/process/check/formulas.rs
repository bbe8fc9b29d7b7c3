//! Which formulas a program of the library is compared with.

use super::validity::is_valid;
use super::{Iteration, Left, Off};
use pointcore_golden::reference::operators::covariance::{angle_error, covariance, eigen, matrix_error, trace};
use pointcore_golden::reference::operators::fluid;
use pointcore_golden::reference::operators::plane::{normal_error, plane};
use pointcore_golden::reference::operators::smooth::prediction;
use pointcore_golden::reference::operators::sphere::Fit;
use pointcore_golden::reference::operators::weights::Sums;

/// The formulas of a program.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Formula {
    Covariance,
    Normals,
    Plane,
    Sphere,
    Smooth,
    Pattern,
    Density,
    Forces,
}

const FORMULAS: [(&str, Formula, &[&str]); 8] = [
    ("covariance", Formula::Covariance, &["mean", "normal", "variation", "valid"]),
    ("normals", Formula::Normals, &["normal", "variation", "valid"]),
    ("mls", Formula::Plane, &["position", "normal", "residual", "valid"]),
    ("apss", Formula::Sphere, &["position", "valid"]),
    ("smooth", Formula::Smooth, &["position", "valid"]),
    ("resample", Formula::Pattern, &["position", "normal", "valid"]),
    ("sph_density", Formula::Density, &["density", "pressure"]),
    ("sph_forces", Formula::Forces, &["acceleration"]),
];

impl Formula {
    /// Programs that have formulas.
    pub fn names() -> Vec<&'static str> {
        FORMULAS.iter().map(|(name, ..)| *name).collect()
    }

    /// That of a program.
    pub fn of(program: &str) -> Option<Self> {
        FORMULAS.iter().find(|(name, ..)| *name == program).map(|(_, formula, _)| *formula)
    }

    /// Outputs that it gives.
    pub fn outputs(self) -> &'static [&'static str] {
        FORMULAS.iter().find(|(_, formula, _)| *formula == self).map_or(&[], |(.., outputs)| outputs)
    }

    /// What a query's outputs are off by; of one that is not valid whether it is none.
    pub fn off(self, iteration: &Iteration<'_>, left: &Left<'_>) -> Vec<Off> {
        let is_fluid = matches!(self, Self::Density | Self::Forces);
        let claimed = is_fluid || left.number("valid") != 0.0;
        let mut offs = if claimed { self.values(iteration, left) } else { vec![] };
        if let Some(valid) = is_valid(self, iteration) {
            offs.push(Off { output: "valid", error: f64::from(u8::from(valid != claimed)), bound: 0.5 });
        }
        offs
    }

    fn values(self, iteration: &Iteration<'_>, left: &Left<'_>) -> Vec<Off> {
        match self {
            Self::Covariance => covariances(iteration, left, Direction::Either),
            Self::Normals => covariances(iteration, left, Direction::Viewpoint),
            Self::Plane => planes(iteration, left, iteration.start),
            // Its first iteration puts a query into its pattern.
            Self::Pattern if iteration.count == 0 => vec![],
            Self::Pattern => planes(iteration, left, iteration.query.position),
            Self::Sphere => spheres(iteration, left),
            Self::Smooth => smoothed(iteration, left),
            Self::Density => densities(iteration, left),
            Self::Forces => forces(iteration, left),
        }
    }
}

/// Which side a normal is on.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Direction {
    Either,
    Viewpoint,
}

fn covariances(iteration: &Iteration<'_>, left: &Left<'_>, direction: Direction) -> Vec<Off> {
    let Iteration { query, cloud, settings, u, .. } = iteration;
    let (position, inverse_radius2) = (query.position, settings[0]);
    let (mean, matrix) = covariance(position, cloud, inverse_radius2);
    let pairs = eigen(matrix);
    let values = pairs.map(|(value, _)| value);
    let sums = Sums::new(position, cloud, inverse_radius2);
    let entries = matrix_error(&sums, trace(position, mean, cloud, inverse_radius2), *u);
    let normal = left.vector("normal");
    let angle = normal.cross(pairs[0].1).length();
    let share = normal.dot(matrix * normal) / normal.length_squared();
    let share_error = (left.number("variation") - share).abs();
    let mut offs = vec![
        Off { output: "normal", error: angle, bound: angle_error(values, entries, *u) },
        Off { output: "variation", error: share_error, bound: 9.0 * entries + 12.0 * u },
    ];
    if direction == Direction::Viewpoint {
        let view = glam::DVec3::from_slice(&settings[2..]) - position;
        // A product of two vectors of three components, one of them a difference: six roundings.
        offs.push(Off { output: "normal", error: (-normal.dot(view)).max(0.0), bound: 6.0 * u * view.length() });
    } else {
        let bound = u * (2.0 * sums.mean_error() + 2.0 * position.length());
        offs.push(Off { output: "mean", error: left.vector("mean").distance(mean), bound });
    }
    offs
}

/// `start` is what is projected onto the plane at the query.
fn planes(iteration: &Iteration<'_>, left: &Left<'_>, start: glam::DVec3) -> Vec<Off> {
    let Iteration { query, cloud, settings, u, .. } = iteration;
    let (position, inverse_radius2) = (query.position, settings[0]);
    let (mean, normal) = plane(position, cloud, inverse_radius2);
    let foot = start + normal * normal.dot(mean - start);
    let turn = u * normal_error(position, cloud, inverse_radius2);
    // The mean's error, the normal's times what is projected, once for the length and once for the direction; seven
    // roundings of it, and one of the position.
    let mean_error = u * 2.0 * Sums::new(position, cloud, inverse_radius2).mean_error();
    let bound = mean_error + (2.0 * turn + 7.0 * u) * (mean - start).length() + 3.0 * u * start.length();
    let mut offs = vec![
        Off { output: "position", error: left.vector("position").distance(foot), bound },
        Off { output: "normal", error: left.vector("normal").distance(normal), bound: turn },
    ];
    if left.stage.program.outputs.find("residual").is_some() {
        let error = (left.number("residual") - normal.dot(mean - position)).abs();
        offs.push(Off { output: "residual", error, bound });
    }
    offs
}

fn spheres(iteration: &Iteration<'_>, left: &Left<'_>) -> Vec<Off> {
    let Iteration { query, cloud, settings, u, .. } = iteration;
    let (position, half_beta) = (query.position, settings[1]);
    let fit = Fit::new(position, cloud, settings[0], half_beta);
    let sums = Sums::new(position, cloud, settings[0]);
    let foot = position - fit.step() * fit.g.normalize();
    let bound = fit.error(position, &sums, half_beta, *u);
    vec![Off { output: "position", error: left.vector("position").distance(foot), bound }]
}

fn smoothed(iteration: &Iteration<'_>, left: &Left<'_>) -> Vec<Off> {
    let Iteration { query, cloud, settings, u, .. } = iteration;
    let (step, bound) = prediction(query.position, cloud, [settings[0], settings[1]], *u);
    vec![Off { output: "position", error: left.vector("position").distance(query.position + step), bound }]
}

fn densities(iteration: &Iteration<'_>, left: &Left<'_>) -> Vec<Off> {
    let Iteration { query, cloud, settings, u, .. } = iteration;
    let &[inverse_radius2, normalization, stiffness, rest] = *settings else { return vec![] };
    let (density, bound) = fluid::density(query.position, cloud, [inverse_radius2, normalization], *u);
    let pressure = stiffness * (density - rest);
    let pressure_bound = stiffness * (bound + 3.0 * u * (density + rest));
    vec![
        Off { output: "density", error: (left.number("density") - density).abs(), bound },
        Off { output: "pressure", error: (left.number("pressure") - pressure).abs(), bound: pressure_bound },
    ]
}

fn forces(iteration: &Iteration<'_>, left: &Left<'_>) -> Vec<Off> {
    let Ok(settings) = iteration.settings.try_into() else { return vec![] };
    let (acceleration, bound) = fluid::forces(&iteration.query, &iteration.cloud, settings, iteration.u);
    vec![Off { output: "acceleration", error: left.vector("acceleration").distance(acceleration), bound }]
}
