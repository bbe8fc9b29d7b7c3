//! How long a core may be silent: from its parameters, twice what its slowest work without a transfer takes.

use pointcore::stimuli::trees::RandomTree;
use pointcore_contract::splat::config::{PLACED_QUEUE_DEPTH, SAMPLE_QUEUE_DEPTH, TILE_PIXELS};
use pointcore_contract::{search, splat};
use pointcore_golden::{search as search_model, splat as splat_model};

/// What is left to chance: bounds are so many times what they would be.
const SLACK: u64 = 2;
/// Cycles from an item to the next in what is not a pipeline of its own: queues, handshakes, look-ups.
const STEP_CYCLES: u64 = 8;

/// Cycles in which a renderer may move nothing while every stream is free.
///
/// Copies whose tiles are in the cache ask for nothing: all that wait for their turn, and those of the splats behind it, one for
/// each slot. Each visits the pixels of its tile, and waits before one for the sample before it. The flush looks at
/// every tile's code, and at the pixels of those in the cache.
#[must_use]
pub fn renderer(config: &splat::Config, latencies: &splat_model::Latencies) -> u64 {
    let pixels = u64::from(TILE_PIXELS);
    let splats = u64::from(latencies.transform + latencies.setup) + STEP_CYCLES;
    let waiting = u64::from(config.pointers() + PLACED_QUEUE_DEPTH + SAMPLE_QUEUE_DEPTH);
    // In the rasterizer no more than stages.
    let waiting = waiting + u64::from(latencies.rasterizer) + STEP_CYCLES;
    let copies = waiting + splats * u64::from(config.tile_slots);
    let copy = pixels + u64::from(config.accumulate_stages + config.heap_interval + config.payload_beats) + STEP_CYCLES;
    let pipelines = u64::from(latencies.rasterizer + latencies.weighting + latencies.normalizer) + splats * 16;
    // After reset the lists clear what they know of every tile, and payloads what they know of every place.
    let flush = (pixels + 2 * STEP_CYCLES) * config.buffer_tiles() as u64;
    SLACK * (pipelines + copies * copy + flush + u64::from(config.splats_held()))
}

/// Cycles in which a search core may move nothing while every stream is free.
///
/// Where caches have everything, each search visits every node and compares every point, and each point may be inserted
/// into a queue. After reset the tree cache clears its lines; a query is compared with every neighborhood.
#[must_use]
pub fn search_core(config: &search::Config, latencies: &search_model::Latencies, tree: &RandomTree) -> u64 {
    let lanes = u64::from(config.lanes);
    let node = u64::from(latencies.path) + STEP_CYCLES;
    let beat = lanes * (u64::from(config.neighbors) + STEP_CYCLES);
    let leaf = u64::from(latencies.distance) + STEP_CYCLES;
    let search = tree.writes.len() as u64 * (node + leaf) + tree.beats() * beat;
    let check = latencies.neighbor_cache.map_or(0, |latencies| u64::from(latencies.check + latencies.cover));
    let compared = u64::from(config.neighbor_cache) * STEP_CYCLES + check;
    SLACK * (u64::from(config.tree_cache) + u64::from(config.tickets()) * (search + compared))
}
