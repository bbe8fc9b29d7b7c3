//! Hardware against golden models, one module a unit.
mod command;
mod compiler;
mod float;
mod harness;
mod layout;
mod stream_fifo;
mod stream_skid;
mod support;
