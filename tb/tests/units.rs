//! Hardware against golden models, one module a unit.
mod harness;
