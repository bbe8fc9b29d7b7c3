//! Bit-exact, cycle-accurate models of the hardware, and the f64 reference they are judged by.

pub mod bus;
pub mod datapath;
pub mod float;
pub mod number;
pub mod points;
pub mod process;
pub mod reference;
pub mod search;
pub mod splat;
pub mod stream;
#[cfg(test)]
mod testing;
pub mod unit;
