//! A dam breaks: 4,096 particles of water, their densities and forces by the programs `sph_density` and `sph_forces`;
//! the host moves them and keeps them in their basin.
//!
//! ```sh
//! cargo run --release -p pointcore --example dam_break -- out/dam      # every 20 of 200 steps
//! target/release/pointcore run out/dam/drops_200.csv --model golden    # a picture of one
//! ```
//!
//! `step_….ply` holds the particles with what the programs say of them, `drops_….csv` a ball for each, bluer where it is slow.

mod drops;
mod water;

use pointcore::process::{Interpreted, Operation, ply};
use std::error::Error;
use std::path::PathBuf;
use water::Water;

const STEPS: usize = 200;
/// Steps from one file to the next.
const SHOWN: usize = 20;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "out/dam".to_owned()));
    std::fs::create_dir_all(&folder)?;
    let operation = Operation::named("sph")?;
    let mut water = Water::column();
    println!("step, front in m, height in m, fastest in m/s, mean density");
    for step in 0..=STEPS {
        let forces = water.forces(&operation, &Interpreted)?;
        if step % SHOWN == 0 {
            let most = |of: &dyn Fn(usize) -> f64| (0..water.places.len()).map(of).fold(0.0, f64::max);
            let (front, height) = (most(&|index| water.places[index].x), most(&|index| water.places[index].z));
            let fastest = most(&|index| water.velocities[index].length());
            let densities = &forces.stages[0].answers;
            let density = |bits: u32| f64::from(f32::from_bits(bits));
            let mean = densities.iter().map(|answer| density(answer.outputs[0])).sum::<f64>() / densities.len() as f64;
            println!("{step}, {front:.3}, {height:.3}, {fastest:.3}, {mean:.1}");
            std::fs::write(folder.join(format!("step_{step:03}.ply")), ply(&forces)?)?;
            std::fs::write(folder.join(format!("drops_{step:03}.csv")), drops::csv(&water))?;
        }
        water.step(&forces)?;
    }
    Ok(())
}
