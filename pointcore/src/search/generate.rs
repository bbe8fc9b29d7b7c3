//! From a configuration to the search core's Verilog.

use crate::generated::GenerateError;
use pointcore_contract::search::Config;
use pointcore_golden::search::{CacheLatencies, Latencies};
use pointcore_hdl::compiler::{Manifest, Options};
use pointcore_hdl::search::top;
use rtl::{Design, elaborate};
use std::collections::BTreeMap;

/// A generated core.
pub struct SearchCore {
    /// Verilog and ports.
    pub design: Design,
    /// What the compiler decided, by unit.
    pub manifests: BTreeMap<String, Manifest>,
}

impl SearchCore {
    /// Generates the core.
    ///
    /// # Errors
    /// A fault of the generator.
    pub fn generate(config: &Config) -> Result<Self, GenerateError> {
        let top::Core { module, manifests } = top::core(config, &Options::default())?;
        Ok(Self { design: elaborate(&module)?, manifests })
    }

    /// The latencies a golden model needs to keep step.
    #[must_use]
    pub fn latencies(&self) -> Latencies {
        let latency = |unit: &str| self.manifests[unit].latency;
        let neighbor_cache = self
            .manifests
            .contains_key("check")
            .then(|| CacheLatencies { check: latency("check"), cover: latency("cover") });
        Latencies { path: latency("traversal"), distance: latency("leaf"), neighbor_cache }
    }
}
