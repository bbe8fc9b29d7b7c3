//! What a neighbor cache may answer: the arguments that searches share.

use super::{Failure, numbers};
use pointcore::search::Reuse;

/// Neighborhoods of the thesis' neighbor cache.
const CACHE_ENTRIES: u32 = 8;

/// Arguments of the neighbor cache.
#[derive(clap::Args)]
pub struct ReuseArguments {
    /// Neighborhoods that a coherent neighbor cache holds, up to 32; 0 leaves it out. By default 8 with --epsilon or --alpha, else 0.
    #[arg(long, value_name = "COUNT", conflicts_with = "config", value_parser = numbers::within(0_u32..=32, "0 to 32 neighborhoods"))]
    cache: Option<u32>,
    /// How much farther than the true ones neighbors from the neighbor cache may be, as a share; by default not at all.
    #[arg(long, value_name = "SHARE", value_parser = numbers::within(Reuse::EPSILON, "0 to 10"))]
    epsilon: Option<f32>,
    /// The factor by which balls are searched larger for the neighbor cache; by default 1.25.
    #[arg(long, value_name = "FACTOR", value_parser = numbers::within(Reuse::ALPHA, "1 to 10"))]
    alpha: Option<f32>,
}

impl ReuseArguments {
    /// Checks what goes together.
    pub fn check(&self) -> Result<(), Failure> {
        if self.cache == Some(0) && self.is_wanted() {
            return Err(Failure::Usage(
                "--cache 0: --epsilon and --alpha go with a neighbor cache of 1 to 32 neighborhoods".to_owned(),
            ));
        }
        Ok(self.factors().validate()?)
    }

    /// Checks that hardware of so many neighborhoods, that of `file`, heeds what is said.
    pub fn check_hardware(&self, neighborhoods: u32, file: &std::path::Path) -> Result<(), Failure> {
        if neighborhoods == 0 && self.is_wanted() {
            let message = "--epsilon and --alpha go with a neighbor cache: set `neighbor_cache` in";
            return Err(Failure::Usage(format!("{message} {}", file.display())));
        }
        Ok(())
    }

    /// What the neighbor cache may answer.
    pub fn factors(&self) -> Reuse {
        let Reuse { epsilon, alpha } = Reuse::default();
        Reuse { epsilon: self.epsilon.unwrap_or(epsilon), alpha: self.alpha.unwrap_or(alpha) }
    }

    /// Whether something is said that only a neighbor cache heeds.
    pub const fn is_wanted(&self) -> bool {
        self.epsilon.is_some() || self.alpha.is_some()
    }

    /// Whether anything is said of a neighbor cache.
    pub const fn is_said(&self) -> bool {
        self.cache.is_some() || self.is_wanted()
    }

    /// Neighborhoods in the neighbor cache, where no configuration says.
    pub fn neighborhoods(&self) -> u32 {
        self.cache.unwrap_or(if self.is_wanted() { CACHE_ENTRIES } else { 0 })
    }
}
