//! `Config`: the widths of streams and memory ports.

use crate::configuration::table;

/// Widths that a data bus may have.
pub const WIDTHS: [u32; 5] = [32, 64, 128, 256, 512];
/// Bits of an address on any memory bus.
pub const ADDRESS_BITS: u32 = 32;
/// Bits of a transaction's identifier.
pub const ID_BITS: u32 = 4;
/// Bits of a register's byte address.
pub const REGISTER_ADDRESS_BITS: u32 = 12;
/// Bits of a register.
pub const REGISTER_BITS: u32 = 32;
/// Bits of a word of the tree as the host writes it.
pub const TREE_WORD_BITS: u32 = 64;
/// A burst never crosses a multiple of this many bytes, and base addresses are multiples of it.
pub const BORDER_BYTES: u32 = 4096;
/// Beats that a burst has at most.
pub const BURST_BEATS_MAX: u32 = 256;
/// Bursts that a reader may have under way.
pub const READS_MAX: u32 = 16;
/// Writes that may await their answer.
pub const WRITES_MAX: u32 = 16;

/// What the keys of the table `[bus]` have in common.
pub const ABOUT: &str = " What the core is connected to: widths of the bus around it.";

table! {
    /// The table `[bus]` of a core's configuration.
    #[derive(Copy)]
    pub struct Config {
        /// Bits of a beat of the streams of packets.
        stream_bits: u32 = 64, described("32, 64, 128, 256, 512"), User;
        /// Bits of a beat of the memory ports.
        memory_bits: u32 = 64, described("32, 64, 128, 256, 512"), User;
    }
}

/// A width that no bus has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{key}` = {value}: expected 32, 64, 128, 256 or 512")]
pub struct ConfigError {
    /// The TOML key.
    pub key: &'static str,
    /// Its value.
    pub value: u32,
}

impl Config {
    /// Checks both widths.
    ///
    /// # Errors
    /// The first width that no bus has.
    pub fn validate(&self) -> Result<(), ConfigError> {
        for (key, value) in [("stream_bits", self.stream_bits), ("memory_bits", self.memory_bits)] {
            if !WIDTHS.contains(&value) {
                return Err(ConfigError { key, value });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_name_key_and_widths() {
        assert_eq!(Config::default().validate(), Ok(()));
        let error = Config { memory_bits: 48, ..Config::default() }.validate().unwrap_err();
        assert_eq!(error.to_string(), "`memory_bits` = 48: expected 32, 64, 128, 256 or 512");
        let error = toml::from_str::<Config>("memory = 64").unwrap_err();
        assert!(error.to_string().contains("memory"), "{error}");
    }
}
