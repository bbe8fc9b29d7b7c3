//! What the tests of core A's models share.

use crate::unit::{Visitor, Word};
use fastrand::Rng;
use pointcore_spec::core_a::{Config, Port, ports};

/// Seeds of a randomized test.
pub const SEEDS: u64 = 5;

/// Runs a randomized test with `SEEDS` seeds from `POINTCORE_SEED` on, and prints the seed of a failure.
pub fn for_each_seed(name: &str, test: impl Fn(&mut Rng)) {
    let first = std::env::var("POINTCORE_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    for seed in first..first + SEEDS {
        println!("reproduce with POINTCORE_SEED={seed} cargo test -p pointcore-golden {name}");
        test(&mut Rng::with_seed(seed));
    }
}

/// The names of the fields visited.
#[derive(Default)]
pub struct Names(pub Vec<String>, &'static str);

impl Visitor for Names {
    fn field(&mut self, name: &str, _value: &mut impl Word) {
        self.0.push(format!("{}{name}", self.1));
    }

    fn fields(&mut self, name: &str, values: &mut [u32]) {
        self.0.extend((0..values.len()).map(|i| format!("{}{name}_{i}", self.1)));
    }

    fn prefix(&mut self, prefix: &'static str) {
        self.1 = prefix;
    }
}

mod port_lists {
    use super::*;
    use crate::core_a::*;
    use crate::unit::{Model, Record};
    use pointcore_spec::core_a::{Direction, Feature};

    fn check<M: Model>(model: &M, ports: &[Port]) {
        let listed = |direction| -> Vec<_> {
            ports.iter().filter(|port| port.direction == direction).map(|port| port.name.clone()).collect()
        };
        let mut inputs = Names(vec!["rst".to_owned()], "");
        M::In::default().visit(model.shape(), &mut inputs);
        assert_eq!(inputs.0, listed(Direction::Input));
        let mut outputs = Names::default();
        M::Out::default().visit(model.shape(), &mut outputs);
        assert_eq!(outputs.0, listed(Direction::Output));
    }

    #[test]
    fn every_record_follows_its_port_list() {
        let filterless = Config { continuous: 1, screen_filter: Feature::Off, ..Config::default() };
        let cardinal = Config { continuous: 0, cardinal: 14, ..Config::default() };
        for config in [Config::default(), filterless, cardinal] {
            let latencies = Latencies { transform: 1, setup: 1, rasterizer: 1, weighting: 1, normalizer: 1 };
            check(&Transform::new(&config, 1), &ports::transform(&config));
            check(&Setup::new(&config, 1), &ports::setup(&config));
            check(&Splitter::new(&config), &ports::splitter(&config));
            check(&Heap::new(&config), &ports::heap(&config));
            check(&Reorder::new(&config), &ports::reorder(&config));
            check(&TileCache::new(&config), &ports::tile_cache(&config));
            check(&Rasterizer::new(&config, 1), &ports::rasterizer(&config));
            check(&Weighting::new(&config, 1), &ports::weighting(&config));
            check(&DepthTest::new(&config), &ports::depth_test(&config));
            check(&Accumulator::new(&config), &ports::accumulator(&config));
            check(&Normalizer::new(&config, 1), &ports::normalizer(&config));
            check(&Top::new(&config, &latencies), &ports::top(&config));
        }
    }
}
