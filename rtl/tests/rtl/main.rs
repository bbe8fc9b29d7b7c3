//! The hardware front end: faults, text, and what the tools make of it.

mod blocks;
mod expressions;
mod faults;
mod lint;
mod text;
mod tools;
