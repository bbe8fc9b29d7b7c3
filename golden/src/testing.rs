//! What the tests of the cores' models share.

use fastrand::Rng;

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
