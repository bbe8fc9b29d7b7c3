//! The search core: its configuration, the records that flow between its units and the units' ports.

pub mod config;
pub mod records;
pub mod units;

pub use config::{Config, ConfigError};
