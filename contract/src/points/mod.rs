//! The point processor: the neighbor search and the process core behind it (thesis figure 6.4).

mod config;
mod file;
pub mod units;

pub use config::{Config, ConfigError};
