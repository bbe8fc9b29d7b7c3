//! Block diagrams of the cores, made from the design itself: the units that a core places, and the records that pass between them.
//!
//! Units stand in the order in which the contract lists them. What goes to the next one goes straight down; what skips some runs along
//! the right, what goes back along the left. Ports of the core itself end in arrows without another unit.

mod edges;
mod picture;

use pointcore_contract::Unit;
use rtl::Module;

use edges::{Edge, edges};

/// A unit in the picture.
struct Node {
    name: &'static str,
    doc: &'static str,
}

/// The diagram of a core, the last of `units`, as SVG. `module` is the core's module in this configuration.
#[must_use]
pub fn diagram<C>(module: &Module, units: &[&Unit<C>], config: &C) -> String {
    let links = module.links();
    let Some((core, parts)) = units.split_last() else { return String::new() };
    let is_placed = |unit: &&&Unit<C>| links.iter().any(|link| link.to.unit.as_deref() == Some(unit.module));
    let placed: Vec<&Unit<C>> = parts.iter().filter(is_placed).copied().collect();
    let nodes: Vec<Node> = placed.iter().map(|unit| Node { name: unit.name(), doc: unit.doc }).collect();
    let edges: Vec<Edge> = edges(&links, core, &placed, config);
    picture::draw(core.doc, &nodes, &edges)
}

#[cfg(test)]
mod tests {
    use super::*;
    use pointcore_contract::search::{self, units::UNITS};
    use pointcore_hdl::compiler::Options;

    #[test]
    fn a_core_shows_its_units_and_what_passes_between_them() {
        let config = search::Config { point_cache: 0, ..search::Config::default() };
        let core = pointcore_hdl::search::top::core(&config, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
        let svg = diagram(&core.module, &UNITS, &config);
        for shown in ["threads", "sieve", "Candidates", "QueryResult"] {
            assert!(svg.contains(shown), "{shown} is missing");
        }
        assert!(!svg.contains("point_cache"), "the core has none");
    }
}
