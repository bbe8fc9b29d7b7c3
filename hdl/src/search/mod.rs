//! The search core: nearest neighbors in a kd-tree. `docs/search.md` and its pages state what every unit does in every cycle;
//! each file names the thesis section it implements.

pub mod leaf;
pub mod neighbor_cache;
pub mod point_cache;
pub mod queue;
pub mod recursion;
pub mod sieve;
pub mod stack;
pub mod threads;
pub mod top;
pub mod traversal;
pub mod tree_cache;

mod parts;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiler::Options;
    use crate::units::testing::{check, check_in_order};
    use pointcore_contract::Format;
    use pointcore_contract::search::{Config, ports};

    fn configs() -> [Config; 8] {
        let small =
            Config { threads: 1, neighbors: 1, tree_depth: 1, leaves_in_flight: 1, bucket: 1, ..Config::default() };
        let wide = Config { threads: 3, lanes: 4, index_bits: 4, geometry: Format::F24.flushed(), ..Config::default() };
        let bare = Config { point_cache: 0, ..small.clone() };
        let external = Config { tree_cache: 16, point_cache: 2, neighbor_cache: 3, ..wide.clone() };
        let single = Config { neighbor_cache: 1, ..small.clone() };
        let coherent = Config { neighbor_cache: 8, ..Config::default() };
        // More lines than records, more slots than leaves.
        let roomy = Config { tree_cache: 64, point_cache: 256, ..small.clone() };
        let no_points = Config { point_cache: 0, tree_cache: 4096, ..Config::default() };
        [Config::default(), no_points, wide, bare, external, roomy, single, coherent]
    }

    #[test]
    fn units_have_the_specified_ports() {
        let options = Options::default();
        for config in configs() {
            check(&threads::module(&config), ports::threads(&config));
            check(&stack::module(&config), ports::stack(&config));
            check(&recursion::module(&config), ports::recursion(&config));
            check(&sieve::module(&config), ports::sieve(&config));
            check(&queue::module(&config), ports::queue(&config));
            if config.point_cache > 0 {
                check(&point_cache::module(&config), ports::point_cache(&config));
            }
            if config.tree_cache > 0 {
                check(&tree_cache::module(&config), ports::tree_cache(&config));
            }
            if config.neighbor_cache > 0 {
                let unit = neighbor_cache::unit(&config, &options).unwrap_or_else(|error| panic!("{error}"));
                check(&unit.module, ports::neighbor_cache(&config));
            }
            for (datapath, ports) in [
                (traversal::datapath(&config, &options), ports::traversal(&config)),
                (leaf::datapath(&config, &options), ports::leaf(&config)),
            ] {
                check(&datapath.unwrap_or_else(|error| panic!("{error}")).module, ports);
            }
        }
    }

    #[test]
    fn the_core_has_the_specified_ports_in_order() {
        for config in configs() {
            let core = top::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
            check_in_order(&core.module, &ports::top(&config));
        }
    }
}
