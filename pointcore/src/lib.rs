//! Hardware for point-based graphics, from a scene or a point set to Verilog, and from Verilog to results.
//!
//! - What is drawn or searched: [`scene`], [`search::PointSet`]; what is read of it: [`inspect`], [`picture`], [`shading`], [`color`].
//! - What is drawn beside splats by others: [`triangles`].
//! - Which hardware that calls for: [`plan`], [`cost`], [`area`]; as files, [`configuration`].
//! - The renderer and the search core, generated, with the hosts around them, on hardware, on the model, or on both: [`splat`], [`search`],
//!   and what both go through, [`generated`]. The words they take and give: [`number`], [`uniforms`].
//! - What lies behind their ports: [`memory`].
//! - Operators on neighborhoods, over whole point sets: [`process`].
//! - The operators that cores compute with, each with its model: [`operators`].
//! - What others build with: [`package`] and the [`recording`] in its test, [`bus`], [`vectors`].
//! - Surroundings of whole cores in which anything may happen: [`stimuli`].

pub mod area;
pub mod bus;
pub mod color;
pub mod configuration;
pub mod cost;
pub mod exposure;
pub mod generated;
pub mod inspect;
pub mod memory;
pub mod number;
pub mod operators;
pub mod package;
pub mod page;
pub mod picture;
pub mod plan;
pub mod points;
pub mod process;
pub mod recording;
pub mod scene;
pub mod search;
pub mod shading;
pub mod splat;
pub mod stimuli;
pub mod tally;
pub mod triangles;
pub mod uniforms;
pub mod vectors;
pub mod waveform;
pub mod wording;
