//! The search core: its configuration, the records that flow between its units and the units' ports.

pub mod config;
mod lists;
pub mod ports;
pub mod records;
pub mod units;

pub use config::{Config, ConfigError};
