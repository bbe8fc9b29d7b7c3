//! Where randomness comes from: one fixed seed, or the one in the environment.

use super::LockstepError;

/// The environment variable that replaces the fixed seeds.
pub const SEED_VARIABLE: &str = "POINTCORE_SEED";

/// The seed of a run unless the environment names another.
const DEFAULT_SEED: u64 = 1;

/// The seed in the environment, decimal or `0x…`, or the fixed one.
///
/// # Errors
/// When the variable is set to something else than a number.
pub fn seed() -> Result<u64, LockstepError> {
    Ok(from_environment()?.unwrap_or(DEFAULT_SEED))
}

/// `count` fixed seeds, or only the one in the environment, so that a printed seed reproduces its run alone.
///
/// # Errors
/// When the variable is set to something else than a number.
pub fn seeds(count: u64) -> Result<Vec<u64>, LockstepError> {
    Ok(from_environment()?.map_or_else(|| (DEFAULT_SEED..DEFAULT_SEED + count).collect(), |seed| vec![seed]))
}

fn from_environment() -> Result<Option<u64>, LockstepError> {
    std::env::var(SEED_VARIABLE).ok().map(|text| parse(&text).ok_or(LockstepError::Seed { text })).transpose()
}

fn parse(text: &str) -> Option<u64> {
    match text.strip_prefix("0x") {
        Some(digits) => u64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_are_decimal_or_hexadecimal() {
        assert_eq!(parse("17"), Some(17));
        assert_eq!(parse("0xff"), Some(255));
        assert_eq!(parse("many"), None);
    }
}
