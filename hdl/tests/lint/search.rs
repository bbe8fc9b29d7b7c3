//! The search core, with its parts and without them, passes through every tool.

use pointcore_contract::search::Config;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::search::top;
use rtl::elaborate;

use crate::lint::lint;

#[test]
fn tools_accept_search_with_and_without_its_parts() {
    let base = Config { index_bits: 10, tree_depth: 4, bucket: 8, neighbors: 4, ..Config::default() };
    for config in [
        Config { point_cache: 0, ..base.clone() },
        Config { point_cache: 4, lanes: 2, threads: 1, ..base.clone() },
        Config { neighbor_cache: 1, threads: 2, ..base.clone() },
        Config { tree_cache: 16, neighbor_cache: 3, lanes: 8, threads: 3, ..base },
    ] {
        let core = top::core(&config, &Options::default()).unwrap_or_else(|error| panic!("{error}"));
        lint(&elaborate(&core.module).unwrap_or_else(|error| panic!("{error}")));
    }
}
