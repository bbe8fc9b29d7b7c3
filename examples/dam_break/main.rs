//! A dam breaks: 4,096 particles of water, their densities and forces by the programs `sph_density` and `sph_forces`;
//! the host moves them and keeps them in their basin.
//!
//! ```sh
//! cargo run --release -p pointcore --example dam_break -- out/dam      # a PLY file every 20 of 200 steps
//! target/release/pointcore run out/dam/step_200.ply --model golden     # a picture of one
//! ```

use glam::DVec3;
use pointcore::process::{Cloud, Interpreted, Operation, Process, ProcessError, Processed, Queries, ply, process};
use pointcore_contract::Format;
use std::collections::BTreeMap;
use std::error::Error;
use std::path::PathBuf;

/// Particles along an edge of the column.
const EDGE: usize = 16;
/// Distance between particles at rest, in meters.
const SPACING: f64 = 0.02;
/// Reach of the kernels; some 30 particles are within it.
const RADIUS: f64 = 1.9 * SPACING;
/// Neighbors of a particle at most, as in the thesis.
const NEIGHBORS: u32 = 30;
const STEPS: usize = 200;
const STEP_SECONDS: f64 = 1e-3;
/// Steps from one file to the next.
const SHOWN: usize = 20;
/// The basin, from the corner in which the column stands.
const BASIN: DVec3 = DVec3::new(0.96, 0.32, 0.64);
const REST_DENSITY: f64 = 1000.0;
/// Square of the speed of sound, which is some times that of the fall.
const STIFFNESS: f64 = 60.0;
const VISCOSITY: f64 = 12.0;
/// Share of its speed that a particle keeps when it hits a wall.
const BOUNCE: f64 = 0.1;

/// The water.
struct Water {
    places: Vec<DVec3>,
    velocities: Vec<DVec3>,
}

impl Water {
    fn column() -> Self {
        let place = |index: usize| {
            let cell = DVec3::new((index % EDGE) as f64, (index / EDGE % EDGE) as f64, (index / EDGE / EDGE) as f64);
            (cell + 0.5) * SPACING
        };
        let count = EDGE * EDGE * EDGE;
        Self { places: (0..count).map(place).collect(), velocities: vec![DVec3::ZERO; count] }
    }

    /// Densities, pressures and accelerations, by the two programs.
    fn forces(&self, operation: &Operation, settings: &BTreeMap<String, Vec<f64>>) -> Result<Processed, ProcessError> {
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
            settings,
            attributes: &attributes,
        };
        process(&cloud, &Queries::Points((0..cloud.len()).collect()), &asked, &Interpreted, &|_| ())
    }

    /// Moves particles, velocities first.
    fn step(&mut self, forces: &Processed) -> Result<(), String> {
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

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "out/dam".to_owned()));
    std::fs::create_dir_all(&folder)?;
    let operation = Operation::named("sph")?;
    let settings = [("stiffness", STIFFNESS), ("viscosity", VISCOSITY), ("rest_density", REST_DENSITY)];
    let settings = settings.map(|(name, value)| (name.to_owned(), vec![value])).into();
    let mut water = Water::column();
    println!("step, front in m, height in m, fastest in m/s, mean density");
    for step in 0..=STEPS {
        let forces = water.forces(&operation, &settings)?;
        if step % SHOWN == 0 {
            let most = |of: &dyn Fn(usize) -> f64| (0..water.places.len()).map(of).fold(0.0, f64::max);
            let (front, height) = (most(&|index| water.places[index].x), most(&|index| water.places[index].z));
            let fastest = most(&|index| water.velocities[index].length());
            let densities = &forces.stages[0].answers;
            let density = |bits: u32| f64::from(f32::from_bits(bits));
            let mean = densities.iter().map(|answer| density(answer.outputs[0])).sum::<f64>() / densities.len() as f64;
            println!("{step}, {front:.3}, {height:.3}, {fastest:.3}, {mean:.1}");
            std::fs::write(folder.join(format!("step_{step:03}.ply")), ply(&forces)?)?;
        }
        water.step(&forces)?;
    }
    Ok(())
}
