//! The point processor: search and process core.

pub mod top;

#[cfg(test)]
mod tests {
    use super::top;
    use crate::compiler::Options;
    use crate::units::testing::check;
    use pointcore_contract::points::{Config, units};
    use pointcore_contract::process::library::program;
    use pointcore_contract::{process, search};
    use std::sync::Arc;

    #[test]
    fn the_top_has_the_specified_ports() {
        for (tree_cache, neighbor_cache) in [(0, 4), (32, 0)] {
            let search = search::Config { tree_cache, neighbor_cache, ..search::Config::default() };
            let process = process::Config {
                program: Arc::new(program("mls")),
                format: search.geometry,
                index_bits: search.index_bits,
                neighbors: search.neighbors,
                threads: 32,
                rate: 1,
                line_points: 4,
                cache_lines: 64,
            };
            let config = Config { search, process };
            assert_eq!(config.validate(), Ok(()));
            let module = top::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}")).module;
            assert_eq!(module.unit(), units::top::UNIT.module);
            check(&module, units::top::UNIT.ports(&config));
        }
    }
}
