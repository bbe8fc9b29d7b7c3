//! What the tests of the process core's units share: configurations, and items of random words.

use super::block;
pub use super::block::{tame, within};
use fastrand::Rng;
use pointcore_contract::process::library::{PROGRAMS, program};
use pointcore_contract::process::{Config, Program};
use pointcore_contract::{Format, Record, fields};
use std::sync::Arc;

/// Looks at the farthest neighbor, and does what the library does not.
const FARTHEST: &str = include_str!("farthest.pasm");
/// Between which powers of two settings are: coordinates are less than one.
const SETTINGS: [f64; 2] = [-8.0, 4.0];

/// Without and with `init`, and with one that looks at the farthest neighbor; few and many threads and neighbors.
pub fn configs() -> [Config; 4] {
    let config = |program, threads, neighbors| Config {
        program: Arc::new(program),
        format: Format::F32.flushed(),
        index_bits: 12,
        neighbors,
        threads,
        rate: 1,
        line_points: 4,
        cache_lines: 8,
    };
    let farthest = Program::parse("farthest.pasm", FARTHEST).unwrap_or_else(|error| panic!("{error}"));
    [
        config(program("smooth"), 1, 5),
        config(program("mls"), 6, 1),
        Config { format: Format::F24.flushed(), rate: 2, ..config(farthest, 16, 8) },
        config(program("resample"), 7, 64),
    ]
}

/// Every program of the library and one that does what those do not, with few and many threads and neighbors, in all formats, at
/// several rates.
pub fn every_program() -> Vec<Config> {
    let [f32, f24] = [Format::F32, Format::F24];
    let shapes = [(2, 9, f32.flushed(), 1), (5, 64, f24, 2), (16, 16, f32, 1), (32, 8, f24.flushed(), 3)];
    let [base, _, farthest, _] = configs();
    let library = PROGRAMS.iter().zip(shapes.into_iter().cycle()).map(|((name, _), shape)| {
        let (threads, neighbors, format, rate) = shape;
        Config { program: Arc::new(program(name)), threads, neighbors, format, rate, ..base.clone() }
    });
    library.chain([farthest]).collect()
}

/// Settings of a run: a `radius` holds nothing of a cloud, or all of it.
pub fn settings(program: &Program, format: Format, random: &mut Rng) -> Vec<u32> {
    block::settings(program, format, random, |random| (SETTINGS[0] + random.f64() * (SETTINGS[1] - SETTINGS[0])).exp2())
}

/// A query's number: the step is odd, so that numbers have all their bits and none comes twice.
pub fn number(config: &Config, index: u64) -> u64 {
    index.wrapping_mul(0x9e37_79b1) & ((1 << config.index_bits) - 1)
}

/// An item of a stream that begins with `first`; what is behind is random.
pub fn item<R: Record>(config: &R::Config, first: &[u64], random: &mut Rng) -> Vec<u64> {
    let widths = fields::<R>(config).into_iter().map(|field| field.width);
    let word = |(index, width)| first.get(index).copied().unwrap_or_else(|| random.u64(..) >> (64 - width));
    widths.enumerate().map(word).collect()
}

/// The place of a field of that name in an item.
pub fn place<R: Record>(config: &R::Config, name: &str) -> usize {
    let place = fields::<R>(config).iter().position(|field| field.name == name);
    place.unwrap_or_else(|| panic!("no field {name}"))
}

/// The word of a field of that name in an item.
pub fn field<R: Record>(config: &R::Config, item: &[u64], name: &str) -> u64 {
    item[place::<R>(config, name)]
}
