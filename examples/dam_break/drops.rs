//! Particles as balls of points, for pictures.

use super::water::{SPACING, Water};
use glam::DVec3;
use std::fmt::Write as _;

/// Points of a ball.
const POINTS: usize = 40;
/// Its radius, of the distance between particles at rest.
const RADIUS: f64 = 0.45;
/// The speed of what is white, in m/s.
const FASTEST: f64 = 2.0;
/// Red, green and blue of water at rest, and as fast as that.
const COLORS: [DVec3; 2] = [DVec3::new(18.0, 66.0, 150.0), DVec3::new(225.0, 243.0, 255.0)];

/// Points on the sphere, in a spiral from pole to pole.
fn directions() -> [DVec3; POINTS] {
    let golden_angle = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    std::array::from_fn(|index| {
        let z = 1.0 - 2.0 * (index as f64 + 0.5) / POINTS as f64;
        let (sine, cosine) = (golden_angle * index as f64).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        DVec3::new(radius * cosine, radius * sine, z)
    })
}

/// A table of points with normals and colors.
pub fn csv(water: &Water) -> String {
    let mut text = "x,y,z,nx,ny,nz,red,green,blue\n".to_owned();
    let directions = directions();
    for (place, velocity) in water.places.iter().zip(&water.velocities) {
        let [slow, fast] = COLORS;
        let color = slow.lerp(fast, (velocity.length() / FASTEST).min(1.0));
        for normal in directions {
            let vectors = [*place + RADIUS * SPACING * normal, normal, color];
            let numbers = vectors.iter().flat_map(DVec3::to_array).map(|number| format!("{number:.5}"));
            _ = writeln!(text, "{}", numbers.collect::<Vec<_>>().join(","));
        }
    }
    text
}
