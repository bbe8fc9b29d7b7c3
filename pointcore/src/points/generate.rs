//! From a configuration to the point processor's Verilog.

use crate::generated::GenerateError;
use pointcore_contract::points::Config;
use pointcore_golden::points::Latencies;
use pointcore_golden::process::{self, KernelPipelines, Pipeline};
use pointcore_golden::search;
use pointcore_hdl::compiler::{Manifest, Options};
use pointcore_hdl::points::top;
use rtl::{Design, elaborate};
use std::collections::BTreeMap;

/// A generated core.
pub struct PointsCore {
    /// Verilog and ports.
    pub design: Design,
    /// What the compiler decided, by unit of the search and by block of the program.
    pub manifests: BTreeMap<String, Manifest>,
}

impl PointsCore {
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
        let optional = |unit: &str| self.manifests.get(unit).map(|manifest| manifest.latency);
        let pipeline = |unit: &str| {
            let manifest = &self.manifests[unit];
            Pipeline { latency: manifest.latency, interval: manifest.initiation_interval }
        };
        let neighbor_cache = optional("check").zip(optional("cover"));
        Latencies {
            search: search::Latencies {
                path: latency("traversal"),
                distance: latency("leaf"),
                neighbor_cache: neighbor_cache.map(|(check, cover)| search::CacheLatencies { check, cover }),
            },
            blocks: process::Latencies { init: optional("init"), finish: latency("final") },
            kernel: KernelPipelines { kernel: pipeline("kernel"), sums: pipeline("sums") },
        }
    }
}
