//! Co-simulation of the generated hardware with its models, and the `pointcore` command.

pub mod accuracy;
pub mod bus;
pub mod cache;
pub mod configuration;
pub mod core_a;
pub mod core_b;
pub mod driver;
pub mod float_check;
pub mod generated;
pub mod inspect;
pub mod lockstep;
pub mod number;
pub mod package;
pub mod picture;
pub mod plan;
pub mod plot;
pub mod scene;
pub mod shading;
pub mod stability;
pub mod synthesis;
pub mod toolchain;
pub mod vectors;
pub mod verilated;
