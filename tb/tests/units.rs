//! Hardware against golden models, one module a unit.
mod float;
mod harness;
