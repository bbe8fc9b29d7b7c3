//! A dam that breaks: the example's water, on the point processor and on the processor of this machine.

#[path = "../../../../examples/dam_break/water.rs"]
mod water;

use super::{FORMAT, cpu, own_timings};
use crate::note;
use crate::{Figures, LabError};
use fastrand::Rng;
use glam::DVec3;
use pointcore::area::recorded::Clock;
use pointcore::process::{Cloud, Interpreted, Operation, Simulation, Timed};
use pointcore::search::SearchEngine;
use std::collections::BTreeMap;
use water::Water;

/// Steps of the run.
const STEPS: usize = 200;
/// Steps from one that is timed to the next; the interpreter carries out those between.
const TIMED: usize = 10;

/// How far particles are off their grid at most, in meters: no two neighbors are equally far.
const OFF_GRID: f64 = 1e-3;

/// The column of water, not quite at rest.
pub(super) fn particles() -> Result<Cloud, LabError> {
    let Water { mut places, .. } = Water::column();
    let mut random = Rng::with_seed(1);
    for place in &mut places {
        *place += OFF_GRID * DVec3::from_array(std::array::from_fn(|_| random.f64()));
    }
    Ok(Cloud::of(FORMAT, "the water".to_owned(), places, BTreeMap::new())?)
}

/// Steps of the fluid, both programs each.
pub(super) fn figures(clock: &Clock, figures: &mut Figures) -> Result<(), LabError> {
    let operation = Operation::named("sph")?;
    let mut water = Water::column();
    let golden = Timed::new(Simulation::of(SearchEngine::Golden));
    let (mut cycles, mut seconds, mut timed, mut busy) = (0, 0.0, 0, 0);
    for step in 0..STEPS {
        let forces = if step % TIMED == 0 {
            note!("the dam, step {step} of {STEPS}");
            let forces = water.forces(&operation, &golden)?;
            timed += 1;
            for timing in own_timings(&forces) {
                cycles += timing.cycles;
                busy += timing.neighbors;
            }
            seconds += forces.stages.iter().map(|stage| cpu::seconds(stage, 1)).sum::<f64>();
            forces
        } else {
            water.forces(&operation, &Interpreted)?
        };
        water.step(&forces).map_err(LabError::Unphysical)?;
    }
    let hardware = cycles as f64 / (clock.mhz * 1e6);
    let mut insert = |key: &str, value: f64| figures.insert(format!("process.dam.{key}"), value.into());
    insert("particles", water.places.len() as f64);
    insert("steps", STEPS as f64);
    insert("steps_timed", f64::from(timed));
    insert("cycles_per_step", cycles as f64 / f64::from(timed));
    insert("kernel_busy", busy as f64 / cycles as f64);
    insert("steps_per_s", f64::from(timed) / hardware);
    insert("cpu_steps_per_s", f64::from(timed) / seconds);
    insert("speedup_cpu", seconds / hardware);
    Ok(())
}
