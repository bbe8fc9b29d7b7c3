//! How the cores meet a bus (`docs/interfaces.md`): widths, byte layouts, register maps, ports of units and tops.

pub mod axi;
mod channel;
pub mod config;
pub mod layout;
pub mod packets;
pub mod registers;
pub mod units;

pub use axi::Bus;
pub use channel::{ChannelIn, ChannelOut, VALID};
pub use config::{Config, ConfigError};
pub use layout::{Layout, Place};
pub use registers::{Access, Register, RegisterKind, When};
