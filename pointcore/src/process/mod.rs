//! Operators on neighborhoods over point sets (thesis 6.5): a program, its settings and fields by name, and what leaves
//! with each query.
//!
//! [`Operation`] is one program or several after another, [`Cloud`] points with their attributes, [`Process`] the two
//! with what is asked of them. [`process`] carries it out on an [`Engine`]: the golden interpreter, which knows no time, or
//! a point processor with its model.

mod attributes;
pub mod check;
mod cloud;
mod cost;
mod engine;
mod error;
mod files;
mod neighborhoods;
mod operation;
mod outcome;
mod report;
mod run;
mod scale;
mod settings;
mod stage;
#[cfg(test)]
mod tests;
mod timing;
mod words;

pub use cloud::Cloud;
pub use cost::{BlockCost, Cost, Operators, THESIS};
pub use engine::{Answer, Carried, Engine, Interpreted, Job};
pub use error::ProcessError;
pub use files::{csv, npy, ply};
pub use neighborhoods::{NEIGHBORS_LIMIT, Neighborhoods};
pub use operation::Operation;
pub use outcome::{Column, Numbers, Processed, Summary};
pub use report::ProcessReport;
pub use run::{ITERATIONS_LIMIT, Process, Queries, process};
pub use scale::Scale;
pub use settings::Setting;
pub use stage::Stage;
pub use timing::{Simulation, Timed, Timing};
