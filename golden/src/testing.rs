//! What the tests of the cores' models share.

use crate::unit::{Model, Record, Visitor, Word};
use fastrand::Rng;
use pointcore_contract::splat::{Direction, Port};

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

    fn fields(&mut self, name: &str, values: &mut [impl Word]) {
        self.0.extend((0..values.len()).map(|i| format!("{}{name}_{i}", self.1)));
    }

    fn prefix(&mut self, prefix: &'static str) {
        self.1 = prefix;
    }
}

/// Checks that a model's records have the fields of its port list, in its order.
pub fn check_ports<M: Model>(model: &M, ports: &[Port]) {
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
