//! Generators, hosts and drivers of both cores, from a scene or a point set to hardware and results.

pub mod area;
pub mod bus;
pub mod color;
pub mod configuration;
pub mod cost;
pub mod generated;
pub mod inspect;
pub mod number;
pub mod package;
pub mod picture;
pub mod plan;
pub mod recording;
pub mod scene;
pub mod search;
pub mod shading;
pub mod splat;
pub mod uniforms;
pub mod vectors;
