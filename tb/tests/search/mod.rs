//! What the tests of the search core's units share.

pub mod environment;
pub mod memory;
pub mod neighborhoods;
pub mod tree;

use pointcore_contract::Format;
use pointcore_contract::Unit;
use pointcore_contract::search::Config;
use pointcore_golden::unit::{Model, Ported};
use pointcore_tb::lockstep::{Lockstep, LockstepReport, seeds};
use rtl::Module;

use environment::{Environment, Feeds, Rule};

use crate::support;

/// Few and many threads, every number of lanes, two formats, with short indices and shallow trees, without caches.
pub fn configs() -> [Config; 4] {
    let base = Config {
        geometry: Format::F32.flushed(),
        index_bits: 10,
        tree_depth: 4,
        bucket: 8,
        point_cache: 0,
        ..Config::default()
    };
    let f24 = Format::F24.flushed();
    [
        Config { threads: 1, neighbors: 5, lanes: 1, leaves_in_flight: 1, ..base.clone() },
        Config { threads: 3, neighbors: 8, lanes: 4, leaves_in_flight: 2, ..base.clone() },
        Config { threads: 16, neighbors: 4, lanes: 2, leaves_in_flight: 2, ..base.clone() },
        Config { threads: 16, neighbors: 1, lanes: 8, leaves_in_flight: 1, tree_depth: 3, geometry: f24, ..base },
    ]
}

/// Steps a unit and its model in lockstep under several seeds, its streams and pulses being those of the contract; `begin` queues the first items and makes the rule, `check`
/// looks at the rule and at what moved.
pub fn lockstep<M: Model + 'static, R: Rule>(
    config: &M::Config,
    module: &Module,
    model: &M,
    unit: &Unit<M::Config>,
    begin: impl Fn(&mut Feeds) -> R,
    mask: impl Fn(&mut [u64]) + Clone + Send + 'static,
    check: impl Fn(&R, &LockstepReport),
) {
    let library = support::verilate(module);
    let interface = (unit.interface)(config);
    support::check_streams(&library, &interface);
    let specified = interface.ports();
    for seed in seeds(R::SEEDS).unwrap() {
        let golden = support::by_name(&library, &specified, Ported::new(config, model.clone()));
        let mask = mask.clone();
        let run = Lockstep::new(&library, golden, seed).mask(move |hardware, golden| {
            mask(hardware);
            mask(golden);
        });
        let run = run.run(Environment::new(&library, seed, &begin));
        let run = run.unwrap_or_else(|error| panic!("{} with seed {seed}: {error}", module.unit()));
        check(&run.stimulus.rule, &run.report);
    }
}

/// Compares every output.
pub fn all(_outputs: &mut [u64]) {}

/// A kind of coordinates.
pub type Coordinate = fn(&mut fastrand::Rng) -> f32;

/// A coordinate on a coarse grid, so that distances tie.
pub fn coordinate(random: &mut fastrand::Rng) -> f32 {
    f32::from(random.i8(-12..=12)) / 4.0
}

/// A coordinate of which some are on that grid; the others have all the bits of a mantissa, and some of an exponent.
pub fn fine_coordinate(random: &mut fastrand::Rng) -> f32 {
    let fine = 3.0 - 6.0 * random.f32();
    match random.u8(..8) {
        0 | 1 => coordinate(random),
        2 => fine * f32::powi(2.0, random.i32(-70..70)),
        _ => fine,
    }
}

/// One close to the others at any scale: where they are nearest, only their last digits say how far they are apart.
pub fn close_coordinate(random: &mut fastrand::Rng) -> f32 {
    1.0 + random.f32() * f32::powi(0.5, random.i32(0..f32::MANTISSA_DIGITS as i32))
}

/// Its multiples have fractions that are spread evenly, and all the bits of a mantissa.
const GOLDEN: f32 = 0.618_034;

/// A squared distance of the format: most are one of a few, so that they tie, or all but do, or differ in a single bit;
/// of the few, half are round and half have all the bits of a mantissa, as have the others.
pub fn distance2(config: &Config, random: &mut fastrand::Rng) -> f32 {
    let round = f32::from(random.u8(..=12)) / 4.0;
    let dense = 3.0 * (f32::from(random.u8(1..=4)) * GOLDEN).fract();
    let grid = word(config, if random.bool() { round } else { dense });
    let near = grid ^ (random.u64(..) & ((1 << random.u32(..8)) - 1));
    let toggled = number(config, grid ^ 1 << random.u32(..config.geometry.width() - 1));
    match random.u8(..5) {
        0 => number(config, word(config, 3.0 * random.f32())),
        // Zero has no neighbor that is normal.
        1 if grid != 0 => number(config, near),
        2 if toggled.is_normal() => toggled,
        _ => number(config, grid),
    }
}

/// A squared radius, one of a few or like a distance.
pub fn radius2(config: &Config, random: &mut fastrand::Rng) -> f32 {
    let few = [f32::INFINITY, 9.0, 1.0, 0.01][random.usize(..4)];
    if random.bool() { few } else { distance2(config, random) }
}

/// The word of a number: what the format has no bits for is cut off.
pub fn word(config: &Config, number: f32) -> u64 {
    u64::from(number.to_bits() >> (f32::MANTISSA_DIGITS - 1 - config.geometry.mantissa))
}

/// The number of a word.
pub fn number(config: &Config, word: u64) -> f32 {
    f32::from_bits((word as u32) << (f32::MANTISSA_DIGITS - 1 - config.geometry.mantissa))
}

/// What makes up for the rounding of squares and roots where a neighborhood is said to reach so far.
pub fn safety(config: &Config) -> f32 {
    1.0 - 8.0 * 0.5_f32.powi(config.geometry.mantissa as i32)
}

/// Both scales of a neighbor cache, or smaller ones, which promise less.
pub fn cache_scales(config: &Config, margin_scale: f32, random: &mut fastrand::Rng) -> [u64; 2] {
    let mut smaller = || if random.bool() { 1.0 } else { 1.0 - 0.2 * random.f32() };
    [safety(config), margin_scale].map(|scale| word(config, scale * smaller()))
}

/// `start` for a thread, or without the thread `query`: number, k, squared radius, coordinates.
pub fn query(config: &Config, number: u64, random: &mut fastrand::Rng) -> Vec<u64> {
    query_at(fine_coordinate, config, number, random)
}

/// The same with coordinates of a kind.
pub fn query_at(coordinate: Coordinate, config: &Config, number: u64, random: &mut fastrand::Rng) -> Vec<u64> {
    let k = random.u64(1..=config.neighbors.into());
    let mut query = vec![number, k, word(config, radius2(config, random))];
    query.extend((0..3).map(|_| word(config, coordinate(random))));
    query
}

/// `start` for a thread.
pub fn start(config: &Config, thread: u64, number: u64, random: &mut fastrand::Rng) -> Vec<u64> {
    let mut start = vec![thread];
    start.extend(query(config, number, random));
    start
}
