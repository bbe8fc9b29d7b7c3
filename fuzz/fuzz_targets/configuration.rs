//! Any text as a configuration of either core is one or an error, never a panic; a valid one reads back the same.
#![no_main]

use libfuzzer_sys::fuzz_target;
use pointcore_contract::{search, splat};

fuzz_target!(|text: &str| {
    if let Ok(config) = toml::from_str::<splat::Config>(text)
        && config.validate().is_ok()
    {
        let written = toml::to_string(&config).expect("a configuration is a TOML table");
        assert_eq!(toml::from_str(&written), Ok(config));
    }
    if let Ok(config) = toml::from_str::<search::Config>(text)
        && config.validate().is_ok()
    {
        let written = toml::to_string(&config).expect("a configuration is a TOML table");
        assert_eq!(toml::from_str(&written), Ok(config));
    }
});
