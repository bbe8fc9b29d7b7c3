//! The soak: random configurations of both cores under random stimuli, each beside its model, every output compared in
//! every cycle.

pub mod bound;
pub mod campaign;
pub mod case;
pub mod configuration;
pub mod device;
pub mod frames;
pub mod pace;
pub mod record;
pub mod renderer;
pub mod searcher;
pub mod surroundings;
pub mod trees;
