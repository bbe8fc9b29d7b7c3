//! A column of water in a basin, and how it moves.

use glam::DVec3;
use pointcore::process::{Cloud, Engine, Operation, Process, ProcessError, Processed, Queries, process};
use pointcore_contract::Format;
use std::collections::BTreeMap;

/// Particles along an edge of the column.
const EDGE: usize = 16;
/// Distance between particles at rest, in meters.
pub const SPACING: f64 = 0.02;
/// Reach of the kernels; some 30 particles are within it.
const RADIUS: f64 = 1.9 * SPACING;
/// Neighbors of a particle at most, as in the thesis.
const NEIGHBORS: u32 = 30;
const STEP_SECONDS: f64 = 1e-3;
/// The basin, from the corner in which the column stands.
const BASIN: DVec3 = DVec3::new(0.96, 0.32, 0.64);
const REST_DENSITY: f64 = 1000.0;
/// Square of the speed of sound, which is some times that of the fall.
const STIFFNESS: f64 = 60.0;
const VISCOSITY: f64 = 12.0;
/// Share of its speed that a particle keeps when it hits a wall.
const BOUNCE: f64 = 0.1;

/// The water.
pub struct Water {
    /// Its particles.
    pub places: Vec<DVec3>,
    /// Their velocities, in m/s.
    pub velocities: Vec<DVec3>,
}

impl Water {
    /// The column, at rest.
    pub fn column() -> Self {
        let place = |index: usize| {
            let cell = DVec3::new((index % EDGE) as f64, (index / EDGE % EDGE) as f64, (index / EDGE / EDGE) as f64);
            (cell + 0.5) * SPACING
        };
        let count = EDGE * EDGE * EDGE;
        Self { places: (0..count).map(place).collect(), velocities: vec![DVec3::ZERO; count] }
    }

    /// Densities, pressures and accelerations, by the two programs.
    ///
    /// # Errors
    /// What the engine finds.
    pub fn forces(&self, operation: &Operation, engine: &dyn Engine) -> Result<Processed, ProcessError> {
        let settings = [("stiffness", STIFFNESS), ("viscosity", VISCOSITY), ("rest_density", REST_DENSITY)];
        let settings = settings.map(|(name, value)| (name.to_owned(), vec![value])).into();
        let component = |axis: usize| self.velocities.iter().map(|velocity| velocity[axis]).collect();
        let columns = [("vx", 0), ("vy", 1), ("vz", 2)].map(|(name, axis)| (name.to_owned(), component(axis)));
        let cloud = Cloud::of(Format::F32.flushed(), "the water".to_owned(), self.places.clone(), columns.into())?;
        let mass = REST_DENSITY * SPACING * SPACING * SPACING;
        let attributes = BTreeMap::from([("mass".to_owned(), vec![mass])]);
        let asked = Process {
            operation,
            k: NEIGHBORS,
            radius: Some(RADIUS),
            iterations: 1,
            passes: 1,
            settings: &settings,
            attributes: &attributes,
        };
        process(&cloud, &Queries::Points((0..cloud.len()).collect()), &asked, engine, &|_| ())
    }

    /// Moves particles, velocities first.
    ///
    /// # Errors
    /// An acceleration that is none.
    pub fn step(&mut self, forces: &Processed) -> Result<(), String> {
        let accelerations = forces.column("acceleration").ok_or("`sph` has no output `acceleration`")?;
        for (index, (place, velocity)) in self.places.iter_mut().zip(&mut self.velocities).enumerate() {
            let acceleration = DVec3::from_array([0, 1, 2].map(|axis| accelerations.numbers[axis].number(index)));
            if !acceleration.is_finite() {
                return Err(format!("particle {index} at {place}: its acceleration is {acceleration}"));
            }
            *velocity += STEP_SECONDS * acceleration;
            *place += STEP_SECONDS * *velocity;
            for axis in 0..3 {
                let inside = place[axis].clamp(0.0, BASIN[axis]);
                if place[axis] != inside {
                    place[axis] = inside;
                    velocity[axis] *= -BOUNCE;
                }
            }
        }
        Ok(())
    }
}
