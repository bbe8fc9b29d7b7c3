//! The soak: random configurations of both cores under random stimuli, each beside its model, every output compared in
//! every cycle.

pub mod bound;
pub mod campaign;
pub mod case;
pub mod device;
pub mod extent;
pub mod record;
