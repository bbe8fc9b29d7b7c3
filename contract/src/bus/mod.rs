//! How the cores meet a bus (`docs/interfaces.md`): widths, byte layouts, register maps, ports of units and tops.

mod axi;
pub mod config;
pub mod layout;
mod list;
pub mod packets;
pub mod ports;
pub mod registers;

pub use axi::Bus;
pub use config::{Config, ConfigError};
pub use layout::{Layout, Place};
pub use registers::{Access, Kind, Register, When};
