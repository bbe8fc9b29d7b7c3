//! Random configurations of both cores, and random surroundings of whole cores: hosts that ask for anything, memories
//! that answer late, streams that are held back, resets in between. Everything follows from a seed.
//!
//! The soak runs cores in them beside their models; the recordings that go with generated Verilog are made in them.

pub mod configuration;
pub mod frames;
pub mod motion;
pub mod operands;
pub mod pace;
pub mod renderer;
pub mod searcher;
pub mod surroundings;
pub mod trees;

use fastrand::Rng;

/// One of some values.
fn one_of<T: Copy>(random: &mut Rng, values: &[T]) -> T {
    values[random.usize(..values.len())]
}
