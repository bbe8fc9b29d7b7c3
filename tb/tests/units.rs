//! Hardware against golden models, one module a unit.
mod compiler;
mod float;
mod harness;
