//! The search core, the point-set processor: its configuration, the records that flow between its units and their ports.

pub mod config;
pub mod ports;
pub mod records;

pub use config::{Config, ConfigError};
