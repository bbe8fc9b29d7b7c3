//! A fluid's density, and the acceleration of its particles (Müller et al. 2003).

use super::Point;
use super::weights::falloff;
use glam::DVec3;

/// The density around a query, and by what it may be off; neighbors have their mass. Settings: `1/h²`, the
/// normalization.
#[must_use]
pub fn density(query: DVec3, cloud: &[Point], [inverse_radius2, normalization]: [f64; 2], u: f64) -> (f64, f64) {
    let (mut mass, mut error) = (0.0, 0.0);
    for point in cloud {
        let f = falloff(point.position.distance_squared(query), inverse_radius2);
        mass += point.attributes[0] * f.powi(3);
        // f is off by 8u: f³ by 3 f² · 8u, and by three roundings.
        error += point.attributes[0] * u * (24.0 * f.powi(2) + 3.0 * f.powi(3));
    }
    let density = mass * normalization;
    let sum = (cloud.len() / 8 + 5) as f64;
    (density, error * normalization + sum * u * density)
}

/// The acceleration of a particle, and by what it may be off. Query: velocity, density, pressure. Neighbor: velocity, density, pressure, mass. Settings: radius,
/// normalization, viscosity, gravity.
#[must_use]
pub fn forces(query: &Point, cloud: &[Point], settings: &[f64; 6], u: f64) -> (DVec3, f64) {
    let [radius, normalization, viscosity, gravity @ ..] = *settings;
    let roundings = (cloud.len() / 8 + 4) as f64 + 16.0;
    let (mut force, mut error) = (DVec3::ZERO, 0.0);
    let (density, pressure) = (query.attributes[3], query.attributes[4]);
    for point in cloud {
        let to_neighbor = point.position - query.position;
        let distance = to_neighbor.length();
        let reach = (radius - distance).max(0.0);
        let volume = point.attributes[5] / point.attributes[3];
        let mean_pressure = 0.5 * (pressure + point.attributes[4]);
        let drag = DVec3::from_slice(&point.attributes) - DVec3::from_slice(&query.attributes);
        let push = volume * reach * mean_pressure;
        let viscous = viscosity * volume * drag;
        if distance > 0.0 {
            force -= push * reach * to_neighbor / distance;
        }
        force += viscous * reach;
        // Of the reach, six roundings of the distance and one of the difference, twice in its square; of pressures that
        // cancel, one of each; of all factors, their own.
        let of_reach = u * (7.0 * distance + radius);
        let of_pressure = u * volume * reach * reach * (pressure.abs() + point.attributes[4].abs());
        error += 2.0 * push.abs() * of_reach + of_pressure + viscous.length() * of_reach;
        let velocities = DVec3::from_slice(&point.attributes).length() + DVec3::from_slice(&query.attributes).length();
        error += u * roundings * (push.abs() * reach + viscosity * volume * velocities * reach);
    }
    let gravity = DVec3::from_array(gravity);
    let factor = normalization / density;
    let acceleration = force * factor + gravity;
    (acceleration, error * factor.abs() * 2.0 + 4.0 * u * (force.length() * factor + gravity.length()))
}
