//! Densities and forces of a fluid's particles, against f64 and against what is known of a lattice.

use super::surfaces::{Place, Shape, places};
use super::{Encoded as _, FORMATS, Format, Operator, Point, random, rounded, unit};
use glam::DVec3;
use pointcore_golden::reference::operators::fluid as reference;
use std::f64::consts::PI;

const STIFFNESS: f64 = 3.0;
const REST_DENSITY: f64 = 1000.0;

fn density_operator(format: Format, radius: f64) -> Operator {
    let normalization = 315.0 / (64.0 * PI * radius.powi(3));
    Operator::new("sph_density", format, &[1.0 / (radius * radius), normalization, STIFFNESS, REST_DENSITY])
}

fn forces_operator(format: Format, radius: f64) -> Operator {
    let normalization = 45.0 / (PI * radius.powi(6));
    Operator::new("sph_forces", format, &[radius, normalization, 0.3, 0.0, 0.0, -9.8125])
}

#[test]
fn densities_are_those_of_f64() {
    let mut random = random();
    for format in FORMATS {
        let u = unit(format);
        for place in places() {
            let operator = density_operator(format, place.size * place.scale);
            for _ in 0..20 {
                let (query, mut cloud) = Shape::Noise.neighborhood(&mut random, format, place);
                cloud.iter_mut().enumerate().for_each(|(i, point)| point.attributes = vec![[0.5, 1.0, 1.5][i % 3]]);
                let settings = [operator.setting(0), operator.setting(1)];
                let (density, bound) = reference::density(query.position, &cloud, settings, u);
                let outputs = operator.run(&query, &cloud, 1);
                let off = (outputs.number("density") - density).abs();
                assert!(off <= bound, "{place:?} in {format}: {density} is off by {off}, not {bound}");
                let pressure = STIFFNESS * (density - REST_DENSITY);
                let off = (outputs.number("pressure") - pressure).abs();
                let bound = STIFFNESS * (bound + 3.0 * u * (density + REST_DENSITY));
                assert!(off <= bound, "{place:?} in {format}: {pressure} is off by {off}, not {bound}");
            }
        }
    }
}

/// A lattice of particles, `neighbors` of them along an edge around one in the middle.
fn lattice(spacing: f64, attributes: &[f64]) -> Vec<Point> {
    let mut cloud = vec![];
    for (i, j, k) in (-3..=3).flat_map(|i| (-3..=3).flat_map(move |j| (-3..=3).map(move |k| (i, j, k)))) {
        let position = DVec3::new(i.into(), j.into(), k.into()) * spacing;
        cloud.push(Point { position: rounded(Format::F32, position), attributes: attributes.to_vec() });
    }
    cloud
}

/// The kernel's integral is 1: a lattice with a particle of mass ρ s³ in each cell has the density ρ, up to what so few
/// cells make of an integral.
#[test]
fn a_lattice_has_its_density() {
    let (spacing, radius) = (0.25, 0.7);
    let cloud = lattice(spacing, &[REST_DENSITY * spacing * spacing * spacing]);
    let query = Point { position: DVec3::ZERO, attributes: vec![] };
    let density = density_operator(Format::F32, radius).run(&query, &cloud, 1).number("density");
    assert!((density / REST_DENSITY - 1.0).abs() < 0.02, "{density}");
}

#[test]
fn forces_are_those_of_f64() {
    let mut random = random();
    for format in FORMATS {
        for place in places().into_iter().chain([Place { points: 40, size: 0.3, scale: 2.0, origin: DVec3::ONE }]) {
            let operator = forces_operator(format, place.size * place.scale);
            for _ in 0..20 {
                let (query, cloud) = Shape::Noise.neighborhood(&mut random, format, place);
                let mut particle = |position: DVec3, mass: &[f64]| {
                    let velocity = [(); 3].map(|()| random.f64() - 0.5);
                    let own = [REST_DENSITY * (0.9 + 0.2 * random.f64()), 100.0 * (random.f64() - 0.2)];
                    Point { position, attributes: [&velocity[..], &own[..], mass].concat() }.rounded(format)
                };
                let query = particle(query.position, &[]);
                let mut cloud: Vec<Point> = cloud.iter().map(|point| particle(point.position, &[1.5])).collect();
                // Among its neighbors is the query itself.
                cloud.push(particle(query.position, &[1.5]));
                let settings = std::array::from_fn(|index| operator.setting(index));
                let (acceleration, bound) = reference::forces(&query, &cloud, &settings, unit(format));
                let found = operator.run(&query, &cloud, 1).vector("acceleration");
                let off = found.distance(acceleration);
                assert!(off <= bound, "{place:?} in {format}: {found} is off by {off}, not {bound}");
            }
        }
    }
}

/// In a lattice whose pressure falls along x, particles are pushed along x, by what −∇p/ρ is up to what so few cells
/// make of an integral.
#[test]
fn pressure_pushes_down_its_gradient() {
    let (spacing, radius, slope) = (0.25, 0.7, -40.0);
    let mut cloud = lattice(spacing, &[0.0, 0.0, 0.0, REST_DENSITY, 0.0, REST_DENSITY * spacing.powi(3)]);
    cloud.iter_mut().for_each(|point| point.attributes[4] = 200.0 + slope * point.position.x);
    let query = Point { position: DVec3::ZERO, attributes: vec![0.0, 0.0, 0.0, REST_DENSITY, 200.0] };
    let found = forces_operator(Format::F32, radius).run(&query, &cloud, 1).vector("acceleration");
    let expected = -slope / REST_DENSITY;
    // Half of the gradient: Müller's mean of pressures has the query's own in it, whose part cancels.
    assert!((found.x - 0.5 * expected).abs() < 0.1 * expected, "{found}, not {expected}");
    assert!(found.y.abs() < 1e-3 && (found.z + 9.8125).abs() < 1e-3, "{found}");
}
