//! Leaf processing alone, recorded at the ports of its golden model: in the core its queues are hardly ever full, and of squared
//! distances only those show that are among the nearest.

use crate::generated::GenerateError;
use crate::number::encode;
use crate::recording::{Recorder, Recording};
use fastrand::Rng;
use pointcore_contract::search::records::{Beat, LeafVisit, Query, Start, Thread, TreeWrite};
use pointcore_contract::search::{Config, units};
use pointcore_contract::{Record, Words, fields, read};
use pointcore_golden::search::Leaf;
use pointcore_hdl::compiler::Options;
use pointcore_hdl::search::leaf;
use pointcore_tb::lockstep::{Stall, Stalls};
use rtl::{Design, elaborate};
use units::leaf::In;

/// In a round each thread takes up a query, and leaves and beats come for as many cycles.
const ROUNDS: u64 = 12;
const CYCLES: u64 = 300;
/// Entries of the leaf table that are used.
const LEAVES: u32 = 64;
/// How leaves, beats, requests and candidates are held back, round after round.
const PATTERNS: [[Stall; 4]; 3] = [
    [Stall::Never, Stall::Never, Stall::Varied, Stall::Varied],
    [Stall::Varied; 4],
    [Stall::Random(0.2), Stall::Never, Stall::Random(0.5), Stall::Random(0.2)],
];
/// Cycles beyond the latency until nothing is under way.
const SETTLING_CYCLES: u64 = 32;
/// Coordinates have magnitudes from the first to the last power of two.
const EXPONENTS: [i32; 2] = [-6, 6];

/// Records visits on leaf processing as it stands in a core, with a pipeline of so many stages; its design goes with the recording.
pub fn record_leaf(config: &Config, latency: u32) -> Result<(Design, Recording), GenerateError> {
    let design = elaborate(&leaf::datapath(config, &Options::default())?.module)?;
    let random = &mut Rng::with_seed(0);
    let mut recorder = Recorder::new(config, &units::leaf::UNIT, Leaf::new(config, latency));
    let leaves = LEAVES.min(1 << config.tree_depth);
    if config.tree_cache == 0 {
        for address in 0..leaves {
            let mut write: TreeWrite = noise(config, random);
            (write.is_leaf, write.address, write.bucket.beats) = (true, address, write.bucket.beats.max(1));
            recorder.step(&In { tree: Some(write), ..In::default() });
        }
    }
    for round in 0..ROUNDS {
        for thread in (0..config.threads as u8).map(|thread| Thread { thread }) {
            let point = [(); 3].map(|()| coordinate(config, random));
            let start = Start { thread, query: Query { point, ..noise(config, random) } };
            recorder.step(&In { start: Some(start), ..In::default() });
        }
        let patterns = PATTERNS[(round % PATTERNS.len() as u64) as usize];
        let [mut leaf_source, mut beat_source, mut fetch_sink, mut sink] =
            patterns.map(|pattern| Stalls::new(pattern, random.fork()));
        let (mut leaf, mut beat) = (None, None);
        for cycle in 0..CYCLES + u64::from(latency) + SETTLING_CYCLES {
            // What was offered stays until it is taken.
            if cycle < CYCLES && config.tree_cache == 0 && leaf.is_none() && !leaf_source.stalled() {
                leaf = Some(LeafVisit { thread: any_thread(config, random), leaf: random.u32(..leaves) });
            }
            if cycle < CYCLES && beat.is_none() && !beat_source.stalled() {
                beat = Some(points(config, random));
            }
            let is_over = cycle >= CYCLES;
            let (fetch_ready, candidates_ready) = (is_over || !fetch_sink.stalled(), is_over || !sink.stalled());
            let shown = recorder.step(&In { leaf, beat, fetch_ready, candidates_ready, ..In::default() });
            leaf = leaf.filter(|_| !shown.leaf_ready);
            beat = beat.filter(|_| !shown.beat_ready);
        }
    }
    Ok((design, recorder.into_recording()))
}

/// A record of random bits.
fn noise<R: Record<Domain = Words, Config = Config>>(config: &Config, random: &mut Rng) -> R {
    let words: Vec<_> = fields::<R>(config).iter().map(|field| random.u64(..) >> (u64::BITS - field.width)).collect();
    read(config, &words)
}

fn any_thread(config: &Config, random: &mut Rng) -> Thread {
    Thread { thread: random.u8(..config.threads as u8) }
}

/// A beat of some thread: points of all magnitudes, and in one of eight any bits.
fn points(config: &Config, random: &mut Rng) -> Beat {
    let mut beat: Beat = noise(config, random);
    beat.place.thread = any_thread(config, random);
    if random.u8(..8) != 0 {
        for point in &mut beat.points.lane[..config.lanes as usize] {
            *point = [(); 3].map(|()| coordinate(config, random));
        }
    }
    beat
}

fn coordinate(config: &Config, random: &mut Rng) -> u32 {
    let [low, high] = EXPONENTS;
    encode(config.geometry, (2.0 * random.f32() - 1.0) * (random.i32(low..=high) as f32).exp2())
}

#[cfg(test)]
mod tests {
    use super::super::SearchCore;
    use super::*;

    #[test]
    fn it_is_the_leaf_processing_of_the_core_and_all_that_comes_leaves() {
        let table = Config { threads: 3, lanes: 2, tree_depth: 4, ..Config::default() };
        let cached = Config { tree_cache: 16, ..table.clone() };
        for config in [table, cached] {
            let core = SearchCore::generate(&config).unwrap_or_else(|error| panic!("{error}"));
            let (design, recording) =
                record_leaf(&config, core.latencies().distance).unwrap_or_else(|error| panic!("{error}"));
            for module in design.files() {
                assert!(core.design.files().contains(module), "the core has another {}", module.0);
            }
            let moved = |name: &str| {
                let stream = design.streams().iter().find(|stream| stream.name == name);
                stream.map_or(0, |stream| recording.transfers(stream))
            };
            assert!(moved("beat") > 1000 && moved("beat") == moved("candidates"), "{}", moved("beat"));
            assert_eq!(moved("leaf"), moved("fetch"));
            assert!((moved("leaf") > 500) == (config.tree_cache == 0));
        }
    }
}
