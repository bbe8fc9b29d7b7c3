//! The hardware front end: faults, text, and what the tools make of it and of a core.

mod bus;
mod core_b;
mod expressions;
mod faults;
mod text;
mod tools;
