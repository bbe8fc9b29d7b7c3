//! From a configuration to the renderer's Verilog.

use crate::generated::GenerateError;
use pointcore_contract::splat::Config;
use pointcore_golden::splat::Latencies;
use pointcore_hdl::compiler::{Manifest, Options};
use pointcore_hdl::splat::top;
use rtl::{Design, elaborate};
use std::collections::BTreeMap;

/// A generated core.
pub struct SplatCore {
    /// Verilog and ports.
    pub design: Design,
    /// What the compiler decided, by unit.
    pub manifests: BTreeMap<String, Manifest>,
}

impl SplatCore {
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
        Latencies {
            transform: latency("transform"),
            setup: latency("setup"),
            rasterizer: latency("rasterizer"),
            weighting: latency("weighting"),
            normalizer: latency("normalizer"),
        }
    }
}
