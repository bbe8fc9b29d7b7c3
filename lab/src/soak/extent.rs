//! How much a run has of everything, and what is hard in its frames.

use crate::stability::families::{LEVELS, case};
use crate::stability::family::Family;
use crate::stability::frames::uniforms;
use fastrand::Rng;
use pointcore::stimuli::{frames, renderer, searcher};
use pointcore_contract::splat::Config;
use pointcore_contract::splat::records::Splat;

/// Cycles that memory takes to answer, at most.
const LATENCY_CYCLES: u64 = 400;
/// Cycles within which a reset comes, in a run that has some.
const RESET_CYCLES: u64 = 30_000;

/// Of a renderer.
pub const RENDERER: renderer::Bounds =
    renderer::Bounds { frames: 4, splats: 120, latency_cycles: LATENCY_CYCLES, reset_cycles: RESET_CYCLES };

/// Of a search core.
pub const SEARCH: searcher::Bounds = searcher::Bounds {
    searches: 4,
    points: 300,
    queries: 60,
    latency_cycles: LATENCY_CYCLES,
    reset_cycles: RESET_CYCLES,
};

/// A random script of a renderer.
#[must_use]
pub fn renderer(config: &Config, random: &mut Rng) -> renderer::Script {
    renderer::Script::random(config, RENDERER, frames::Lens::whole(config), Some(HARD_CASES), random)
}

/// The hard cases of the stability campaign.
pub const HARD_CASES: frames::HardCases = frames::HardCases { splat, uniforms };

/// A case of any family and severity.
fn splat(config: &Config, random: &mut Rng) -> Splat {
    let families = Family::ALL;
    let (family, level) = (families[random.usize(..families.len())], random.u8(..LEVELS));
    case(family, level, config.geometry, random.u64(..)).splat
}
